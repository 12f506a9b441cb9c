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
  std::array<float, 2> strip;
};
static_assert(offsetof(StarBlock, view_from_horizon) == 96 && offsetof(StarBlock, observer_au) == 192 &&
              offsetof(StarBlock, years) == 216 && offsetof(StarBlock, velocity_c) == 224 &&
              offsetof(StarBlock, sun_to_observer) == 256 && offsetof(StarBlock, size) == 288 &&
              offsetof(StarBlock, focal) == 304 && offsetof(StarBlock, seconds) == 312 &&
              offsetof(StarBlock, optical_depth) == 320 && offsetof(StarBlock, observer_height_km) == 336 &&
              offsetof(StarBlock, control_magnitude) == 352 && offsetof(StarBlock, strip) == 368);

std::array<std::array<double, 4>, 3> columns(const Mat3& matrix) {
  std::array<std::array<double, 4>, 3> result{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& column = matrix[static_cast<int>(c)];
    result.at(c) = {column.x, column.y, column.z, 0.0};
  }
  return result;
}

std::array<double, 3> array_of(const Vec3& v) { return {v.x, v.y, v.z}; }

StarBlock star_block(const SkyState& sky, const View& view, const FramePlan& plan) {
  const f64::StarPlaceFrame place = place_frame(sky.stars);
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
  block.sun_sin_altitude = static_cast<float>(std::sin(sky.sun.altitude.to(rad)));
  block.control_magnitude = static_cast<float>(plan.options.control_magnitude);
  block.copies = plan.star_copies;
  block.seed = plan.options.seed;
  block.frame_number = plan.options.frame_number;
  return block;
}

template <class T> std::span<const std::byte> bytes_of(const T& value) { return std::as_bytes(std::span(&value, 1)); }

struct Attribute {
  GLint components;
  std::size_t offset;
};
constexpr std::array<Attribute, 6> record_attributes{{{3, offsetof(StarRecord, position)},
                                                      {3, offsetof(StarRecord, proper_motion)},
                                                      {1, offsetof(StarRecord, parallax)},
                                                      {1, offsetof(StarRecord, radial_velocity)},
                                                      {1, offsetof(StarRecord, illuminance)},
                                                      {4, offsetof(StarRecord, color)}}};
constexpr GLuint record_binding = 0;
constexpr GLuint number_binding = 1;
constexpr GLuint number_location = record_attributes.size();

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

StarPass::StarPass(const ShaderLibrary& library)
    : programs_(library, {"star.vert", "star.frag"}), uniforms_(make_dynamic_buffer(sizeof(StarBlock))),
      vertices_(make_vertex_array()) {}

void StarPass::load(const StarCatalogue& catalogue) {
  if (catalogue.stars.empty()) {
    return;
  }
  records_ = make_static_buffer(std::as_bytes(std::span(catalogue.stars)));
  const std::vector<std::uint32_t> numbers = scintillation_numbers(catalogue);
  numbers_ = make_static_buffer(std::as_bytes(std::span(numbers)));

  const GLuint vertices = vertices_.name();
  glVertexArrayVertexBuffer(vertices, record_binding, records_.name(), 0, sizeof(StarRecord));
  glVertexArrayVertexBuffer(vertices, number_binding, numbers_.name(), 0, sizeof(std::uint32_t));
  for (GLuint location = 0; location < record_attributes.size(); ++location) {
    const Attribute& attribute = record_attributes.at(location);
    glEnableVertexArrayAttrib(vertices, location);
    glVertexArrayAttribFormat(vertices, location, attribute.components, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(attribute.offset));
    glVertexArrayAttribBinding(vertices, location, record_binding);
  }
  glEnableVertexArrayAttrib(vertices, number_location);
  glVertexArrayAttribIFormat(vertices, number_location, 1, GL_UNSIGNED_INT, 0);
  glVertexArrayAttribBinding(vertices, number_location, number_binding);
}

void StarPass::prepare(const SkyState& sky, const View& view, const FramePlan& plan, StarShading shading) {
  std::vector<std::string> defines{fmt::format("PROJECTION {}", static_cast<int>(view.projection))};
  if (plan.cheap_stars) {
    defines.emplace_back("CHEAP");
  }
  if (shading == StarShading::constant_color) {
    defines.emplace_back("CONSTANT_COLOR");
  }
  program_ = &programs_.get(defines);
  update_buffer(uniforms_, bytes_of(star_block(sky, view, plan)));
  const auto copies = static_cast<GLuint>(plan.star_copies);
  glVertexArrayBindingDivisor(vertices_.name(), record_binding, copies);
  glVertexArrayBindingDivisor(vertices_.name(), number_binding, copies);
  instances_ = plan.star_count * static_cast<std::size_t>(plan.star_copies);
}

void StarPass::draw(const Strip& strip) {
  if (instances_ == 0) {
    return;
  }
  const std::array<float, 2> rows{static_cast<float>(strip.first_row), static_cast<float>(strip.rows)};
  glNamedBufferSubData(uniforms_.name(), offsetof(StarBlock, strip), sizeof(rows), rows.data());
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glUseProgram(program_->name());
  glBindVertexArray(vertices_.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances_));
  glDisable(GL_BLEND);
}

} // namespace vesper::gpu
