#include "vesper/gpu/sky_textures.hpp"

#include <algorithm>
#include <epoxy/gl.h>
#include <span>
#include <vector>

namespace vesper::gpu {
namespace {

std::span<const float> floats(const std::vector<f32::vec4>& texels) {
  static_assert(sizeof(f32::vec4) == 4 * sizeof(float));
  return {&texels.front().x, 4 * texels.size()};
}

} // namespace

SkyTextures::SkyTextures(std::shared_ptr<const SkyTables> tables)
    : tables_(std::move(tables)),
      transmittance_(make_table_texture(tables_->transmittance_frame.altitudes, floats(tables_->transmittance))),
      ground_(make_row_texture(floats(tables_->ground))) {
  const f32::sampler3D size = sampler(*tables_, tables_->other);
  other_ = make_volume_texture(size.width, size.height, size.depth);
  aerosol_ = make_volume_texture(size.width, size.height, size.depth);
}

bool SkyTextures::upload(std::size_t bytes) {
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
