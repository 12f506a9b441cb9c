#include "vesper/gpu/sky_textures.hpp"

#include "vesper/atmosphere/small_sky_tables.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <epoxy/gl.h>
#include <span>
#include <vector>

namespace vesper::gpu {
namespace {

std::span<const float> floats(const std::vector<f32::vec4>& texels) {
  static_assert(sizeof(f32::vec4) == 4 * sizeof(float));
  return {&texels.front().x, 4 * texels.size()};
}

/// shaders/small_sky_block.glsl in std140.
struct SmallSkyBlock {
  std::array<float, 16> responses;
  float ground_km;
  float top_km;
  float light_radius_rad;
  float depolarization;
  std::int32_t levels;
  std::int32_t multiple_nodes;
  std::int32_t steps;
  std::int32_t transmittance_altitudes;
  std::int32_t transmittance_heights;
  std::array<std::int32_t, 3> padding;
};
static_assert(sizeof(SmallSkyBlock) == 112);

SmallSkyBlock block_of(const SmallSkyTables& tables) {
  const f32::SmallSkyFrame& frame = tables.frame;
  SmallSkyBlock block{{},
                      frame.ground_km,
                      frame.top_km,
                      frame.light_radius_rad,
                      frame.depolarization,
                      frame.levels,
                      frame.multiple_nodes,
                      frame.steps,
                      tables.transmittance_frame.altitudes,
                      tables.transmittance_frame.heights,
                      {}};
  std::copy_n(&tables.responses[0].x, block.responses.size(), block.responses.begin());
  return block;
}

} // namespace

SkyTextures::SkyTextures(std::shared_ptr<const SkyTables> tables)
    : tables_(std::move(tables)),
      transmittance_(make_table_texture(tables_->transmittance_frame.altitudes, floats(tables_->transmittance))),
      ground_(make_row_texture(floats(tables_->ground))) {
  if (tables_->small) {
    const SmallSkyTables& small = *tables_->small;
    small_air_ = make_table_texture(small.frame.levels, floats(small.air));
    small_transmittance_ = make_table_texture(small.transmittance_frame.altitudes, floats(small.transmittance));
    small_multiple_ = make_table_texture(small.frame.multiple_nodes, floats(small.multiple));
    const SmallSkyBlock block = block_of(small);
    small_block_ = make_dynamic_buffer(sizeof(block));
    update_buffer(small_block_, std::as_bytes(std::span(&block, 1)));
    return;
  }
  const f32::sampler3D size = sampler(*tables_, tables_->other);
  other_ = make_volume_texture(size.width, size.height, size.depth);
  aerosol_ = make_volume_texture(size.width, size.height, size.depth);
}

void SkyTextures::bind_small() const {
  glBindTextureUnit(5, small_air_.name());
  glBindTextureUnit(6, small_transmittance_.name());
  glBindTextureUnit(7, small_multiple_.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 2, small_block_.name());
}

bool SkyTextures::upload(std::size_t bytes) {
  if (tables_->small) {
    return true;
  }
  const f32::sampler3D size = sampler(*tables_, tables_->other);
  const auto height = static_cast<std::size_t>(size.height);
  const std::size_t rows = 2 * height * static_cast<std::size_t>(size.depth);
  const std::size_t row_bytes = static_cast<std::size_t>(size.width) * sizeof(f32::vec4);
  std::size_t budget = std::max<std::size_t>(1, bytes / row_bytes);
  while (budget > 0 && rows_done_ < rows) {
    const std::size_t count = std::min(budget, height - rows_done_ % height); // of one height of one table
    upload_rows(rows_done_, count);
    rows_done_ += count;
    budget -= count;
  }
  return rows_done_ == rows;
}

void SkyTextures::upload_rows(std::size_t first, std::size_t count) {
  const f32::sampler3D size = sampler(*tables_, tables_->other);
  const auto height = static_cast<std::size_t>(size.height);
  const auto depth = static_cast<std::size_t>(size.depth);
  const bool is_other = first < height * depth;
  const std::size_t row = is_other ? first : first - height * depth;
  const std::vector<f32::vec4>& texels = is_other ? tables_->other : tables_->aerosol;
  glTextureSubImage3D((is_other ? other_ : aerosol_).name(), 0, 0, static_cast<GLint>(row % height),
                      static_cast<GLint>(row / height), size.width, static_cast<GLsizei>(count), 1, GL_RGBA, GL_FLOAT,
                      &texels[row * static_cast<std::size_t>(size.width)]);
}

} // namespace vesper::gpu
