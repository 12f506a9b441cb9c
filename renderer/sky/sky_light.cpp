#include "vesper/sky/sky_light.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/moon_illumination.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

Angle angular_radius(Length radius, Length distance) { return std::asin(radius / distance) * rad; }

/// Whether a light could give the zenith 1e-4 of the darkest night's 1.7e-4 cd/m2.
bool lights_the_air(const SkyLight& light, Length height) {
  constexpr Length ground = 6371.0 * kilometre; // the dip is needed within a degree
  const Angle dip = std::acos(ground / (ground + height)) * rad;
  const Angle depth = std::max(-(latitude_of(light.direction) + dip), 0.0 * deg);
  return integrate_xyzs(light.irradiance).y * zenith_in_twilight(depth) > 1.7e-8;
}

} // namespace

double zenith_in_twilight(Angle depth) { return std::pow(10.0, -2.5 - 0.45 * depth.to(deg)); }

SkyLight sun_light(const Vec3& direction, Length distance) {
  return {"sun", direction, angular_radius(sun_radius, distance),
          scaled(solar_irradiance_1au(), std::pow(astronomical_unit / distance, 2))};
}

SkyLight moon_light(const Vec3& direction, Length distance, Length from_sun, Angle phase_angle) {
  return {"moon", direction, angular_radius(moon_mean_radius, distance),
          moon_irradiance(phase_angle, distance, from_sun)};
}

Spectrum sunlight_of(const SkyState& sky) {
  const Spectrum whole = sun_light(sky.sun.direction_horizon, sky.sun.distance).irradiance;
  return sky.solar_eclipse.magnitude > 0.0 ? filtered(whole, sunlight_past_moon(sky.solar_eclipse)) : whole;
}

std::vector<SkyLight> lights_of(const SkyState& sky, SunInEclipse sun, const Spectrum& moonlight) {
  const BodyPlace& moon = sky.moon.place;
  std::vector<SkyLight> lights{
      sun_light(sky.sun.direction_horizon, sky.sun.distance),
      {"moon", moon.direction_horizon, angular_radius(moon_mean_radius, moon.distance), moonlight}};
  if (sun == SunInEclipse::as_observed) {
    lights[0].irradiance = sunlight_of(sky);
  }
  const Length height = height_in_air(sky.observer);
  std::erase_if(lights, [&](const SkyLight& light) { return !lights_the_air(light, height); });
  return lights;
}

std::vector<SkyLight> lights_of(const SkyState& sky, SunInEclipse sun) {
  return lights_of(sky, sun, moonlight_of(sky));
}

Mat4 from_table_light(const SkyLight& light) {
  const double all = integrate_xyzs(light.irradiance).y;
  return all > 0.0 ? all * response_matrix(solar_irradiance_1au(), light.irradiance) : Mat4(0.0);
}

Length height_in_air(const Observer& observer) { return std::max(observer.height, 0.0 * metre); }

} // namespace vesper
