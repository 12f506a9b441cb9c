// What the air takes from the light of stars of any colour at any altitude, for one observer.
#pragma once

#include "vesper/astro/refraction.hpp"
#include "vesper/atmosphere/medium.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace vesper {

/// A table over the apparent altitude and a star's colour to the shares of X, Y, Z and S that reach the observer, each
/// the integral of a black body's light through the medium over the one without it. Immutable; star_extinction and
/// shaders/lib/extinction.glsl read it.
///
/// Rows crowd towards the refracted, dipped horizon. Columns are the black bodies of star_color, B-V from -0.4 to 6,
/// and a star finds its own by ln(Z/Y) of its colour. For black bodies each of X, Y, Z and S is within 0.1 % of the
/// integral above 5 degrees and 1.1 % down to the horizon.
///
/// Light that is no black body's is dimmed as that of the same ln(Z/Y): sunlight, Venus, Mars, Jupiter and Saturn are
/// then within 2.5 % above 5 degrees and 7 % at the horizon. Uranus and Neptune, dark in the red as no black body is,
/// are within 5.5 % and 25 %; low as that they cannot be seen.
struct StarExtinction {
  f64::StarExtinctionFrame frame{}; ///< how the table is read
  std::vector<Vec4> texels;         ///< logarithms of the shares, row by row
};

/// \param height of the observer above the ground of the medium
/// \param bending what bends the rays, at the same height; straight without. Refraction has the path belong to the
///        apparent altitude and makes it longer by 8 % at the horizon than that of a straight ray there.
/// Throws Error(argument) as RefractedColumns does.
[[nodiscard]] StarExtinction make_star_extinction(const Medium& medium, Length height,
                                                  const std::optional<RefractionConditions>& bending);

/// The same for light that began as sunlight: the Sun's disc to its limb, the Moon by day and night, eclipsed or not.
/// Columns are sunlight times powers of the wavelength from -4 to 20. For the full Moon's light each of X, Y, Z and S
/// is within 0.6 % of the integral above 5 degrees and 3 % down to 1 degree.
[[nodiscard]] StarExtinction make_sunlight_extinction(const Medium& medium, Length height,
                                                      const std::optional<RefractionConditions>& bending);

[[nodiscard]] f64::sampler2D star_extinction_sampler(const StarExtinction& table);

/// The shares that are left of X, Y, Z and S.
/// \param sin_altitude sine of the apparent altitude
/// \param light X, Y, Z, S in any unit; only its colour counts
[[nodiscard]] Vec4 star_extinction(const StarExtinction& table, double sin_altitude, const Vec4& light);

} // namespace vesper
