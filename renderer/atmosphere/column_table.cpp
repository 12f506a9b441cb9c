#include "vesper/atmosphere/column_table.hpp"

#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

/// Mean densities below this are as good as none, and their logarithm stays finite.
constexpr double least = 1.0e-8;

/// Distance to the top of a ray that rises.
double reach_km(double radius_km, double cos_zenith, double top_km) {
  const double along = radius_km * cos_zenith;
  return std::sqrt(std::max(0.0, along * along + (top_km - radius_km) * (top_km + radius_km))) - along;
}

} // namespace

// Heights go with the square of their number. Angles go evenly with the distance to the top, between that of the zenith
// and that of a level ray, as in Bruneton and Neyret 2008, sec. 4.

ColumnTable::ColumnTable(const SampledAir& air, unsigned threads)
    : air_(air), logarithms_(heights * angles * air.component_count()) {
  const double depth_km = air.top_km() - air.ground_km();
  parallel_for(
      heights, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const double share = static_cast<double>(i) / static_cast<double>(heights - 1);
          const double radius_km = air.ground_km() + depth_km * share * share;
          const double nearest = air.top_km() - radius_km;
          const double farthest = reach_km(radius_km, 0.0, air.top_km());
          for (std::size_t j = 0; j < angles; ++j) {
            const double distance =
                nearest + (farthest - nearest) * static_cast<double>(j) / static_cast<double>(angles - 1);
            const double cos_zenith =
                distance > 0.0 ? ((air.top_km() - radius_km) * (air.top_km() + radius_km) - distance * distance) /
                                     (2.0 * radius_km * distance)
                               : 1.0;
            const auto columns = air.columns_to_space(air.ray(radius_km, std::clamp(cos_zenith, 0.0, 1.0)),
                                                      [](const auto&) { return false; });
            const auto density = air.density(radius_km);
            for (std::size_t c = 0; c < air.component_count(); ++c) {
              // Over the length of the ray: a mean density, which changes more slowly.
              const double mean = distance > 0.0 ? columns[c] / distance : density[c];
              logarithms_[(i * angles + j) * air.component_count() + c] =
                  static_cast<float>(std::log(std::max(mean, least)));
            }
          }
        }
      },
      threads);
}

void ColumnTable::rising(double radius_km, double cos_zenith, SampledAir::PerComponent& columns_km) const {
  const double depth_km = air_.top_km() - air_.ground_km();
  const double height_place =
      std::sqrt(std::clamp((radius_km - air_.ground_km()) / depth_km, 0.0, 1.0)) * static_cast<double>(heights - 1);
  const auto i = std::min(static_cast<std::size_t>(height_place), heights - 2);
  const double low_share = static_cast<double>(i) / static_cast<double>(heights - 1);
  const double high_share = static_cast<double>(i + 1) / static_cast<double>(heights - 1);
  const double low_km = depth_km * low_share * low_share;
  const double high_km = depth_km * high_share * high_share;
  const double s = std::clamp((radius_km - air_.ground_km() - low_km) / (high_km - low_km), 0.0, 1.0);

  const double nearest = air_.top_km() - radius_km;
  const double farthest = reach_km(radius_km, 0.0, air_.top_km());
  const double distance = reach_km(radius_km, cos_zenith, air_.top_km());
  const double place = farthest > nearest ? std::clamp((distance - nearest) / (farthest - nearest), 0.0, 1.0) *
                                                static_cast<double>(angles - 1)
                                          : 0.0;
  const auto j = std::min(static_cast<std::size_t>(place), angles - 2);
  const double t = place - static_cast<double>(j);
  const std::size_t count = air_.component_count();
  const float* low = &logarithms_[(i * angles + j) * count];
  const float* high = low + angles * count;
  for (std::size_t c = 0; c < count; ++c) {
    const double below = static_cast<double>(low[c]) + t * static_cast<double>(low[c + count] - low[c]);
    const double above = static_cast<double>(high[c]) + t * static_cast<double>(high[c + count] - high[c]);
    columns_km[c] = distance * std::exp(below + s * (above - below));
  }
}

bool ColumnTable::to_space(double radius_km, double cos_zenith, SampledAir::PerComponent& columns_km) const {
  if (cos_zenith >= 0.0) {
    rising(radius_km, cos_zenith, columns_km);
    return true;
  }
  const double perigee_km = radius_km * std::sqrt((1.0 - cos_zenith) * (1.0 + cos_zenith));
  if (perigee_km < air_.ground_km()) {
    return false;
  }
  SampledAir::PerComponent behind{};
  rising(perigee_km, 0.0, columns_km);
  rising(radius_km, -cos_zenith, behind);
  for (std::size_t c = 0; c < air_.component_count(); ++c) {
    columns_km[c] = std::max(0.0, 2.0 * columns_km[c] - behind[c]);
  }
  return true;
}

} // namespace vesper
