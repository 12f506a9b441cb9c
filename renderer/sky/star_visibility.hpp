// Which stars are seen, and why others are not.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/sky/sky_background.hpp"

#include <string_view>

namespace vesper {

/// A point of light as it reaches the eye.
struct StarLight {
  Vec4 at_the_eye{};      ///< X, Y, Z, S in lux for 1 lux above the air
  double lux_ratio = 1.0; ///< over that of an A0 star, as in photometry.hpp
};

/// A star of B-V = 0.7, which limits are given for unless a star is named.
/// \param share what the air leaves of its X, Y, Z and S
[[nodiscard]] StarLight usual_star(const Vec4& share);

/// Magnitude V above the air of the faintest star that is seen in a place of the sky, by Crumey's law
/// (shaders/lib/visibility.glsl), by an eye adapted to that place.
/// \param background X, Y, Z, S in cd/m2, >= 0
/// \param field_factor of the observer, > 0: the less, the keener
/// -infinity where nothing of the light comes through.
[[nodiscard]] double limiting_magnitude(const Vec4& background, const StarLight& star,
                                        double field_factor = f64::default_field_factor);

/// What keeps a star from being seen: without it, it would be.
enum class Hidden { no, below_horizon, by_daylight, by_twilight, by_moonlight, by_sky_glow, low_in_the_air, too_faint };
/// "below the horizon", "in daylight", ...; "visible"
[[nodiscard]] std::string_view name_of(Hidden hidden);

struct StarSight {
  double limiting_magnitude = 0.0; ///< for a star of its light in its place
  Hidden hidden = Hidden::no;
};

/// Where a star stands, for its sight.
struct StarView {
  double magnitude = 0.0; ///< V above the air
  Angle altitude;         ///< as it is seen, refracted
  StarLight light;
  StarLight in_zenith; ///< the same light, if it stood there
};

/// Of a star that is not seen, what hides it is the first of these that, taken away, would show it: the Sun's light in
/// the air, the Moon's, that of cities; all of them together, of which the brightest is named then; the air that it
/// stands lower in than the zenith, unless those lights would hide it there too. Else it is too faint.
/// \param horizon altitude of the horizon as it is seen
[[nodiscard]] StarSight star_sight(const StarView& star, const SkyBackground& background, Angle sun_altitude,
                                   Angle horizon, double field_factor = f64::default_field_factor);

} // namespace vesper
