#include "report/sky_light.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/sunlight.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace vesper {
namespace {

constexpr Angle deepest_light = 24.0 * deg; // below the horizon

Angle angular_radius(Length radius, Length distance) { return std::asin(radius / distance) * rad; }

bool lights_the_air(const SkyLight& light, Length height) {
  constexpr Length ground = 6371.0 * kilometre; // the dip is needed within a degree
  const Angle dip = std::acos(ground / (ground + height)) * rad;
  return latitude_of(light.direction) + dip > -deepest_light;
}

/// The error that a light may have, so that the errors of all add up to `relative_error` of the sum at the least cost:
/// squares of errors in proportion to what the lights give.
double allowed_error(const TransportResult& light, const std::vector<double>& sums, double relative_error) {
  // Of a light that gives nothing no digit is needed.
  double factor = 1.0e6;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (light.functionals[i].mean > 0.0) {
      factor = std::min(factor, std::sqrt(sums[i] / light.functionals[i].mean));
    }
  }
  return relative_error * std::max(factor, 1.0);
}

using LightTransport =
    std::function<TransportResult(const SkyLight&, const std::vector<SpectralFunctional>&, const PathBudget&)>;

SkyEstimate sum_of_lights(const std::vector<WeightedLight>& lights, std::size_t quantities, const PathBudget& budget,
                          const LightTransport& transport) {
  const auto result_of = [&](const WeightedLight& weighted, double relative_error, std::uint64_t most_paths) {
    PathBudget own = budget;
    own.stream = weighted.stream;
    own.relative_error = relative_error;
    own.most_paths = most_paths;
    return transport(weighted.light, weighted.functionals, own);
  };
  std::vector<double> relative_errors(lights.size(), budget.relative_error);
  if (lights.size() > 1) {
    // A first look at each light tells how much of the sum is its own.
    std::vector<TransportResult> first;
    std::vector<double> sums(quantities);
    for (const WeightedLight& light : lights) {
      first.push_back(result_of(light, budget.relative_error, std::min(budget.least_paths, budget.most_paths)));
      for (std::size_t i = 0; i < quantities; ++i) {
        sums[i] += first.back().functionals[i].mean;
      }
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
      relative_errors[i] = allowed_error(first[i], sums, budget.relative_error);
    }
  }
  SkyEstimate sum{std::vector<Estimate>(quantities), 0};
  for (std::size_t light = 0; light < lights.size(); ++light) {
    const TransportResult result = result_of(lights[light], relative_errors[light], budget.most_paths);
    for (std::size_t i = 0; i < quantities; ++i) {
      sum.quantities[i].mean += result.functionals[i].mean;
      sum.quantities[i].standard_error =
          std::hypot(sum.quantities[i].standard_error, result.functionals[i].standard_error);
    }
    sum.paths += result.paths;
  }
  return sum;
}

} // namespace

SkyLight sun_light(const Vec3& direction, Length distance) {
  const Spectrum& at_1au = solar_irradiance_1au();
  const double scale = std::pow(astronomical_unit / distance, 2);
  std::vector<double> irradiance = at_1au.values();
  for (double& value : irradiance) {
    value *= scale;
  }
  return {"sun", direction, angular_radius(sun_radius, distance), {at_1au.wavelengths_nm(), std::move(irradiance)}};
}

SkyLight moon_light(const Vec3& direction, Length distance, Length from_sun, Angle phase_angle) {
  return {"moon", direction, angular_radius(moon_mean_radius, distance),
          moon_irradiance(phase_angle, distance, from_sun)};
}

std::vector<SkyLight> lights_of(const SkyState& sky) {
  const Refraction refraction = with_table(sky.refraction);
  const BodyPlace& moon = sky.moon.place;
  const Vec3 sun_km = sky.sun.distance.to(kilometre) * sky.sun.direction_equatorial;
  const Vec3 moon_km = moon.distance.to(kilometre) * moon.direction_equatorial;
  std::vector<SkyLight> lights{sun_light(apparent_direction(sky.sun.direction_horizon, refraction), sky.sun.distance),
                               moon_light(apparent_direction(moon.direction_horizon, refraction), moon.distance,
                                          glm::length(sun_km - moon_km) * kilometre, sky.moon.phase_angle)};
  const Length height = height_in_air(sky.observer);
  std::erase_if(lights, [&](const SkyLight& light) { return !lights_the_air(light, height); });
  return lights;
}

Length height_in_air(const Observer& observer) { return std::max(observer.height, 0.0 * metre); }

SkyEstimate sky_radiance(const ReferenceTransport& transport, Length height, const Vec3& view_direction,
                         const std::vector<WeightedLight>& lights, std::size_t quantities, const PathBudget& budget) {
  return sum_of_lights(
      lights, quantities, budget,
      [&](const SkyLight& light, const std::vector<SpectralFunctional>& functionals, const PathBudget& own) {
        return transport.radiance({height, light.direction, light.angular_radius, view_direction}, functionals, own);
      });
}

LevelLight level_light(const ReferenceTransport& transport, Length height, const std::vector<WeightedLight>& lights,
                       const PathBudget& budget) {
  const auto query_of = [&](const SkyLight& light) {
    return SkyQuery{height, light.direction, light.angular_radius, {0.0, 0.0, 1.0}};
  };
  LevelLight level;
  for (const WeightedLight& weighted : lights) {
    const std::vector<double> spectrum = transport.direct_irradiance(query_of(weighted.light));
    level.direct = std::inner_product(spectrum.begin(), spectrum.end(), weighted.functionals[0].begin(), level.direct);
  }
  const SkyEstimate diffuse = sum_of_lights(
      lights, 1, budget, [&](const SkyLight& light, const std::vector<SpectralFunctional>& all, const PathBudget& own) {
        return transport.diffuse_irradiance(query_of(light), {all[0]}, own);
      });
  level.total = {level.direct + diffuse.quantities[0].mean, diffuse.quantities[0].standard_error};
  level.paths = diffuse.paths;
  return level;
}

} // namespace vesper
