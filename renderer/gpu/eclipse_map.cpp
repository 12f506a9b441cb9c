#include "vesper/gpu/eclipse_map.hpp"

#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <epoxy/gl.h>
#include <numbers>
#include <vector>

namespace vesper::gpu {
namespace {

/// Altitude along a straight ray of a row of the net.
double straight_altitude_rad(int row, const EclipseMap::MapSize& net, const EclipseMap::MapRows& map) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  const bool below = row < net.rows_below;
  const double place = below ? static_cast<double>(net.rows_below - 1 - row) / (net.rows_below - 1)
                             : static_cast<double>(row - net.rows_below) / (net.rows_above - 1);
  const auto seen = static_cast<double>(f32::sky_map_altitude_rad(static_cast<float>(place), below, map.frame));
  const double end = below ? -quarter : map.seen_end_rad;
  const double straight_end = below ? -quarter : map.straight_end_rad;
  const double share = std::clamp((seen - map.seen_horizon_rad) / (end - map.seen_horizon_rad), 0.0, 1.0);
  return map.straight_horizon_rad + share * (straight_end - map.straight_horizon_rad);
}

/// Of the horizon, 3 km up.
constexpr double high_dip_rad = 0.031;

/// The rays of the horizon itself graze the ground: they are told apart by this.
constexpr double beside_horizon_rad = 2.0e-4;

std::vector<float> log2_ratios(const EclipseMap::MapSize& net, const EclipseMap::MapRows& map, const FramePlan& plan) {
  const int rows = net.rows_below + net.rows_above;
  const std::size_t layer = static_cast<std::size_t>(rows) * static_cast<std::size_t>(net.columns);
  std::vector<float> texels(std::size_t{2} * layer * 4);
  const bool with_ground = has(plan.options.layers, Layer::ground);
  const auto fill_row = [&](int row) {
    const double straight = straight_altitude_rad(row, net, map);
    const double altitude = row < net.rows_below ? std::min(straight, map.straight_horizon_rad - beside_horizon_rad)
                                                 : std::max(straight, map.straight_horizon_rad + beside_horizon_rad);
    for (int column = 0; column < net.columns; ++column) {
      const f32::vec2 level = f32::sky_map_level(static_cast<float>(column) / static_cast<float>(net.columns - 1));
      const Vec3 view = glm::normalize(Vec3(std::cos(altitude) * static_cast<double>(level.x),
                                            std::cos(altitude) * static_cast<double>(level.y), std::sin(altitude)));
      const EclipsedSky::Ratios ratios = plan.eclipse.sky->ratios(view, with_ground);
      const auto store = [&](std::size_t at, const f32::vec4& ratio) {
        for (int i = 0; i < 4; ++i) {
          texels[4 * at + static_cast<std::size_t>(i)] = std::log2(ratio[i]);
        }
      };
      const auto texel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(net.columns) + static_cast<std::size_t>(column);
      store(texel, ratios.without_peak);
      store(layer + texel, ratios.aerosol);
    }
  };
  parallel_for(static_cast<std::size_t>(rows), 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      fill_row(static_cast<int>(row));
    }
  });
  return texels;
}

} // namespace

void EclipseMap::dim(const Texture& map, const MapSize& size, const MapRows& map_rows, const FramePlan& plan) {
  // From high up the umbra's edge is seen on the ground, sharp beside the soft light around an observer inside it.
  const int coarser = map_rows.straight_horizon_rad < -high_dip_rad ? 1 : 4;
  const MapSize net{(size.columns - 1) / coarser + 1, size.rows_below / coarser, size.rows_above / coarser};
  const Texture ratios = make_table_texture(net.columns, log2_ratios(net, map_rows, plan));
  interpolate(ratios);
  const ProgramHandle& program = programs_.get({});
  glUseProgram(program.name());
  glProgramUniform2i(program.name(), 0, size.rows_below, size.rows_above);
  glProgramUniform2i(program.name(), 1, net.rows_below, net.rows_above);
  glBindTextureUnit(0, ratios.name());
  glBindImageTexture(0, map.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  constexpr int group = 8;
  const auto groups = [](int count) { return static_cast<GLuint>((count + group - 1) / group); };
  glDispatchCompute(groups(size.columns), groups(size.rows_below + size.rows_above), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace vesper::gpu
