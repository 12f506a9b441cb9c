#include "vesper/gpu/extinction_texture.hpp"

#include <epoxy/gl.h>
#include <vector>

namespace vesper::gpu {
namespace {

/// A table that leaves all light: four texels whose logarithms are 0.
StarExtinction no_extinction() {
  StarExtinction table;
  table.frame.rows = 2;
  table.frame.columns = 2;
  table.frame.width = 1.0;
  table.texels.resize(4, Vec4(0.0));
  return table;
}

} // namespace

void ExtinctionTexture::update(const std::shared_ptr<const PlannedExtinction>& planned) {
  if (texture_ && planned == planned_) {
    return;
  }
  static const StarExtinction none = no_extinction();
  planned_ = planned;
  const StarExtinction* table = &none;
  if (planned_ != nullptr) {
    table = &planned_->table;
  }
  frame_ = table->frame;
  std::vector<float> rgba;
  for (const Vec4& texel : table->texels) {
    for (int channel = 0; channel < 4; ++channel) {
      rgba.push_back(static_cast<float>(texel[channel]));
    }
  }
  texture_ = make_table_texture(frame_.columns, rgba);
}

void ExtinctionTexture::bind(unsigned int unit) const { glBindTextureUnit(unit, texture_.name()); }

} // namespace vesper::gpu
