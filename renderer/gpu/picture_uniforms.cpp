#include "vesper/gpu/picture_uniforms.hpp"

#include <algorithm>
#include <array>
#include <epoxy/gl.h>

namespace vesper::gpu {

void set_picture(const ProgramHandle& program, const View& view, const FramePlan& plan) {
  const Mat3 horizon_from_view = glm::transpose(view_from_horizon(view));
  std::array<float, 9> matrix{};
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    matrix.at(i) = static_cast<float>(horizon_from_view[static_cast<int>(i / 3)][static_cast<int>(i % 3)]);
  }
  const f64::ProjectionFrame projection = projection_frame(view);
  glProgramUniformMatrix3fv(program.name(), 0, 1, GL_FALSE, matrix.data());
  glProgramUniform2f(program.name(), 1, static_cast<float>(view.width), static_cast<float>(view.height));
  glProgramUniform1f(program.name(), 2, static_cast<float>(projection.focal));
  glProgramUniform1f(program.name(), 3, static_cast<float>(plan.horizon_sin_altitude));
}

void set_strip(const ProgramHandle& program, const Strip& strip) {
  glProgramUniform2f(program.name(), 4, static_cast<float>(strip.first_row), static_cast<float>(strip.rows));
}

int set_tiles(const ProgramHandle& program, const View& view, int pixels) {
  const auto tiles = [&](int side) { return std::clamp((side + pixels - 1) / pixels, 1, 64); };
  glProgramUniform2i(program.name(), 12, tiles(view.width), tiles(view.height));
  return tiles(view.width) * tiles(view.height);
}

} // namespace vesper::gpu
