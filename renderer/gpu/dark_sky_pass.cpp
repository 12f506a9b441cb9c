#include "vesper/gpu/dark_sky_pass.hpp"

#include "vesper/gpu/picture_uniforms.hpp"
#include "vesper/sky/milky_way.hpp"
#include "vesper/sky/zodiacal_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

template <class Texels> std::vector<float> rgba_of(const Texels& texels) {
  std::vector<float> rgba;
  rgba.reserve(4 * texels.size());
  for (const auto& texel : texels) {
    for (int channel = 0; channel < 4; ++channel) {
      rgba.push_back(static_cast<float>(texel[channel]));
    }
  }
  return rgba;
}

template <class Texels> Texture smooth_texture(int width, const Texels& texels) {
  Texture texture = make_table_texture(width, rgba_of(texels));
  interpolate(texture);
  return texture;
}

template <class Draw> void add_light(const Draw& draw) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  draw();
  glDisable(GL_BLEND);
}

/// Rows of a map or table in the frame of the map's.
void set_rows(const ProgramHandle& program, int below, int above, const DarkSkyPlace& place) {
  glProgramUniform2f(program.name(), 5, static_cast<float>(below), static_cast<float>(above));
  glProgramUniform3f(program.name(), 6, static_cast<float>(place.frame.nadir_to_horizon),
                     static_cast<float>(place.frame.zenith_to_horizon), static_cast<float>(place.frame.zenith_to_end));
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
    : beyond_programs_(library, {"above_ground.vert", "dark_sky.frag"}),
      air_programs_(library, {"fullscreen.vert", "dark_sky.frag"}), no_vertices_(make_vertex_array()) {}

void DarkSkyPass::prepare(const View& view, const FramePlan& plan) {
  const PlannedDarkSky& dark = *plan.dark_sky;
  const std::string projection = fmt::format("PROJECTION {}", static_cast<int>(view.projection));
  beyond_ = nullptr;
  if (dark.zodiacal || dark.starlight) {
    prepare_beyond(projection, view, plan);
  }
  map_ = smooth_texture(PlannedDarkSky::columns + 1, dark.air);
  air_ = nullptr;
  if (!dark.air_with_sky) {
    air_ = &air_programs_.get({projection});
    set_picture(*air_, view, plan);
    set_rows(*air_, PlannedDarkSky::rows_below, PlannedDarkSky::rows_above, *dark.place);
  }
}

void DarkSkyPass::prepare_beyond(const std::string& projection, const View& view, const FramePlan& plan) {
  const PlannedDarkSky& dark = *plan.dark_sky;
  std::vector<std::string> defines{projection, "BEYOND"};
  if (dark.zodiacal) {
    defines.emplace_back("ZODIACAL");
  }
  if (dark.starlight) {
    defines.emplace_back("MILKY_WAY");
  }
  beyond_ = &beyond_programs_.get(defines);
  set_picture(*beyond_, view, plan);
  beyond_tiles_ = set_tiles(*beyond_, view, 48);
  const bool ground = has(plan.options.layers, Layer::ground);
  glProgramUniform1f(beyond_->name(), 13, ground ? static_cast<float>(std::asin(plan.horizon_sin_altitude)) : -2.0F);
  set_rows(*beyond_, AirBeforeStars::rows_below, AirBeforeStars::rows_above, *dark.place);
  if (air_of_ != dark.place) {
    shares_ = smooth_texture(AirBeforeStars::hues, dark.place->air.shares);
    bends_ = make_row_texture(rgba_of(dark.place->air.bends));
    interpolate(bends_);
    air_of_ = dark.place;
  }
  const DarkSky& sources = dark.sources;
  const Mat3 horizon_from_view = glm::transpose(view_from_horizon(view));
  if (dark.zodiacal) {
    if (!zodiacal_) {
      zodiacal_ = smooth_texture(ZodiacalMap::columns, zodiacal_map().texels);
    }
    set_matrix(*beyond_, 7, sources.helioecliptic_from_horizon * horizon_from_view);
    glProgramUniform1f(beyond_->name(), 9, static_cast<float>(sources.zodiacal_scale));
    set_light(*beyond_, 10, sources.dust_corona);
    glProgramUniform1f(beyond_->name(), 11, static_cast<float>(sources.sin_sun_radius));
  }
  if (dark.starlight) {
    const auto& milky_way = sources.milky_way != nullptr ? sources.milky_way : default_milky_way();
    if (milky_way_of_ != milky_way) {
      milky_way_ = cube_of(*milky_way);
      milky_way_of_ = milky_way;
    }
    set_matrix(*beyond_, 8, sources.icrs_from_horizon * horizon_from_view);
  }
}

void DarkSkyPass::draw_beyond(const Strip& strip) {
  if (beyond_ == nullptr) {
    return;
  }
  glBindTextureUnit(0, zodiacal_.name());
  glBindTextureUnit(1, shares_.name());
  glBindTextureUnit(2, bends_.name());
  glBindTextureUnit(3, milky_way_.name());
  set_strip(*beyond_, strip);
  glUseProgram(beyond_->name());
  glBindVertexArray(no_vertices_.name());
  add_light([&] { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, beyond_tiles_); });
}

void DarkSkyPass::draw_air(const Strip& strip) {
  glBindTextureUnit(0, map_.name());
  set_strip(*air_, strip);
  glUseProgram(air_->name());
  glBindVertexArray(no_vertices_.name());
  add_light([] { glDrawArrays(GL_TRIANGLES, 0, 3); });
}

} // namespace vesper::gpu
