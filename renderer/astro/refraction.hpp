// Astronomical refraction: from airless to apparent altitudes and back, by a formula or a table of traced rays.
#pragma once

#include "vesper/astro/air_profile.hpp"
#include "vesper/astro/tier.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace vesper {

/// How starlight is bent.
enum class RefractionModel {
  none,
  published, ///< Saemundsson's formula: within 0.2' of traced rays above 5 degrees, 0.7' down to the horizon
  traced,    ///< a table for the given conditions
};

/// Refraction for one observer, light of one wavelength and every altitude, traced once. Immutable; the functions below
/// and shaders/lib/refraction.glsl read it.
///
/// Against rays traced finely: within 0.02" above 10 degrees and 0.5" down to the horizon (1" around 12 km, where rays
/// graze the tropopause), for -0.4 to 9 km, 500 to 1060 hPa, -40 to 45 C and 440 to 680 nm. Below the horizon, where
/// the ground hides all light from the sky, refraction goes on smoothly and vanishes at the nadir. Altitudes stay in
/// their order, and going there and back leads back within 0.01" up to 9 km, 0.5" above the tropopause.
struct RefractionTable {
  RefractionConditions conditions;
  Angle horizon;                ///< apparent altitude of the ray that grazes the ground, <= 0
  f64::RefractionFrame frame{}; ///< how the table is read
  std::vector<Vec4> texels;     ///< see shaders/lib/refraction.glsl
};

/// Traces 97 rays: 0.7 ms. Throws Error(argument) for conditions out of range.
[[nodiscard]] RefractionTable make_refraction_table(const RefractionConditions& conditions);

/// Altitude at which a source is seen whose altitude without air is given, -90 to 90 degrees.
[[nodiscard]] Angle apparent_altitude(Angle true_altitude, const RefractionTable& table);
/// The inverse.
[[nodiscard]] Angle true_altitude(Angle apparent_altitude, const RefractionTable& table);

/// What bends light in a scene. A default-constructed one bends nothing.
struct Refraction {
  RefractionModel model = RefractionModel::none;
  RefractionConditions conditions;
  std::shared_ptr<const RefractionTable> table; ///< for `traced`; what needs one makes its own from the conditions
};

/// Above it no air is left that bends light.
inline constexpr Length highest_refraction = 100.0 * kilometre;

/// What a tier bends light by in the standard atmosphere at a height, without a table: the published formula in the
/// cheap tier, else traced rays; nothing above `highest_refraction`.
[[nodiscard]] Refraction standard_refraction(Length height, Tier tier);

/// A refraction with the table that its model needs. Throws Error(argument) for conditions out of range.
[[nodiscard]] Refraction with_table(Refraction refraction);

/// In the form that shaders/lib/refraction.glsl takes. Throws Error(argument), as all that follow, for a `traced`
/// refraction without its table.
/// \param wavelength_nm of the light if not the table's own: the table is then scaled by the ratio of refractivities,
///        which costs 0.02" above 10 degrees and 2" at the horizon over 440 to 680 nm from a table for 555 nm;
///        without meaning for the published formula
[[nodiscard]] f64::RefractionFrame refraction_frame(const Refraction& refraction,
                                                    std::optional<double> wavelength_nm = std::nullopt);
[[nodiscard]] f64::sampler1D refraction_sampler(const Refraction& refraction);
[[nodiscard]] f64::sampler1D refraction_sampler(const RefractionTable& table);

/// Direction in the horizon frame in which a source is seen, and the direction without air of what is seen.
[[nodiscard]] Vec3 apparent_direction(const Vec3& true_direction, const Refraction& refraction);
[[nodiscard]] Vec3 true_direction(const Vec3& apparent_direction, const Refraction& refraction);

/// Apparent altitude of the sea's horizon from a height: 0 at sea level and below, else the dip (negative), refracted
/// as the model has it. For the published formula the bent horizon's distance is that of an Earth 1/(1 - 0.17) times
/// as large, the average of terrestrial refraction.
[[nodiscard]] Angle horizon_altitude(const Refraction& refraction, Length height);

} // namespace vesper
