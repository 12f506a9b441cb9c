#include "vesper/gpu/disc_pass.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <span>

namespace vesper::gpu {
namespace {

constexpr std::size_t most_boxes = 6;
constexpr std::size_t most_sprite_bytes = sizeof(SpritePixel) * largest_sprite_edge * largest_sprite_edge;
static_assert(sizeof(SpritePixel) == 32 && offsetof(SpritePixel, cover) == 16);

/// shaders/disc_block.glsl in std140.
struct DiscBlock {
  f32::DiscFrame disc;
  f32::RefractionFrame refraction;
  f32::StarExtinctionFrame extinction;
  float padding;
  std::array<float, 4> optical_depth;
  std::array<float, 2> size;
  float focal;
  float height_km;
  std::array<float, 2> strip;
  float cells_of_radius;
  float more_padding;
  std::array<std::array<float, 4>, most_boxes> boxes;
};
static_assert(sizeof(f32::DiscFrame) == 80 && sizeof(f32::RefractionFrame) == 32 &&
              sizeof(f32::StarExtinctionFrame) == 28 && offsetof(f32::RefractionFrame, scale_apparent) == 16);
static_assert(offsetof(DiscBlock, refraction) == 80 && offsetof(DiscBlock, extinction) == 112 &&
              offsetof(DiscBlock, optical_depth) == 144 && offsetof(DiscBlock, strip) == 176 &&
              offsetof(DiscBlock, boxes) == 192 && sizeof(DiscBlock) == 288);

f32::DiscFrame single(const f64::DiscFrame& disc) {
  return {disc.centre,           float(disc.sine),      disc.right,
          float(disc.scale),     disc.upward,           float(disc.flattening),
          disc.zenith,           float(disc.along),     float(disc.turn),
          float(disc.up_centre), float(disc.up_zenith), 0.0F};
}

f32::RefractionFrame single(const f64::RefractionFrame& frame) {
  return {frame.kind,           float(frame.strength), float(frame.horizon_apparent), float(frame.horizon_true),
          frame.scale_apparent, frame.scale_true};
}

f32::StarExtinctionFrame single(const f64::StarExtinctionFrame& frame) {
  return {frame.rows,
          frame.columns,
          float(frame.sin_horizon),
          float(frame.width),
          float(frame.rows_per_x),
          float(frame.reddest),
          float(frame.columns_per_hue)};
}

} // namespace

DiscPass::DiscPass(const ShaderLibrary& library, const std::string& fragment_stage)
    : programs_(library, {"disc.vert", fragment_stage}), sprite_programs_(library, {"disc.vert", "sprite.frag"}),
      point_(library), uniforms_(make_dynamic_buffer(sizeof(DiscBlock))),
      sprite_(make_dynamic_buffer(most_sprite_bytes)), no_vertices_(make_vertex_array()) {}

void DiscPass::prepare(const PlannedDisc& disc, const SkyState& sky, const View& view, const FramePlan& plan,
                       const std::vector<std::string>& defines) {
  is_point_ = disc.point.has_value();
  if (is_point_) {
    point_.place(*disc.point, sky, view, plan);
    return;
  }
  std::vector<std::string> all{fmt::format("PROJECTION {}", static_cast<int>(view.projection))};
  if (plan.cheap_stars) {
    all.emplace_back("CHEAP");
  }
  all.insert(all.end(), defines.begin(), defines.end());
  program_ = disc.sprite ? &sprite_programs_.get({}) : &programs_.get(all);
  if (disc.sprite) {
    update_buffer(sprite_, std::as_bytes(std::span(disc.sprite->pixels)));
  }
  refraction_.update(plan.refraction);
  extinction_.update(plan.sunlight_extinction);

  DiscBlock block{};
  block.disc = single(disc.frame);
  block.refraction = single(refraction_frame(plan.refraction));
  block.extinction = single(extinction_.frame());
  for (std::size_t c = 0; c < 4; ++c) {
    block.optical_depth.at(c) = static_cast<float>(plan.optical_depth[static_cast<int>(c)]);
  }
  block.size = {static_cast<float>(view.width), static_cast<float>(view.height)};
  block.focal = static_cast<float>(projection_frame(view).focal);
  block.height_km = static_cast<float>(plan.observer_height.to(kilometre));
  block.cells_of_radius = static_cast<float>(disc.cells_of_radius);
  boxes_ = static_cast<int>(disc.boxes.size());
  for (std::size_t i = 0; i < disc.boxes.size(); ++i) {
    const PixelBox& box = disc.boxes[i];
    block.boxes.at(i) = {static_cast<float>(box.low_x), static_cast<float>(box.low_y), static_cast<float>(box.high_x),
                         static_cast<float>(box.high_y)};
  }
  update_buffer(uniforms_, std::as_bytes(std::span(&block, 1)));
}

void DiscPass::draw(const Strip& strip, bool shines) {
  if (is_point_) {
    point_.draw(strip);
    return;
  }
  const std::array<float, 2> rows{static_cast<float>(strip.first_row), static_cast<float>(strip.rows)};
  glNamedBufferSubData(uniforms_.name(), offsetof(DiscBlock, strip), sizeof(rows), rows.data());
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, sprite_.name());
  refraction_.bind(0);
  extinction_.bind(1);
  glEnable(GL_BLEND);
  glBlendFunc(shines ? GL_ONE : GL_ZERO, GL_ONE_MINUS_SRC1_COLOR);
  glUseProgram(program_->name());
  glBindVertexArray(no_vertices_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, boxes_);
  glDisable(GL_BLEND);
}

} // namespace vesper::gpu
