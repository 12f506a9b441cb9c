#include "vesper/gpu/ground_pass.hpp"

#include "vesper/gpu/picture_uniforms.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace vesper::gpu {

GroundPass::GroundPass(const ShaderLibrary& library)
    : programs_(library, {"fullscreen.vert", "ground.frag"}), no_vertices_(make_vertex_array()) {}

void GroundPass::prepare(const View& view, const FramePlan& plan) {
  program_ = &programs_.get({fmt::format("PROJECTION {}", static_cast<int>(view.projection))});
  set_picture(*program_, view, plan);
}

void GroundPass::draw(const Strip& strip) {
  set_strip(*program_, strip);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(program_->name());
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

} // namespace vesper::gpu
