#include "vesper/gpu/dark_sky_pass.hpp"

#include "vesper/gpu/picture_uniforms.hpp"
#include "vesper/sky/milky_way.hpp"
#include "vesper/sky/zodiacal_light.hpp"

#include <algorithm>
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

/// From the first size on that the GPU takes.
Texture cube_of(const CubePyramid& pyramid) {
  const int largest = largest_cube_side();
  const auto fits = [&](const CubePyramid::Level& level) { return level.face_size <= largest; };
  const auto first = std::find_if(pyramid.levels().begin(), pyramid.levels().end(), fits);
  Texture texture = make_cube_texture(first->face_size);
  for (auto level = first; level != pyramid.levels().end(); ++level) {
    fill_cube_texture(texture, static_cast<int>(level - first), level->face_size, level->texels);
  }
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
  std::vector<std::string> defines{fmt::format("PROJECTION {}", static_cast<int>(view.projection)), "BEYOND"};
  if (dark.starlight) {
    defines.emplace_back("MILKY_WAY");
    defines.push_back(fmt::format("REFRACTION {}", refraction_frame(plan.refraction).kind));
  }
  beyond_ = &programs_.get(defines);
  set_picture(*beyond_, view, plan);
  if (!zodiacal_) {
    zodiacal_ = smooth_texture(ZodiacalMap::columns, zodiacal_map().texels);
  }
  extinction_.update(plan.extinction);
  const DarkSky& sources = dark.sources;
  set_matrix(*beyond_, 5, sources.helioecliptic_from_horizon);
  glProgramUniform1f(beyond_->name(), 7, dark.zodiacal ? static_cast<float>(sources.zodiacal_scale) : 0.0F);
  set_light(*beyond_, 8, sources.dust_corona);
  glProgramUniform1f(beyond_->name(), 9, static_cast<float>(sources.sin_sun_radius));
  const f64::StarExtinctionFrame& air = extinction_.frame();
  glProgramUniform2i(beyond_->name(), 11, air.rows, air.columns);
  glProgramUniform3f(beyond_->name(), 12, static_cast<float>(air.sin_horizon), static_cast<float>(air.width),
                     static_cast<float>(air.rows_per_x));
  glProgramUniform2f(beyond_->name(), 13, static_cast<float>(air.reddest), static_cast<float>(air.columns_per_hue));
  if (dark.starlight) {
    prepare_milky_way(plan);
  }
}

void DarkSkyPass::prepare_milky_way(const FramePlan& plan) {
  const DarkSky& sources = plan.dark_sky->sources;
  const auto& milky_way = sources.milky_way != nullptr ? sources.milky_way : default_milky_way();
  if (milky_way_of_ != milky_way) {
    milky_way_ = cube_of(*milky_way);
    milky_way_of_ = milky_way;
  }
  set_matrix(*beyond_, 6, sources.icrs_from_horizon);
  refraction_.update(plan.refraction);
  const f64::RefractionFrame bend = refraction_frame(plan.refraction);
  glProgramUniform3f(beyond_->name(), 10, static_cast<float>(bend.strength), static_cast<float>(bend.horizon_apparent),
                     static_cast<float>(bend.horizon_true));
  set_light(*beyond_, 14, {bend.scale_apparent, bend.scale_true});
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
  glBindTextureUnit(2, milky_way_.name());
  refraction_.bind(3);
  draw(*beyond_, strip);
}

void DarkSkyPass::draw_air(const Strip& strip) {
  glBindTextureUnit(0, map_.name());
  draw(*air_, strip);
}

} // namespace vesper::gpu
