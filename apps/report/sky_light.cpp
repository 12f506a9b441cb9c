#include "report/sky_light.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace vesper {
namespace {

/// The relative error that a light may have, so that the errors of all add up to that of the sum at the least cost:
/// squares of errors in proportion to what the lights give.
double allowed_error(const TransportResult& light, const std::vector<double>& sums, const LightBudget& budget) {
  // Of a light that gives nothing no digit is needed.
  double factor = 1.0e6;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (const double mean = light.functionals[i].mean; mean > 0.0) {
      factor = std::min(factor, std::max(sums[i], budget.faint) / std::sqrt(mean * sums[i]));
    }
  }
  return budget.paths.relative_error * std::max(factor, 1.0);
}

using LightTransport =
    std::function<TransportResult(const WeightedLight&, const std::vector<SpectralFunctional>&, const PathBudget&)>;

SkyEstimate sum_of_lights(const std::vector<WeightedLight>& lights, std::size_t quantities, const LightBudget& budget,
                          const LightTransport& transport) {
  const PathBudget& all = budget.paths;
  const auto result_of = [&](const WeightedLight& weighted, double relative_error, std::uint64_t most_paths) {
    PathBudget own = all;
    own.stream = weighted.stream;
    own.relative_error = relative_error;
    own.most_paths = most_paths;
    return transport(weighted, weighted.functionals, own);
  };
  std::vector<double> relative_errors(lights.size(), all.relative_error);
  if (lights.size() > 1 || budget.faint > 0.0) {
    // A first look at each light tells how much of the sum is its own.
    std::vector<TransportResult> first;
    std::vector<double> sums(quantities);
    for (const WeightedLight& light : lights) {
      first.push_back(result_of(light, all.relative_error, std::min(all.least_paths, all.most_paths)));
      for (std::size_t i = 0; i < quantities; ++i) {
        sums[i] += first.back().functionals[i].mean;
      }
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
      relative_errors[i] = allowed_error(first[i], sums, budget);
    }
  }
  SkyEstimate sum{std::vector<Estimate>(quantities), 0};
  for (std::size_t light = 0; light < lights.size(); ++light) {
    const TransportResult result = result_of(lights[light], relative_errors[light], all.most_paths);
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

SkyEstimate sky_radiance(const ReferenceTransport& transport, Length height, const Vec3& view_direction,
                         const std::vector<WeightedLight>& lights, std::size_t quantities, const LightBudget& budget) {
  return sum_of_lights(
      lights, quantities, budget,
      [&](const WeightedLight& weighted, const std::vector<SpectralFunctional>& functionals, const PathBudget& own) {
        const SkyLight& light = weighted.light;
        return transport.radiance({height, light.direction, light.angular_radius, view_direction, weighted.share},
                                  functionals, own);
      });
}

LevelLight level_light(const ReferenceTransport& transport, Length height, const std::vector<WeightedLight>& lights,
                       const LightBudget& budget) {
  const auto query_of = [&](const WeightedLight& weighted) {
    const SkyLight& light = weighted.light;
    return SkyQuery{height, light.direction, light.angular_radius, {0.0, 0.0, 1.0}, weighted.share};
  };
  LevelLight level;
  for (const WeightedLight& weighted : lights) {
    const std::vector<double> spectrum = transport.direct_irradiance(query_of(weighted));
    level.direct = std::inner_product(spectrum.begin(), spectrum.end(), weighted.functionals[0].begin(), level.direct);
  }
  const SkyEstimate diffuse =
      sum_of_lights(lights, 1, budget,
                    [&](const WeightedLight& light, const std::vector<SpectralFunctional>& all, const PathBudget& own) {
                      return transport.diffuse_irradiance(query_of(light), {all[0]}, own);
                    });
  level.total = {level.direct + diffuse.quantities[0].mean, diffuse.quantities[0].standard_error};
  level.paths = diffuse.paths;
  return level;
}

} // namespace vesper
