#include "vesper/gpu/ground_pass.hpp"

#include <array>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace vesper::gpu {

GroundPass::GroundPass(const ShaderLibrary& library)
    : programs_(library, {"fullscreen.vert", "ground.frag"}), no_vertices_(make_vertex_array()) {}

void GroundPass::prepare(const View& view, const FramePlan& plan) {
  program_ = &programs_.get({fmt::format("PROJECTION {}", static_cast<int>(view.projection))});
  const GLuint program = program_->name();
  const Mat3 horizon_from_view = glm::transpose(view_from_horizon(view));
  std::array<float, 9> matrix{};
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    matrix.at(i) = static_cast<float>(horizon_from_view[static_cast<int>(i / 3)][static_cast<int>(i % 3)]);
  }
  const f64::ProjectionFrame projection = projection_frame(view);
  glProgramUniformMatrix3fv(program, 0, 1, GL_FALSE, matrix.data());
  glProgramUniform2f(program, 1, static_cast<float>(view.width), static_cast<float>(view.height));
  glProgramUniform1f(program, 2, static_cast<float>(projection.focal));
  glProgramUniform1f(program, 3, static_cast<float>(plan.horizon_sin_altitude));
}

void GroundPass::draw(const Strip& strip) {
  glProgramUniform1f(program_->name(), 4, static_cast<float>(strip.first_row));
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(program_->name());
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

} // namespace vesper::gpu
