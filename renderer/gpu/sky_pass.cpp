#include "vesper/gpu/sky_pass.hpp"

#include "vesper/gpu/picture_uniforms.hpp"
#include "vesper/sky/sky_light.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <vector>

namespace vesper::gpu {

SkyPass::SkyPass(const ShaderLibrary& library)
    : map_(library), programs_(library, {"fullscreen.vert", "sky.frag"}),
      peak_programs_(library, {"sky_peak.vert", "sky.frag"}), no_vertices_(make_vertex_array()) {}

double SkyPass::advance(const std::shared_ptr<const SkyTables>& wanted) {
  constexpr std::size_t bytes_per_frame = std::size_t{2} << 20U;
  if (!now_ || (change_frames_ == 0 && now_->tables() != wanted)) {
    next_.reset();
    now_.reset();
    now_.emplace(wanted);
    now_->upload(std::numeric_limits<std::size_t>::max());
    return 0.0;
  }
  // A blend that has begun is brought to its end before other tables follow.
  if (frames_blended_ == 0 && (next_ ? next_->tables() : now_->tables()) != wanted) {
    next_.reset();
    if (now_->tables() != wanted) {
      next_.emplace(wanted);
    }
  }
  if (!next_ || !next_->upload(bytes_per_frame)) {
    return 0.0;
  }
  ++frames_blended_;
  if (frames_blended_ < change_frames_) {
    return static_cast<double>(frames_blended_) / change_frames_;
  }
  now_ = std::move(next_);
  next_.reset();
  frames_blended_ = 0;
  return 0.0;
}

void SkyPass::prepare(const SkyState& sky, const View& view, const FramePlan& plan, const Texture* dark_air) {
  const Length height = height_in_air(sky.observer);
  const double share = advance(plan.options.air.sky_tables);
  map_.fill(*now_, plan, height);
  if (share > 0.0) {
    map_.fill(*next_, plan, height, share);
  }
  map_.eclipse(*now_->tables(), plan, height);
  const std::string projection = fmt::format("PROJECTION {}", static_cast<int>(view.projection));
  std::vector<std::string> defines{projection};
  dark_air_ = dark_air;
  if (dark_air_ != nullptr) {
    defines.emplace_back("DARK_SKY");
  }
  program_ = &programs_.get(defines);
  if (dark_air_ != nullptr) {
    glProgramUniform2f(program_->name(), 5, PlannedDarkSky::rows_below, PlannedDarkSky::rows_above);
  }
  peak_program_ = &peak_programs_.get({projection, "PEAK"});
  set_picture(*program_, view, plan);
  set_picture(*peak_program_, view, plan);
  peak_tiles_ = set_tiles(*peak_program_, view, 48) * static_cast<int>(plan.lights.size());
}

void SkyPass::draw(const Strip& strip) {
  set_strip(*program_, strip);
  set_strip(*peak_program_, strip);
  map_.bind();
  if (dark_air_ != nullptr) {
    glBindTextureUnit(2, dark_air_->name());
  }
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBindVertexArray(no_vertices_.name());
  glUseProgram(program_->name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glUseProgram(peak_program_->name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, peak_tiles_);
  glDisable(GL_BLEND);
}

} // namespace vesper::gpu
