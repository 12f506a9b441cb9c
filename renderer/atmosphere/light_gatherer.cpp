#include "vesper/atmosphere/light_gatherer.hpp"

#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <array>

namespace vesper {

LightFieldSums::LightFieldSums(const LightFieldModel& model)
    : moments(model.nodes() * model.blocks()),
      sources(model.source_heights() * model.angles() * LightFieldModel::source_directions * model.blocks()) {}

/// Calls `gather(ray, light, radiance)` for all directions of each node and sums up.
template <class Gather>
void ThreadedLightGatherer::for_each_node(const LightRule& rule, LightFieldSums& sums, const Gather& gather) const {
  const std::size_t blocks = model_.blocks();
  const std::size_t angles = model_.angles();
  constexpr std::size_t directions = LightFieldModel::source_directions;
  parallel_for(
      model_.nodes(), 8,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Lanes> radiances(rule.size() * blocks);
        for (std::size_t node = begin; node < end; ++node) {
          const std::size_t height = node / angles;
          std::fill(radiances.begin(), radiances.end(), Lanes{});
          const f32::LightDirection* from = &rule.directions[height * rule.size()];
          for (std::size_t k = 0; k < rule.size(); ++k) {
            const LightRay& ray = rule.rays[height * rule.zeniths + k / rule.azimuths];
            const auto cos_azimuth = static_cast<double>(from[k].cos_azimuth);
            gather(ray, light_place(ray, model_.angle_cos(node % angles), cos_azimuth), &radiances[k * blocks]);
          }
          for (std::size_t b = 0; b < blocks; ++b) {
            f32::LightSums moments{};
            for (std::size_t k = 0; k < rule.size(); ++k) {
              f32::add_light(radiances[k * blocks + b], from[k], moments);
            }
            sums.moments[node * blocks + b] = moments;
          }
          if (height >= model_.source_heights()) {
            continue;
          }
          for (std::size_t toward = 0; toward < directions; ++toward) {
            const Lanes* matrix = &rule.phase_matrix[(height * directions + toward) * rule.size() * blocks];
            for (std::size_t b = 0; b < blocks; ++b) {
              Lanes source;
              for (std::size_t k = b; k < rule.size() * blocks; k += blocks) {
                source += matrix[k] * radiances[k];
              }
              sums.sources[(node * directions + toward) * blocks + b] = source;
            }
          }
        }
      },
      threads_);
}

void ThreadedLightGatherer::gather_once(LightFieldSums& sums) {
  for_each_node(model_.first_rule(threads_), sums,
                [&](const LightRay& ray, const f32::LightPlace& light, Lanes* radiance) {
                  std::array<Lanes, SampledAir::most_components * LightFieldModel::most_blocks> by_scatterer{};
                  std::array<Lanes, LightFieldModel::most_blocks> phase{};
                  add_direct(model_, ray, light, LightFieldModel::light_radius_rad, by_scatterer.data(), radiance);
                  for (std::size_t s = 0; s < model_.scatterers(); ++s) {
                    model_.phase(s, static_cast<double>(light.cos_angle), phase.data());
                    for (std::size_t b = 0; b < model_.blocks(); ++b) {
                      radiance[b] += phase[b] * by_scatterer[s * model_.blocks() + b];
                    }
                  }
                });
}

void ThreadedLightGatherer::gather_again(const LightFieldTables& tables, LightFieldSums& sums) {
  if (later_rule_.rays.empty()) {
    later_rule_ = model_.later_rule(threads_);
  }
  for_each_node(later_rule_, sums, [&](const LightRay& ray, const f32::LightPlace& light, Lanes* radiance) {
    add_scattered(model_, ray, light, tables, radiance, radiance);
  });
}

} // namespace vesper
