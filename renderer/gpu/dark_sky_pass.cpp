#include "vesper/gpu/dark_sky_pass.hpp"

#include "vesper/gpu/picture_uniforms.hpp"
#include "vesper/sky/zodiacal_light.hpp"

#include <array>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace vesper::gpu {
namespace {

void set_matrix(const ProgramHandle& program, int location, const Mat3& matrix) {
  std::array<float, 9> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    values.at(i) = static_cast<float>(matrix[static_cast<int>(i / 3)][static_cast<int>(i % 3)]);
  }
  glProgramUniformMatrix3fv(program.name(), location, 1, GL_FALSE, values.data());
}

void set_light(const ProgramHandle& program, int location, const Vec4& light) {
  glProgramUniform4f(program.name(), location, static_cast<float>(light.x), static_cast<float>(light.y),
                     static_cast<float>(light.z), static_cast<float>(light.w));
}

template <class Texels> Texture smooth_texture(int width, const Texels& texels) {
  std::vector<float> rgba;
  rgba.reserve(4 * texels.size());
  for (const auto& texel : texels) {
    for (int channel = 0; channel < 4; ++channel) {
      rgba.push_back(static_cast<float>(texel[channel]));
    }
  }
  Texture texture = make_table_texture(width, rgba);
  interpolate(texture);
  return texture;
}

} // namespace

DarkSkyPass::DarkSkyPass(const ShaderLibrary& library)
    : programs_(library, {"fullscreen.vert", "dark_sky.frag"}), no_vertices_(make_vertex_array()) {}

void DarkSkyPass::prepare(const View& view, const FramePlan& plan) {
  const PlannedDarkSky& dark = *plan.dark_sky;
  beyond_ = nullptr;
  if (dark.zodiacal || dark.starlight) {
    prepare_beyond(view, plan);
  }
  air_ = &programs_.get({fmt::format("PROJECTION {}", static_cast<int>(view.projection))});
  set_picture(*air_, view, plan);
  map_ = smooth_texture(PlannedDarkSky::columns + 1, dark.air);
  const f64::SkyMapFrame& frame = dark.place->frame;
  glProgramUniform2f(air_->name(), 5, PlannedDarkSky::rows_below, PlannedDarkSky::rows_above);
  glProgramUniform3f(air_->name(), 6, static_cast<float>(frame.nadir_to_horizon),
                     static_cast<float>(frame.zenith_to_horizon), static_cast<float>(frame.zenith_to_end));
}

void DarkSkyPass::prepare_beyond(const View& view, const FramePlan& plan) {
  const PlannedDarkSky& dark = *plan.dark_sky;
  beyond_ = &programs_.get({fmt::format("PROJECTION {}", static_cast<int>(view.projection)), "BEYOND"});
  set_picture(*beyond_, view, plan);
  if (!zodiacal_) {
    zodiacal_ = smooth_texture(ZodiacalMap::columns, zodiacal_map().texels);
  }
  extinction_.update(plan.extinction);
  const DarkSky& sources = dark.sources;
  set_matrix(*beyond_, 5, sources.helioecliptic_from_horizon);
  set_matrix(*beyond_, 6, sources.galactic_from_horizon);
  glProgramUniform1f(beyond_->name(), 7, dark.zodiacal ? static_cast<float>(sources.zodiacal_scale) : 0.0F);
  set_light(*beyond_, 8, sources.dust_corona);
  glProgramUniform1f(beyond_->name(), 9, static_cast<float>(sources.sin_sun_radius));
  set_light(*beyond_, 10, dark.starlight ? sources.starlight_s10 : Vec4(0.0));
  const f64::StarExtinctionFrame& air = extinction_.frame();
  glProgramUniform2i(beyond_->name(), 11, air.rows, air.columns);
  glProgramUniform3f(beyond_->name(), 12, static_cast<float>(air.sin_horizon), static_cast<float>(air.width),
                     static_cast<float>(air.rows_per_x));
  glProgramUniform2f(beyond_->name(), 13, static_cast<float>(air.reddest), static_cast<float>(air.columns_per_hue));
}

void DarkSkyPass::draw(const ProgramHandle& program, const Strip& strip) {
  set_strip(program, strip);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glUseProgram(program.name());
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

void DarkSkyPass::draw_beyond(const Strip& strip) {
  if (beyond_ == nullptr) {
    return;
  }
  glBindTextureUnit(0, zodiacal_.name());
  extinction_.bind(1);
  draw(*beyond_, strip);
}

void DarkSkyPass::draw_air(const Strip& strip) {
  glBindTextureUnit(0, map_.name());
  draw(*air_, strip);
}

} // namespace vesper::gpu
