// Pictures of known light before an eye.
#pragma once

#include "render/render_fixture.hpp"
#include "support/view_of.hpp"

#include "vesper/gpu/eye_optics.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vesper::test {

/// X, Y, Z and S of each pixel, row 0 on top.
struct LightPicture {
  explicit LightPicture(const View& of, const glm::vec4& everywhere = {})
      : view(of), light(static_cast<std::size_t>(of.width) * static_cast<std::size_t>(of.height), everywhere) {}
  [[nodiscard]] glm::vec4& at(int column, int row) { return light[number(column, row)]; }
  [[nodiscard]] const glm::vec4& at(int column, int row) const { return light[number(column, row)]; }
  [[nodiscard]] std::size_t number(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(column);
  }

  View view;
  std::vector<glm::vec4> light;
};

inline gpu::Texture texture_of(const LightPicture& picture) {
  gpu::Texture texture = gpu::make_texture(picture.view.width, picture.view.height, gpu::PixelFormat::rgba32f);
  glTextureSubImage2D(texture.name(), 0, 0, 0, picture.view.width, picture.view.height, GL_RGBA, GL_FLOAT,
                      picture.light.data());
  return texture;
}

/// What the eye leaves of a picture and adds to it, between its texels as the GPU reads them.
class SeenPicture {
public:
  explicit SeenPicture(const gpu::EyeOptics& eye) {
    glGetTextureLevelParameteriv(eye.added().name(), 0, GL_TEXTURE_WIDTH, &width_);
    glGetTextureLevelParameteriv(eye.added().name(), 0, GL_TEXTURE_HEIGHT, &height_);
    added_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    shares_.resize(added_.size());
    read(eye.added(), added_);
    read(eye.shares(), shares_);
    glGetTextureParameteriv(eye.added().name(), GL_TEXTURE_WRAP_S, &wrap_);
  }
  [[nodiscard]] glm::vec4 added(const Vec2& pixel) const { return between(added_, pixel); }
  [[nodiscard]] glm::vec4 shares(const Vec2& pixel) const { return between(shares_, pixel); }
  [[nodiscard]] LightPicture extended(const LightPicture& picture) const {
    LightPicture seen = picture;
    for (int row = 0; row < picture.view.height; ++row) {
      for (int column = 0; column < picture.view.width; ++column) {
        const Vec2 pixel(column + 0.5, row + 0.5);
        seen.at(column, row) = shares(pixel).x * picture.at(column, row) + added(pixel);
      }
    }
    return seen;
  }

private:
  static void read(const gpu::Texture& texture, std::vector<glm::vec4>& texels) {
    glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)),
                      texels.data());
  }
  [[nodiscard]] const glm::vec4& texel(const std::vector<glm::vec4>& texels, int x, int y) const {
    const int column = wrap_ == GL_REPEAT ? (x + width_) % width_ : std::clamp(x, 0, width_ - 1);
    return texels[static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(column)];
  }
  [[nodiscard]] glm::vec4 between(const std::vector<glm::vec4>& texels, const Vec2& pixel) const {
    const Vec2 at = 0.25 * pixel - 0.5;
    const int x = static_cast<int>(std::floor(at.x));
    const int y = static_cast<int>(std::floor(at.y));
    const auto fx = static_cast<float>(at.x - x);
    const auto fy = static_cast<float>(at.y - y);
    return glm::mix(glm::mix(texel(texels, x, y), texel(texels, x + 1, y), fx),
                    glm::mix(texel(texels, x, y + 1), texel(texels, x + 1, y + 1), fx), fy);
  }

  int width_ = 0;
  int height_ = 0;
  int wrap_ = 0;
  std::vector<glm::vec4> added_;
  std::vector<glm::vec4> shares_;
};

/// Sum of luminance times solid angle.
inline double illuminance_of(const LightPicture& picture) {
  const f64::PixelFrame frame = pixel_frame(picture.view);
  double sum = 0.0;
  for (int row = 0; row < picture.view.height; ++row) {
    for (int column = 0; column < picture.view.width; ++column) {
      const double pixels = f64::pixels_per_steradian({column + 0.5, row + 0.5}, frame);
      sum += pixels > 0.0 ? static_cast<double>(picture.at(column, row).y) / pixels : 0.0;
    }
  }
  return sum;
}

} // namespace vesper::test
