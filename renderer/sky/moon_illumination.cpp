#include "vesper/sky/moon_illumination.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/sky/eclipse_light.hpp"

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

Vec3 towards(const Selenographic& place) { return unit_vector(place.longitude.to(rad), place.latitude.to(rad)); }

} // namespace

MoonIllumination moon_illumination(const SkyState& sky, EarthPhaseLaw law) {
  const LunarEclipseState& shadow = sky.lunar_eclipse; // has both bodies from the Earth's centre
  const Vec3 sun_km = -shadow.sun_distance.to(kilometre) * shadow.axis;
  const Length sun_distance = glm::length(sun_km - shadow.moon_km) * kilometre;
  const Length earth_distance = glm::length(shadow.moon_km) * kilometre;
  const Angle earth_phase = angle_between(sun_km, shadow.moon_km);
  const Angle phase_of_earthlight =
      earthlight_phase(angle_between(towards(sky.moon.libration), towards(sky.moon.geocentric_libration)),
                       std::asin(earth_mean_radius / earth_distance) * rad);
  const Length distance = sky.moon.place.distance;
  return {sun_distance,
          earth_distance,
          earth_phase,
          phase_of_earthlight,
          earth_irradiance(earth_phase, earth_distance, shadow.sun_distance, law),
          moon_irradiance(sky.moon.phase_angle, distance, sun_distance),
          filtered(moon_irradiance(phase_of_earthlight, distance, shadow.sun_distance),
                   earthlight_share(earth_phase, earth_distance, law))};
}

Spectrum moonlight_of(const SkyState& sky, const MoonIllumination& illumination) {
  const Spectrum& sunlit = illumination.sunlit_moon;
  const bool eclipsed = sky.lunar_eclipse.penumbral_magnitude > 0.0;
  return added(eclipsed ? filtered(sunlit, sunlight_on_moon(sky.lunar_eclipse, sky.eclipse_air, sky.tier)) : sunlit,
               illumination.earthlit_moon);
}

MoonBrightness moon_brightness(const Spectrum& irradiance, Length distance) {
  const Xyzs illuminance = integrate_xyzs(irradiance);
  const double solid_angle_sr = std::numbers::pi * std::pow(moon_mean_radius / distance, 2);
  return {illuminance, v_magnitude(irradiance), illuminance.y / solid_angle_sr * candela_per_m2};
}

Spectrum moonlight_of(const SkyState& sky) { return moonlight_of(sky, moon_illumination(sky)); }

} // namespace vesper
