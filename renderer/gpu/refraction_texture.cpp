#include "vesper/gpu/refraction_texture.hpp"

#include <epoxy/gl.h>
#include <vector>

namespace vesper::gpu {

void RefractionTexture::update(const Refraction& refraction) {
  if (texture_ && refraction.table == table_) {
    return;
  }
  table_ = refraction.table;
  std::vector<float> rgba(4, 0.0F);
  if (table_ != nullptr) {
    rgba.clear();
    for (const Vec4& texel : table_->texels) {
      for (int channel = 0; channel < 4; ++channel) {
        rgba.push_back(static_cast<float>(texel[channel]));
      }
    }
  }
  texture_ = make_row_texture(rgba);
}

void RefractionTexture::bind(unsigned int unit) const { glBindTextureUnit(unit, texture_.name()); }

} // namespace vesper::gpu
