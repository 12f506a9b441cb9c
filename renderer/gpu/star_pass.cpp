#include "vesper/gpu/star_pass.hpp"

#include "vesper/astro/star_place.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace vesper::gpu {
namespace {

/// shaders/star_block.glsl in std140.
struct StarBlock {
  std::array<std::array<double, 4>, 3> horizon_from_icrs;
  std::array<std::array<double, 4>, 3> view_from_horizon;
  std::array<double, 3> observer_au;
  double years;
  std::array<double, 3> velocity_c;
  double lorentz_inverse;
  std::array<double, 3> sun_to_observer;
  double solar_potential;
  std::array<double, 2> size;
  double focal;
  double seconds;
  std::array<float, 4> optical_depth;
  float observer_height_km;
  float exposure_s;
  float pupil_m;
  float sun_sin_altitude;
  float control_magnitude;
  std::int32_t copies;
  std::uint32_t seed;
  std::uint32_t frame_number;
  std::uint32_t star_count;
  std::uint32_t padding;
  std::array<float, 2> strip;
  std::array<float, 4> refraction_scales;
  std::array<float, 2> refraction_horizons;
  std::int32_t refraction_kind;
  float refraction_strength;
  std::int32_t extinction_rows;
  std::int32_t extinction_columns;
  float extinction_horizon;
  float extinction_width;
  float extinction_rows_per_x;
  float extinction_reddest;
  float extinction_columns_per_hue;
  std::uint32_t last_padding;
};
static_assert(offsetof(StarBlock, view_from_horizon) == 96 && offsetof(StarBlock, observer_au) == 192 &&
              offsetof(StarBlock, years) == 216 && offsetof(StarBlock, velocity_c) == 224 &&
              offsetof(StarBlock, sun_to_observer) == 256 && offsetof(StarBlock, size) == 288 &&
              offsetof(StarBlock, focal) == 304 && offsetof(StarBlock, seconds) == 312 &&
              offsetof(StarBlock, optical_depth) == 320 && offsetof(StarBlock, observer_height_km) == 336 &&
              offsetof(StarBlock, control_magnitude) == 352 && offsetof(StarBlock, strip) == 376 &&
              offsetof(StarBlock, refraction_scales) == 384 && offsetof(StarBlock, extinction_rows) == 416 &&
              sizeof(StarBlock) == 448);

/// What star.comp writes and star.vert reads, std430.
struct StarBillboard {
  std::array<float, 4> light;
  std::array<float, 4> pixel_and_scale;
  std::array<float, 4> box;
  std::array<float, 4> glare;
};
static_assert(sizeof(StarBillboard) == 64);

std::array<std::array<double, 4>, 3> columns(const Mat3& matrix) {
  std::array<std::array<double, 4>, 3> result{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& column = matrix[static_cast<int>(c)];
    result.at(c) = {column.x, column.y, column.z, 0.0};
  }
  return result;
}

std::array<double, 3> array_of(const Vec3& v) { return {v.x, v.y, v.z}; }

StarBlock star_block(const SkyState& sky, const View& view, const FramePlan& plan,
                     const f64::StarExtinctionFrame& extinction, double epoch_jyear) {
  const f64::StarPlaceFrame place = place_frame(sky.stars, epoch_jyear);
  const f64::ProjectionFrame projection = projection_frame(view);
  const AirOptions& air = plan.options.air;
  StarBlock block{};
  block.horizon_from_icrs = columns(sky.stars.horizon_from_icrs);
  block.view_from_horizon = columns(view_from_horizon(view));
  block.observer_au = array_of(place.observer_au);
  block.years = place.years;
  block.velocity_c = array_of(place.velocity_c);
  block.lorentz_inverse = place.lorentz_inverse;
  block.sun_to_observer = array_of(place.sun_to_observer);
  block.solar_potential = place.solar_potential;
  block.size = {projection.size.x, projection.size.y};
  block.focal = projection.focal;
  block.seconds = sky.seconds;
  for (std::size_t c = 0; c < 4; ++c) {
    block.optical_depth.at(c) = static_cast<float>(plan.optical_depth[static_cast<int>(c)]);
  }
  block.observer_height_km = static_cast<float>(sky.observer.height.to(kilometre));
  block.exposure_s = static_cast<float>(air.exposure_s);
  block.pupil_m = air.scintillation ? static_cast<float>(air.pupil_m) : 0.0F;
  // Where the sky is drawn, its light makes the stars fade: the cheap tier's own fade counts as at night.
  block.sun_sin_altitude = plan.lights.empty() ? static_cast<float>(std::sin(sky.sun.altitude.to(rad))) : -1.0F;
  block.control_magnitude = static_cast<float>(plan.options.control_magnitude);
  block.copies = plan.star_copies;
  block.seed = plan.options.seed;
  block.frame_number = plan.options.frame_number;
  block.star_count = static_cast<std::uint32_t>(plan.star_count);
  const f64::RefractionFrame refraction = refraction_frame(plan.refraction);
  block.refraction_scales = {static_cast<float>(refraction.scale_apparent.x),
                             static_cast<float>(refraction.scale_apparent.y),
                             static_cast<float>(refraction.scale_true.x), static_cast<float>(refraction.scale_true.y)};
  block.refraction_horizons = {static_cast<float>(refraction.horizon_apparent),
                               static_cast<float>(refraction.horizon_true)};
  block.refraction_kind = refraction.kind;
  block.refraction_strength = static_cast<float>(refraction.strength);
  block.extinction_rows = extinction.rows;
  block.extinction_columns = extinction.columns;
  block.extinction_horizon = static_cast<float>(extinction.sin_horizon);
  block.extinction_width = static_cast<float>(extinction.width);
  block.extinction_rows_per_x = static_cast<float>(extinction.rows_per_x);
  block.extinction_reddest = static_cast<float>(extinction.reddest);
  block.extinction_columns_per_hue = static_cast<float>(extinction.columns_per_hue);
  return block;
}

template <class T> std::span<const std::byte> bytes_of(const T& value) { return std::as_bytes(std::span(&value, 1)); }

constexpr GLuint billboard_attributes = 4;
constexpr GLuint invocations_per_group = 64;

/// The number that seeds a star's scintillation: its HR number, or its row for stars without one.
std::vector<std::uint32_t> scintillation_numbers(const StarCatalogue& catalogue) {
  constexpr std::uint32_t row_flag = 0x80000000U;
  std::vector<std::uint32_t> numbers(catalogue.stars.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::uint32_t hr = i < catalogue.identities.size() ? catalogue.identities[i].hr : 0;
    numbers[i] = hr != 0 ? hr : (row_flag | static_cast<std::uint32_t>(i));
  }
  return numbers;
}

} // namespace

StarPass::StarPass(const ShaderLibrary& library, std::vector<std::string> defines)
    : defines_(std::move(defines)), place_programs_(library, {"star.comp"}),
      draw_programs_(library, {"star.vert", "star.frag"}), uniforms_(make_dynamic_buffer(sizeof(StarBlock))),
      vertices_(make_vertex_array()) {
  for (GLuint location = 0; location < billboard_attributes; ++location) {
    glEnableVertexArrayAttrib(vertices_.name(), location);
    glVertexArrayAttribFormat(vertices_.name(), location, 4, GL_FLOAT, GL_FALSE,
                              location * static_cast<GLuint>(4 * sizeof(float)));
    glVertexArrayAttribBinding(vertices_.name(), location, 0);
  }
  glVertexArrayBindingDivisor(vertices_.name(), 0, 1);
}

void StarPass::load(const StarCatalogue& catalogue) {
  billboards_ = Buffer();
  epoch_jyear_ = catalogue.provenance.epoch_jyear;
  if (catalogue.stars.empty()) {
    return;
  }
  records_ = make_static_buffer(std::as_bytes(std::span(catalogue.stars)));
  const std::vector<std::uint32_t> numbers = scintillation_numbers(catalogue);
  numbers_ = make_static_buffer(std::as_bytes(std::span(numbers)));
  billboards_ = make_dynamic_buffer(catalogue.stars.size() * std::size_t{most_star_copies} * sizeof(StarBillboard));
  glVertexArrayVertexBuffer(vertices_.name(), 0, billboards_.name(), 0, sizeof(StarBillboard));
}

void StarPass::place(const SkyState& sky, const View& view, const FramePlan& plan, StarShading shading) {
  instances_ = plan.star_count * static_cast<std::size_t>(plan.star_copies);
  if (instances_ == 0) {
    return;
  }
  std::vector<std::string> defines{fmt::format("PROJECTION {}", static_cast<int>(view.projection))};
  if (plan.cheap_stars) {
    defines.emplace_back("CHEAP");
  }
  std::vector<std::string> place_defines = defines;
  place_defines.insert(place_defines.end(), defines_.begin(), defines_.end());
  const ProgramHandle& place_program = place_programs_.get(place_defines);
  if (shading == StarShading::constant_color) {
    defines.emplace_back("CONSTANT_COLOR");
  }
  draw_program_ = &draw_programs_.get(defines);
  refraction_.update(plan.refraction);
  extinction_.update(plan.extinction);
  update_buffer(uniforms_, bytes_of(star_block(sky, view, plan, extinction_.frame(), epoch_jyear_)));

  glUseProgram(place_program.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, records_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, numbers_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, billboards_.name());
  refraction_.bind(0);
  extinction_.bind(1);
  const auto groups = (static_cast<GLuint>(plan.star_count) + invocations_per_group - 1) / invocations_per_group;
  glDispatchCompute(groups, 1, 1);
  glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

void StarPass::mark(PointTiles& tiles) const {
  constexpr std::size_t stride = sizeof(StarBillboard) / sizeof(PointTiles::Box);
  constexpr std::size_t first = offsetof(StarBillboard, box) / sizeof(PointTiles::Box);
  if (instances_ > 0) {
    tiles.mark(billboards_, instances_, first, stride);
  }
}

void StarPass::draw(const Strip& strip) {
  if (instances_ == 0) {
    return;
  }
  const std::array<float, 2> rows{static_cast<float>(strip.first_row), static_cast<float>(strip.rows)};
  glNamedBufferSubData(uniforms_.name(), offsetof(StarBlock, strip), sizeof(rows), rows.data());
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glUseProgram(draw_program_->name());
  glBindVertexArray(vertices_.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances_));
  glDisable(GL_BLEND);
}

} // namespace vesper::gpu
