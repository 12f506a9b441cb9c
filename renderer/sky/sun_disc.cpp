#include "vesper/sky/sun_disc.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/light/corona.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/sky/corona_streamers.hpp"
#include "vesper/sky/sky_light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

static_assert(f64::sun_terms == limb_terms);
// The layout of a std140 block.
static_assert(sizeof(f32::SunShading) == sizeof(float) * (4 * 4 + 4 * f32::sun_terms + 2 * 4 + 4 * f32::sun_streamers));

/// Along ICRS axes: right ascension 286.13, declination 63.87 degrees (Archinal et al. 2018, Celestial Mechanics and
/// Dynamical Astronomy 130, 22).
Vec3 solar_north_pole() {
  const double right_ascension = (286.13 * deg).to(rad);
  const double declination = (63.87 * deg).to(rad);
  return {std::cos(declination) * std::cos(right_ascension), std::cos(declination) * std::sin(right_ascension),
          std::sin(declination)};
}

f64::vec4 luminance(const Xyzs& light, double solid_angle) {
  return f64::vec4(light.x, light.y, light.z, light.s) / solid_angle;
}

Spectrum reddened_by_dust(const Spectrum& light) {
  std::vector<double> values = light.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] *= dust_reddening(light.wavelengths_nm()[i]);
  }
  return {light.wavelengths_nm(), std::move(values)};
}

} // namespace

SunDisc sun_disc(const SkyState& sky, const SunOptions& options) {
  const SkyLight light = sun_light(sky.sun.direction_horizon, sky.sun.distance);
  SunDisc sun{light.direction, sky.sun.distance, light.angular_radius, {}, light.irradiance};
  f64::SunShading& shading = sun.shading;
  shading.direction = sun.direction;
  shading.sin_radius = std::sin(sun.angular_radius.to(rad));
  const Vec3 pole = sky.stars.horizon_from_icrs * solar_north_pole();
  shading.upward = glm::normalize(pole - glm::dot(pole, sun.direction) * sun.direction);
  shading.aside = glm::cross(sun.direction, shading.upward);
  shading.moon_direction = sky.moon.place.direction_horizon;
  shading.moon_chord = 2.0 * std::sin(0.5 * sky.solar_eclipse.moon_semidiameter.to(rad));

  const LimbPowers powers = limb_powers(options.law);
  shading.lowest_power = powers.lowest;
  shading.power_step = powers.step;
  const double solid_angle = pi * shading.sin_radius * shading.sin_radius;
  const std::array<Xyzs, limb_terms> terms = limb_xyzs(sun.irradiance, options.law);
  for (std::size_t k = 0; k < limb_terms; ++k) {
    shading.limb[k] = luminance(terms.at(k), solid_angle);
  }
  shading.k_corona = corona_unit() * luminance(integrate_xyzs(sun.irradiance), solid_angle);
  shading.f_corona = corona_unit() * luminance(integrate_xyzs(reddened_by_dust(sun.irradiance)), solid_angle);
  if (options.streamers) {
    const auto streamers = corona_streamers(options.activity.value_or(solar_activity(sky.instant)), options.seed);
    std::copy(streamers.begin(), streamers.end(), std::begin(shading.streamers));
  }
  return sun;
}

f32::SunShading single_precision(const f64::SunShading& shading) {
  f32::SunShading single{shading.direction,
                         float(shading.sin_radius),
                         shading.upward,
                         float(shading.lowest_power),
                         shading.aside,
                         float(shading.power_step),
                         shading.moon_direction,
                         float(shading.moon_chord),
                         {},
                         shading.k_corona,
                         shading.f_corona,
                         {}};
  std::copy(std::begin(shading.limb), std::end(shading.limb), std::begin(single.limb));
  std::copy(std::begin(shading.streamers), std::end(shading.streamers), std::begin(single.streamers));
  return single;
}

double solar_activity(const Instant& instant) {
  constexpr double minimum_years = 19.96; // since J2000.0
  constexpr double cycle_years = 11.0;
  const double years = instant.tt.days_since(j2000<TT>) / days_per_julian_year - minimum_years;
  return 0.5 - 0.5 * std::cos(2.0 * pi * years / cycle_years);
}

} // namespace vesper
