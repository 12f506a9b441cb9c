#include "vesper/gpu/moon_pass.hpp"

#include "vesper/astro/constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <epoxy/gl.h>
#include <span>
#include <string>
#include <vector>

namespace vesper::gpu {
namespace {

/// shaders/moon_block.glsl in std140.
struct MoonBlock {
  std::array<std::array<float, 4>, 3> fixed_from_disc;
  std::array<float, 4> to_sun;
  std::array<float, 4> to_earth;
  std::array<float, 4> sunlit;
  std::array<float, 4> earthlit;
  std::array<float, 4> sun_law;
  std::array<float, 4> earth_law;
  float sun_radius_rad;
  std::array<float, 3> padding;
  std::array<float, 4> from_earth_km;
  f32::EarthShadow shadow;
  std::array<float, 2> more_padding;
  f32::LunarEclipseFrame eclipse;
  std::array<float, 3> last_padding;
  float map_level;
  float crescent_cells;
  std::array<float, 2> end;
};
static_assert(offsetof(MoonBlock, from_earth_km) == 160 && sizeof(f32::EarthShadow) == 24 &&
              offsetof(MoonBlock, eclipse) == 208 && sizeof(f32::LunarEclipseFrame) == 36 &&
              offsetof(MoonBlock, map_level) == 256 && sizeof(MoonBlock) == 272);

template <class V> std::array<float, 4> vector_of(const V& v) {
  std::array<float, 4> result{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(V::length()); ++i) {
    result.at(i) = static_cast<float>(v[static_cast<int>(i)]);
  }
  return result;
}

/// The mipmap whose texels are as wide as the cells at the disc's middle: one for all of it. Towards the limb cells
/// reach ever further over the sphere, but relief must not be smoothed away there: its mean light is not that of its
/// mean.
/// \param cells_of_radius into which pixels are cut
double map_level(const PlannedMoon& moon, double cells_of_radius) {
  const double cell = 1.0 / std::max(0.5 * moon.picture.width_px, cells_of_radius);
  return std::max(std::log2(0.5 * moon.globe->map.face_size * cell), 0.0);
}

MoonBlock block_of(const PlannedMoon& moon, MoonShading shading) {
  const f64::MoonLighting& light = moon.disc.lighting;
  const auto law = [](const f64::LunarLaw& from) { return vector_of(Vec2(from.seeliger, from.lambert)); };
  MoonBlock block{};
  for (std::size_t column = 0; column < 3; ++column) {
    block.fixed_from_disc.at(column) = vector_of(moon.disc.fixed_from_disc[static_cast<int>(column)]);
  }
  block.to_sun = vector_of(light.to_sun);
  block.to_earth = vector_of(light.to_earth);
  block.sunlit = vector_of(light.sunlit);
  block.earthlit = vector_of(light.earthlit);
  block.sun_law = law(light.sun_law);
  block.earth_law = law(light.earth_law);
  block.sun_radius_rad = static_cast<float>(light.sun_radius_rad);
  block.from_earth_km = vector_of(Vec4(moon.from_earth_km, moon_mean_radius.to(kilometre)));
  block.shadow = {f32::vec3(moon.shadow.axis), static_cast<float>(moon.shadow.sun_distance_km),
                  static_cast<float>(moon.shadow.sun_radius_km), static_cast<float>(moon.shadow.edge_radius_km)};
  const f64::LunarEclipseFrame& frame = moon.eclipse.frame;
  block.eclipse = {frame.kind,
                   frame.columns,
                   frame.rows,
                   static_cast<float>(frame.first_km),
                   static_cast<float>(frame.rows_per_km),
                   static_cast<float>(frame.edge_km),
                   static_cast<float>(frame.edge_per_km),
                   static_cast<float>(frame.inside_km),
                   static_cast<float>(frame.columns_per_km)};
  const bool whole_pixels = shading == MoonShading::surface && moon.crescent_cells > 0.0;
  block.map_level = static_cast<float>(map_level(moon, whole_pixels ? 1.0 : moon.picture.cells_of_radius));
  block.crescent_cells = static_cast<float>(moon.crescent_cells);
  return block;
}

Texture cube_of(const MoonMap& map) {
  Texture texture = make_cube_texture(map.face_size);
  fill_cube_texture(texture, 0, map.face_size, map.texels);
  glGenerateTextureMipmap(texture.name());
  require_no_error("copying the Moon's map");
  return texture;
}

/// The published map has no table.
Texture table_of(const LunarEclipseTable& eclipse) {
  std::vector<float> rgba(4, 0.0F);
  if (!eclipse.texels.empty()) {
    rgba.clear();
    for (const Vec4& texel : eclipse.texels) {
      for (int channel = 0; channel < 4; ++channel) {
        rgba.push_back(static_cast<float>(texel[channel]));
      }
    }
  }
  return make_table_texture(eclipse.texels.empty() ? 1 : eclipse.frame.columns, rgba);
}

} // namespace

MoonPass::MoonPass(const ShaderLibrary& library)
    : disc_(library, "moon.frag"), uniforms_(make_dynamic_buffer(sizeof(MoonBlock))) {}

void MoonPass::prepare(const SkyState& sky, const View& view, const FramePlan& plan, MoonShading shading) {
  const PlannedMoon& moon = *plan.moon;
  if (moon.picture.point || moon.picture.sprite) {
    disc_.prepare(moon.picture, sky, view, plan);
    return;
  }
  if (globe_ != moon.globe) {
    map_ = cube_of(moon.globe->map);
    globe_ = moon.globe;
  }
  std::vector<std::string> defines;
  if (shading == MoonShading::lambert) {
    defines.emplace_back("LAMBERT");
  } else if (moon.crescent_cells > 0.0) {
    defines.emplace_back("CRESCENT");
  } else if (moon.eclipse.frame.kind != f64::lunar_eclipse_none) {
    defines.emplace_back("ECLIPSE");
    eclipse_ = table_of(moon.eclipse);
  }
  disc_.prepare(moon.picture, sky, view, plan, defines);
  const MoonBlock block = block_of(moon, shading);
  update_buffer(uniforms_, std::as_bytes(std::span(&block, 1)));
}

void MoonPass::draw(const Strip& strip) {
  bind();
  disc_.draw(strip);
}

void MoonPass::hide(const Strip& strip) {
  bind();
  disc_.hide(strip);
}

void MoonPass::bind() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms_.name());
  glBindTextureUnit(2, map_.name());
  glBindTextureUnit(3, eclipse_.name());
}

} // namespace vesper::gpu
