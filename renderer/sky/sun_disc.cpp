#include "vesper/sky/sun_disc.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/light/corona.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/corona_streamers.hpp"
#include "vesper/sky/sky_light.hpp"

#include <algorithm>
#include <array>
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
Vec3 solar_north_pole() { return unit_vector((286.13 * deg).to(rad), (63.87 * deg).to(rad)); }

/// What does not change with the Sun's distance: luminances.
struct SunLuminance {
  std::array<f64::vec4, limb_terms> limb;
  f64::vec4 k_corona;
  f64::vec4 f_corona;
};

SunLuminance luminance_of_sun(LimbDarkening law) {
  const Spectrum& light = solar_irradiance_1au();
  const double solid_angle = pi * std::pow(sun_radius / astronomical_unit, 2);
  const auto luminance = [&](const Xyzs& lux) { return vector_of(lux) / solid_angle; };
  std::vector<double> reddened = light.values();
  for (std::size_t i = 0; i < reddened.size(); ++i) {
    reddened[i] *= dust_reddening(light.wavelengths_nm()[i]);
  }
  SunLuminance sun{{},
                   corona_unit() * luminance(integrate_xyzs(light)),
                   corona_unit() * luminance(integrate_xyzs({light.wavelengths_nm(), std::move(reddened)}))};
  const std::array<Xyzs, limb_terms> terms = limb_xyzs(light, law);
  std::transform(terms.begin(), terms.end(), sun.limb.begin(), luminance);
  return sun;
}

const SunLuminance& sun_luminance(LimbDarkening law) {
  static const SunLuminance neckel = luminance_of_sun(LimbDarkening::neckel);
  static const SunLuminance hestroffer_magnan = luminance_of_sun(LimbDarkening::hestroffer_magnan);
  return law == LimbDarkening::neckel ? neckel : hestroffer_magnan;
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
  const SunLuminance& luminance = sun_luminance(options.law);
  std::copy(luminance.limb.begin(), luminance.limb.end(), std::begin(shading.limb));
  shading.k_corona = luminance.k_corona;
  shading.f_corona = luminance.f_corona;
  if (options.streamers) {
    const auto streamers = corona_streamers(options.activity.value_or(solar_activity(sky.instant)), options.seed);
    std::copy(streamers.begin(), streamers.end(), std::begin(shading.streamers));
  }
  return sun;
}

f32::SunShading in_single(const f64::SunShading& shading) {
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
