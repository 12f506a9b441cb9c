#include "vesper/gpu/sky_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <epoxy/gl.h>
#include <numbers>
#include <span>

namespace vesper::gpu {
namespace {

constexpr std::size_t most_lights = 2;
constexpr int most_shared_lights = 64; ///< of a table, in a group's memory: shaders/sky_map.comp
constexpr int phase_texels = 1024;
constexpr int ground_texels = 1024;

struct SkyBlockLight {
  std::array<float, 16> xyzs_from_sunlight;
  std::array<float, 4> direction;
  std::array<float, 4> apparent;
};

/// shaders/sky_block.glsl in std140.
struct SkyBlock {
  std::array<SkyBlockLight, most_lights> lights;
  std::array<float, 4> sunlight;
  std::array<float, 4> albedo;
  float ground_km;
  float top_km;
  std::int32_t heights;
  std::int32_t views_below;
  std::int32_t views_above;
  std::int32_t table_lights;
  std::int32_t transmittance_altitudes;
  std::int32_t transmittance_heights;
  float height_km;
  std::int32_t light_count;
  float share;
  std::int32_t map_rows_below;
  std::int32_t map_rows_above;
  float sin_horizon;
  float sin_highest;
  float padding;
  std::array<float, 4> map_half_sines;
};
static_assert(sizeof(SkyBlockLight) == 96 && offsetof(SkyBlock, sunlight) == 192 &&
              offsetof(SkyBlock, ground_km) == 224 && offsetof(SkyBlock, height_km) == 256 &&
              offsetof(SkyBlock, map_half_sines) == 288 && sizeof(SkyBlock) == 304);

std::array<float, 4> array_of(const Vec3& v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

std::array<float, 4> array_of(const f32::vec4& v) { return {v.x, v.y, v.z, v.w}; }

SkyBlockLight block_of(const PlannedLight& light) {
  SkyBlockLight block{};
  for (std::size_t i = 0; i < 16; ++i) {
    block.xyzs_from_sunlight.at(i) =
        static_cast<float>(light.xyzs_from_sunlight[static_cast<int>(i / 4)][static_cast<int>(i % 4)]);
  }
  block.direction = array_of(light.direction, light.angular_radius.to(rad));
  block.apparent = array_of(light.apparent_direction, 0.0);
  return block;
}

bool is_outside(const SkyTables& tables, Length height) {
  return height.to(kilometre) > static_cast<double>(tables.frame.top_km - tables.frame.ground_km);
}

SkyBlock block_of(const SkyTables& tables, const FramePlan& plan, Length height, double share) {
  const f32::SkyTableFrame& frame = tables.frame;
  SkyBlock block{};
  block.light_count = static_cast<std::int32_t>(std::min(plan.lights.size(), most_lights));
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.light_count); ++i) {
    block.lights.at(i) = block_of(plan.lights[i]);
  }
  block.sunlight = array_of(tables.light);
  if (has(plan.options.layers, Layer::ground)) {
    block.albedo = array_of(tables.albedo);
  }
  block.ground_km = frame.ground_km;
  block.top_km = frame.top_km;
  block.heights = frame.heights;
  block.views_below = frame.views_below;
  block.views_above = frame.views_above;
  block.table_lights = frame.lights;
  block.transmittance_altitudes = tables.transmittance_frame.altitudes;
  block.transmittance_heights = tables.transmittance_frame.heights;
  block.height_km = static_cast<float>(height.to(kilometre));
  block.share = static_cast<float>(share);
  block.sin_horizon = static_cast<float>(plan.horizon_sin_altitude);
  block.sin_highest = 1.0F;
  if (is_outside(tables, height)) {
    const float limb = f32::sky_dip(block.height_km, frame) - f32::sky_limb_dip(block.height_km, frame);
    block.sin_highest = static_cast<float>(std::sin(std::asin(plan.horizon_sin_altitude) + static_cast<double>(limb)));
  }
  const f32::SkyMapFrame map = f32::sky_map_frame(block.sin_horizon, block.sin_highest);
  block.map_half_sines = {map.nadir_to_horizon, map.zenith_to_horizon, map.zenith_to_end, 0.0F};
  block.map_rows_below = SkyMap::rows_below;
  block.map_rows_above = SkyMap::rows_above;
  return block;
}

GLuint groups(int size, int group) { return static_cast<GLuint>((size + group - 1) / group); }

} // namespace

SkyMap::SkyMap(const ShaderLibrary& library)
    : slice_programs_(library, {"sky_slice.comp"}), ground_program_(build_program(library, {"sky_ground.comp"})),
      map_programs_(library, {"sky_map.comp"}), eclipse_map_(library),
      map_(make_texture(columns + 1, (1 + static_cast<int>(most_lights)) * (rows_below + rows_above),
                        PixelFormat::rgba32f)),
      ground_(make_texture(ground_texels, static_cast<int>(most_lights), PixelFormat::rgba32f)),
      uniforms_(make_dynamic_buffer(sizeof(SkyBlock))) {
  interpolate(map_);
  interpolate(ground_);
}

void SkyMap::fill(const SkyTextures& tables, const FramePlan& plan, Length height, double share) {
  const SkyBlock block = block_of(*tables.tables(), plan, height, share);
  update_buffer(uniforms_, std::as_bytes(std::span(&block, 1)));
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms_.name());
  fill_phase(tables.tables(), block.share);
  const bool outside = is_outside(*tables.tables(), height);
  if (!outside) {
    fill_slices(tables, plan);
  }
  fill_ground(tables);
  const bool small = tables.tables()->small != nullptr;
  std::vector<std::string> variant;
  if (outside) {
    variant.emplace_back("OUTSIDE");
    if (small) {
      variant.emplace_back("SMALL");
      tables.bind_small();
    } else if (tables.tables()->frame.lights > most_shared_lights) {
      variant.emplace_back("MANY_LIGHTS");
    }
  }
  const ProgramHandle& program = map_programs_.get(variant);
  glUseProgram(program.name());
  glBindTextureUnit(0, tables.transmittance().name());
  glBindTextureUnit(1, ground_.name());
  glBindTextureUnit(2, phase_texture_.name());
  if (!outside) {
    glBindTextureUnit(3, slices_.name());
  } else if (!small) {
    glBindTextureUnit(3, tables.other().name());
    glBindTextureUnit(4, tables.aerosol().name());
  }
  glBindImageTexture(0, map_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  glDispatchCompute(rows_below + rows_above, 1, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void SkyMap::fill_slices(const SkyTextures& tables, const FramePlan& plan) {
  const f32::SkyTableFrame& frame = tables.tables()->frame;
  const int rows = frame.views_below + frame.views_above;
  if (slice_rows_ != rows) {
    slices_ = make_texture(2 * static_cast<int>(most_lights) * f32::sky_azimuths, rows, PixelFormat::rgba32f);
    slice_rows_ = rows;
  }
  const bool small = tables.tables()->small != nullptr;
  const GLuint program =
      slice_programs_.get(small ? std::vector<std::string>{"SMALL"} : std::vector<std::string>{}).name();
  if (small) {
    tables.bind_small();
  }
  glUseProgram(program);
  write_image(0, slices_, 0, GL_RGBA32F);
  const int slices = 2 * static_cast<int>(std::min(plan.lights.size(), most_lights));
  for (int slice = 0; slice < slices; ++slice) {
    glProgramUniform1i(program, 0, slice / 2);
    glProgramUniform1i(program, 1, slice);
    if (!small) {
      glBindTextureUnit(0, (slice % 2 == 0 ? tables.other() : tables.aerosol()).name());
    }
    glDispatchCompute(1, groups(rows, 8), 1);
  }
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void SkyMap::fill_ground(const SkyTextures& tables) {
  glUseProgram(ground_program_.name());
  glBindTextureUnit(0, tables.transmittance().name());
  glBindTextureUnit(1, tables.ground().name());
  write_image(0, ground_, 0, GL_RGBA32F);
  glDispatchCompute(groups(ground_texels, 64), most_lights, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void SkyMap::fill_phase(const std::shared_ptr<const SkyTables>& tables, float share) {
  if (phase_of_ == tables && share == 1.0F) {
    return;
  }
  phase_of_ = share == 1.0F ? tables : nullptr;
  phase_.resize(std::size_t{4} * phase_texels);
  const auto log2_phase = [&](float cos_angle) {
    return std::log2(
        f32::sky_aerosol_phase(line_sampler(tables->phase), cos_angle, static_cast<int>(tables->phase.size())));
  };
  for (std::size_t i = 0; i < phase_texels; ++i) {
    const float half_sine2 = std::pow(static_cast<float>(i) / (phase_texels - 1), 4.0F);
    const float near_cos = 1.0F - half_sine2 * (1.0F - f32::sky_peak_cos);
    const float peak = std::exp2(log2_phase(near_cos)) - std::exp2(log2_phase_without_peak(*tables, near_cos));
    phase_[4 * i] = glm::mix(phase_[4 * i], peak, share);
    phase_[4 * i + 1] = glm::mix(phase_[4 * i + 1], log2_phase_without_peak(*tables, 1.0F - 2.0F * half_sine2), share);
  }
  phase_texture_ = make_row_texture(phase_);
  interpolate(phase_texture_);
}

void SkyMap::eclipse(const SkyTables& tables, const FramePlan& plan, Length height) {
  if (plan.eclipse.sky == nullptr) {
    return;
  }
  const SkyBlock block = block_of(tables, plan, height, 1.0);
  const float dip = f32::sky_dip(block.height_km, tables.frame);
  const double end = is_outside(tables, height) ? -static_cast<double>(f32::sky_limb_dip(block.height_km, tables.frame))
                                                : 0.5 * std::numbers::pi;
  const auto angle = [](float sine) { return static_cast<double>(f32::sky_arc_sine(sine)); };
  eclipse_map_.dim(map_, {columns + 1, rows_below, rows_above},
                   {f32::sky_map_frame(block.sin_horizon, block.sin_highest), angle(block.sin_horizon),
                    angle(block.sin_highest), -static_cast<double>(dip), end},
                   plan);
}

void SkyMap::bind() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, uniforms_.name());
  glBindTextureUnit(0, map_.name());
  glBindTextureUnit(1, phase_texture_.name());
}

} // namespace vesper::gpu
