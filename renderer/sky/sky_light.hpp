// Sun and Moon as lights of the air.
#pragma once

#include "vesper/base/vector.hpp"
#include "vesper/light/spectrum.hpp"
#include "vesper/sky/sky_state.hpp"

#include <string>
#include <vector>

namespace vesper {

/// A light so far away that it looks the same from all of the air.
struct SkyLight {
  std::string name; ///< "sun" or "moon"
  Vec3 direction;   ///< towards its centre, without refraction: horizon frame
  Angle angular_radius;
  Spectrum irradiance; ///< above the air, W/(m2 nm)
};

[[nodiscard]] SkyLight sun_light(const Vec3& direction, Length distance);
/// Lit by the Sun alone.
/// \param phase_angle 0 to 180 degrees
[[nodiscard]] SkyLight moon_light(const Vec3& direction, Length distance, Length from_sun, Angle phase_angle);

/// Spectral irradiance of the Sun at the observer above the air, W/(m2 nm): in an eclipse what the Moon leaves of it.
/// moonlight_of() in moon_illumination.hpp is the same of the Moon.
[[nodiscard]] Spectrum sunlight_of(const SkyState& sky);

/// Luminance that a light gives the zenith in twilight, cd/m2 over its lux above the air: within a factor of 3 from 0
/// to 18 degrees (fitted to the reference transport in clear air). \param depth below the horizon, 0 or more
[[nodiscard]] double zenith_in_twilight(Angle depth);

/// Sun and Moon of a scene at their airless places: straight rays from there bring a level surface as much as bent ones
/// do, because what falls on the air above it is the same. Left out is what stands so deep that it gives the zenith
/// less than 1e-4 of the darkest night: the Sun some 23 degrees below the observer's horizon, the full Moon 11.
/// Eclipses dim them (eclipse_light.hpp): the Sun as it is seen by the observer, or as it shines on air far away from
/// the Moon's shadow, for a sky that is dimmed place by place (EclipsedSky).
enum class SunInEclipse { as_observed, outside_the_shadow };
/// \param moonlight moonlight_of() the scene, where it is known
[[nodiscard]] std::vector<SkyLight> lights_of(const SkyState& sky, SunInEclipse sun, const Spectrum& moonlight);
[[nodiscard]] std::vector<SkyLight> lights_of(const SkyState& sky, SunInEclipse sun = SunInEclipse::as_observed);

/// A light over the tables of the sky: what turns their X, Y, Z, S (above 1 lux of sunlight) into those above this
/// light.
[[nodiscard]] Mat4 from_table_light(const SkyLight& light);

/// The observer's height above the medium's ground: that above the ellipsoid, and 0 in places below it.
[[nodiscard]] Length height_in_air(const Observer& observer);

} // namespace vesper
