#include "vesper/sky/moon_disc.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/sunlight.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesper {
namespace {

constexpr double largest_gain = 4.0;

/// The smallest turn that takes one unit vector to another not opposite to it (Rodrigues' formula).
Mat3 turn(const Vec3& from, const Vec3& to) {
  const Vec3 axis = glm::cross(from, to);
  const Mat3 cross_product(Vec3(0.0, axis.z, -axis.y), Vec3(-axis.z, 0.0, axis.x), Vec3(axis.y, -axis.x, 0.0));
  return Mat3(1.0) + cross_product + cross_product * cross_product / (1.0 + glm::dot(from, to));
}

/// The globe's axes against the horizon. Aberration moves the apparent Moon by 20 arcsec as a whole: the last turn
/// brings the libration's point under the observer again.
Mat3 axes_from_horizon(const SkyState& sky, const Vec3& to_observer) {
  const Mat3 from_horizon = sky.moon.moon_fixed_from_icrs * glm::transpose(sky.stars.horizon_from_icrs);
  return turn(glm::normalize(from_horizon * -sky.moon.place.direction_horizon), to_observer) * from_horizon;
}

/// Light on the Moon in the colour that the surface gives it, with the illuminance that it has there.
Vec4 coloured(const Spectrum& light, Angle phase_angle) {
  const Vec4 reflected = vector_of(integrate_xyzs(filtered(light, moon_albedo(phase_angle))));
  return reflected.y > 0.0 ? integrate_xyzs(light).y / reflected.y * reflected : Vec4(0.0);
}

f64::LunarLaw scaled_law(const f64::LunarLaw& law, double factor) {
  return {factor * law.seeliger, factor * law.lambert};
}

/// Whether so little of the surface is lit that the samples of the whole globe are too few; at half a turn it has no
/// horns.
bool is_thin(Angle phase_angle) { return phase_angle > 125.0 * deg && phase_angle < 179.99 * deg; }

double sum_sunlight(const MoonSamples& samples, const Vec3& observer, const f64::MoonLighting& lighting) {
  double sum = 0.0;
  for_sunlit(samples, observer, lighting, [&](const MoonSample&, double light) { sum += light; });
  return sum;
}

/// Factor for a law whose disc gives `drawn` lux instead of `wanted`.
double gain_of(double wanted, double drawn) {
  if (wanted <= 0.0) {
    return 0.0;
  }
  return wanted < largest_gain * drawn ? wanted / drawn : largest_gain;
}

} // namespace

MoonDisc moon_disc(const SkyState& sky, const MoonGlobe& globe, MoonIllumination moon) {
  const LunarSurface surface = sky.tier == Tier::cheap ? LunarSurface::cheap : LunarSurface::standard;
  const Length distance = sky.moon.place.distance;
  const Angle radius = std::asin(moon_mean_radius / distance) * rad;
  const Vec3 to_observer = direction_of(sky.moon.libration);

  f64::MoonLighting lighting{};
  lighting.to_sun = direction_of(sky.moon.subsolar);
  lighting.to_earth = direction_of(sky.moon.geocentric_libration);
  lighting.sunlit = coloured(scaled(solar_irradiance_1au(), std::pow(astronomical_unit / moon.sun_distance, 2)),
                             sky.moon.phase_angle);
  lighting.earthlit = coloured(moon.earthlight, moon.earthlight_phase);
  lighting.sun_law = lunar_law(sky.moon.phase_angle, surface);
  lighting.earth_law = lunar_law(moon.earthlight_phase, surface);
  lighting.sun_radius_rad = std::asin(sun_radius / moon.sun_distance);

  const Vec3& direction = sky.moon.place.direction_horizon;
  const Mat3 fixed_from_horizon = axes_from_horizon(sky, to_observer);
  const Mat3 fixed_from_disc = fixed_from_horizon * horizon_from_disc(direction);
  const Vec3 observer = distance / moon_mean_radius * to_observer;
  MoonLightSums sums = sum_moon_light(globe.samples, observer, lighting, fixed_from_disc);
  const double sunlit = is_thin(sky.moon.phase_angle)
                            ? sum_sunlight(sample_crescent(globe.map, to_observer, lighting.to_sun), observer, lighting)
                            : sums.sun;
  const double sun_wanted = integrate_xyzs(moon.sunlit_moon).y;
  const double sun_drawn = sunlit * lighting.sunlit.y;
  const double earth_wanted = integrate_xyzs(moon.earthlit_moon).y;
  const double earth_drawn = sums.earth * lighting.earthlit.y;
  const double sun_gain = gain_of(sun_wanted, sun_drawn);
  lighting.sun_law = scaled_law(lighting.sun_law, sun_gain);
  const double earth_gain = gain_of(earth_wanted, earth_drawn);
  lighting.earth_law = scaled_law(lighting.earth_law, earth_gain);
  const double of_cells = sums.sun > 0.0 ? sun_gain * sunlit / sums.sun : 0.0;
  for (MoonCell& cell : sums.cells) {
    cell.sun *= static_cast<float>(of_cells);
    cell.earth *= static_cast<float>(earth_gain);
  }
  if (sun_gain == largest_gain) {
    moon.sunlit_moon = scaled(moon.sunlit_moon, sun_gain * sun_drawn / sun_wanted);
  }

  const Spectrum irradiance = moonlight_of(moon);
  const MoonBrightness brightness = moon_brightness(irradiance, distance);
  return {direction,
          distance,
          radius,
          fixed_from_horizon,
          fixed_from_disc,
          to_observer,
          lighting,
          std::move(sums.cells),
          irradiance,
          brightness.illuminance,
          brightness.v_magnitude,
          brightness.mean_luminance};
}

MoonDisc moon_disc(const SkyState& sky, const MoonGlobe& globe) {
  return moon_disc(sky, globe, moon_illumination(sky));
}

} // namespace vesper
