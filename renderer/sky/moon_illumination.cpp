#include "vesper/sky/moon_illumination.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/moon_samples.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace vesper {
namespace {

/// Where the Moon's light comes from without an eclipse: what the shadow lays over highlands costs more light than over
/// maria.
std::vector<MoonPlace> sunlit_face(const SkyState& sky) {
  static const MoonSamples samples = sample_moon(default_moon_map(), 4096);
  f64::MoonLighting lighting{};
  lighting.to_sun = direction_of(sky.moon.subsolar);
  lighting.sun_law = lunar_law(sky.moon.phase_angle);
  lighting.sun_radius_rad = std::asin(sun_radius / sky.lunar_eclipse.sun_distance);
  const Vec3 observer = sky.moon.place.distance / moon_mean_radius * direction_of(sky.moon.libration);
  const Mat3 icrs_from_moon_fixed = glm::transpose(sky.moon.moon_fixed_from_icrs);
  std::vector<MoonPlace> face;
  double sum = 0.0;
  for_sunlit(samples, observer, lighting, [&](const MoonSample& sample, double light) {
    face.push_back({icrs_from_moon_fixed * Vec3(sample.normal), light});
    sum += light;
  });
  for (MoonPlace& place : face) {
    place.share /= sum;
  }
  return face;
}

} // namespace

MoonIllumination moon_illumination(const SkyState& sky) {
  const EarthPhaseLaw law = sky.tier == Tier::cheap ? EarthPhaseLaw::polynomial : EarthPhaseLaw::measured;
  const LunarEclipseState& shadow = sky.lunar_eclipse; // has both bodies from the Earth's centre
  const Vec3 sun_km = -shadow.sun_distance.to(kilometre) * shadow.axis;
  const Length sun_distance = glm::length(sun_km - shadow.moon_km) * kilometre;
  const Length earth_distance = glm::length(shadow.moon_km) * kilometre;
  const Angle earth_phase = angle_between(sun_km, shadow.moon_km);
  const Angle phase_of_earthlight =
      earthlight_phase(angle_between(direction_of(sky.moon.libration), direction_of(sky.moon.geocentric_libration)),
                       std::asin(earth_mean_radius / earth_distance) * rad);
  const Length distance = sky.moon.place.distance;
  std::optional<Spectrum> past_earth;
  if (shadow.penumbral_magnitude > 0.0) {
    past_earth = sunlight_on_moon(shadow, sunlit_face(sky), sky.eclipse_air, sky.tier);
  }
  return {sun_distance,
          earth_distance,
          earth_phase,
          phase_of_earthlight,
          earth_irradiance(earth_phase, earth_distance, shadow.sun_distance, law),
          moon_irradiance(sky.moon.phase_angle, distance, sun_distance),
          filtered(moon_irradiance(phase_of_earthlight, distance, shadow.sun_distance),
                   earthlight_share(earth_phase, earth_distance, law)),
          std::move(past_earth)};
}

Spectrum moonlight_of(const MoonIllumination& illumination) {
  const Spectrum& sunlit = illumination.sunlit_moon;
  return added(illumination.past_earth ? filtered(sunlit, *illumination.past_earth) : sunlit,
               illumination.earthlit_moon);
}

Spectrum moonlight_of(const SkyState& sky) { return moonlight_of(moon_illumination(sky)); }

MoonBrightness moon_brightness(const Spectrum& irradiance, Length distance) {
  const Xyzs illuminance = integrate_xyzs(irradiance);
  const double solid_angle_sr = std::numbers::pi * std::pow(moon_mean_radius / distance, 2);
  return {illuminance, v_magnitude(irradiance), illuminance.y / solid_angle_sr * candela_per_m2};
}

} // namespace vesper
