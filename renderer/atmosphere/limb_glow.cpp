#include "vesper/atmosphere/limb_glow.hpp"

#include "vesper/atmosphere/spectral_air.hpp"
#include "vesper/base/shader_math.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vesper {
namespace {

// Lines of sight, by their lowest points.
constexpr double level_step_km = 1.5;
constexpr int levels = 32;

constexpr double widest_rad = 0.036; // the Moon at perigee, at the edge of the penumbra
constexpr std::size_t angles = 25;
constexpr double angle_step_rad = widest_rad / static_cast<double>(angles - 1);
constexpr double moon_km = 384400.0; // the sums hardly depend on it

// Along a line of sight, from its lowest point.
constexpr double reach_km = 800.0;
constexpr int steps = 40;
constexpr double step_km = 2.0 * reach_km / steps;

constexpr double least_sum = 1.0e-30;

struct Place {
  double km; ///< from the lowest point, positive towards the Sun
  double radius_km;
  SampledAir::PerComponent density;
  SampledAir::PerComponent columns_km; ///< from there to the Moon
};

std::vector<Place> line_of_sight(const SampledAir& air, double lowest_km) {
  AirRay ray;
  ray.perigee_km = lowest_km;
  std::vector<Place> places;
  SampledAir::PerComponent columns{};
  double from = -reach_km;
  for (int i = 0; i < steps; ++i) {
    const double km = -reach_km + (i + 0.5) * step_km;
    if (ray.radius_km(km) < air.top_km()) {
      // In two pieces: densities change little over 20 km of a level ray.
      air.add_columns(ray, from, 0.5 * (from + km), columns);
      air.add_columns(ray, 0.5 * (from + km), km, columns);
      places.push_back({km, ray.radius_km(km), air.density(ray.radius_km(km)), columns});
    }
    from = km;
  }
  return places;
}

} // namespace

LimbGlow::LimbGlow(const Medium& medium, const std::vector<double>& wavelengths_nm,
                   std::span<const EarthShadowLoad> loads)
    : wavelengths_(wavelengths_nm.size()) {
  const SampledAir air(medium);
  const SpectralAir spectral(medium, wavelengths_nm);
  const std::size_t dust = air.component_count() - 1;
  std::vector<double> sums(loads.size() * angles * wavelengths_, least_sum);
  std::vector<double> scattered(wavelengths_);
  for (int level = 0; level < levels; ++level) {
    const double height = (level + 0.5) * level_step_km;
    const std::vector<Place> places = line_of_sight(air, air.ground_km() + height);
    for (std::size_t a = 0; a < angles; ++a) {
      const double above_sun = static_cast<double>(a) * angle_step_rad + height / moon_km;
      for (const Place& place : places) {
        const double elevation = std::atan2(place.km, air.ground_km() + height) - above_sun;
        const AirRay ray = air.ray(place.radius_km, std::sin(elevation));
        if (ray.meets_ground) {
          continue;
        }
        const double lowest = elevation < 0.0 ? std::min(ray.perigee_km - air.ground_km(), height) : height;
        SampledAir::PerComponent columns = air.columns_to_space(ray, [](const auto& /*so far*/) { return false; });
        for (std::size_t c = 0; c <= dust; ++c) {
          columns[c] += place.columns_km[c];
        }
        for (std::size_t l = 0; l < loads.size(); ++l) {
          SampledAir::PerComponent density = place.density;
          SampledAir::PerComponent passed = columns;
          density[dust] *= loads[l].stratospheric_optical_depth;
          passed[dust] *= loads[l].stratospheric_optical_depth;
          spectral.scattering(density, std::cos(above_sun), scattered);
          spectral.attenuate(passed, scattered);
          const double weight =
              step_km * level_step_km * (f64::earth_radius_km + height) * share_past_clouds(loads[l], lowest);
          for (std::size_t i = 0; i < wavelengths_; ++i) {
            sums[(l * angles + a) * wavelengths_ + i] += weight * scattered[i];
          }
        }
      }
    }
  }
  for (double& sum : sums) {
    sum = std::log(sum);
  }
  log_sums_ = std::move(sums);
}

void LimbGlow::add(std::size_t load, double above_sun_rad, double weight, std::span<double> sums) const {
  const double place = std::clamp(above_sun_rad / angle_step_rad, 0.0, static_cast<double>(angles - 1));
  const std::size_t cell = std::min(static_cast<std::size_t>(place), angles - 2);
  const double t = place - static_cast<double>(cell);
  const double* low = &log_sums_[(load * angles + cell) * wavelengths_];
  const double* high = low + wavelengths_;
  for (std::size_t i = 0; i < wavelengths_; ++i) {
    sums[i] += weight * std::exp(low[i] + t * (high[i] - low[i]));
  }
}

} // namespace vesper
