#include "vesper/sky/scene_white.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/sky/moon_illumination.hpp"
#include "vesper/sky/sky_light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesper {
namespace {

/// Of airglow, zodiacal light and stars on the ground, 0.6 to 1 mlx; rods see it, which have no white.
constexpr double night_sky_lux = 1.0e-3;

Vec3 lux_of(const Spectrum& light) {
  const Xyzs all = integrate_xyzs(light);
  return {all.x, all.y, all.z};
}

} // namespace

double share_on_level_ground(Angle altitude) {
  // An even sky of the zenith's luminance in twilight; by day what comes with the Sun itself is added.
  const double by_day = 0.96 * std::pow(std::max(std::sin(altitude.to(rad)), 0.0), 1.4);
  return by_day + std::numbers::pi * zenith_in_twilight(std::max(-altitude, 0.0 * deg));
}

Vec3 adapting_light(const SkyState& sky) {
  // In an eclipse of the Sun the sky is lit from beyond the Moon's shadow.
  const Vec3 sun = lux_of(sun_light(sky.sun.direction_horizon, sky.sun.distance).irradiance);
  // In one of the Moon there is less of its light, of the same white.
  const MoonIllumination illumination = moon_illumination(sky);
  const Vec3 full = lux_of(illumination.sunlit_moon);
  const Vec3 moon = lux_of(moonlight_of(illumination)).y / std::max(full.y, 1.0e-30) * full;
  const Vec3 night = night_sky_lux * f64::xyz_of_chromaticity(f64::chromaticities_of(f64::primaries_srgb).white);
  return share_on_level_ground(latitude_of(sky.sun.direction_horizon)) * sun +
         share_on_level_ground(latitude_of(sky.moon.place.direction_horizon)) * moon + night;
}

} // namespace vesper
