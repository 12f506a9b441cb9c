// Light through a display chain, and what leaves the display.
#pragma once

#include "render/render_fixture.hpp"

#include "vesper/gpu/display_chain.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/point_tiles.hpp"

#include <epoxy/gl.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vesper::test {

/// A picture's light: X, Y, Z, S of each pixel.
struct PictureLight {
  View view;
  std::vector<float> frame;
  std::vector<float> points; ///< part of it; empty for none
};

inline View square_view(int side, Angle fov = 60.0 * deg) {
  View view;
  view.projection = Projection::perspective;
  view.fov = fov;
  view.width = view.height = side;
  return view;
}

/// Even light of the display's white.
inline PictureLight even_light(const View& view, double luminance, double sp_ratio = 2.3) {
  PictureLight light{view, {}, {}};
  const auto y = static_cast<float>(luminance);
  const auto s = static_cast<float>(sp_ratio * luminance);
  for (int i = 0; i < view.width * view.height; ++i) {
    light.frame.insert(light.frame.end(), {0.95047F * y, y, 1.08883F * y, s});
  }
  return light;
}

inline gpu::Texture texture_of(const View& view, const std::vector<float>& rgba) {
  gpu::Texture texture = gpu::make_texture(view.width, view.height, gpu::PixelFormat::rgba32f);
  if (rgba.empty()) {
    glClearTexImage(texture.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
  } else {
    glTextureSubImage2D(texture.name(), 0, 0, 0, view.width, view.height, GL_RGBA, GL_FLOAT, rgba.data());
  }
  return texture;
}

/// The pixels that have light of points.
inline std::vector<gpu::PointTiles::Box> boxes_of_points(const PictureLight& light) {
  std::vector<gpu::PointTiles::Box> boxes;
  const auto width = static_cast<std::size_t>(light.view.width);
  for (std::size_t i = 0; i < light.points.size() / 4; ++i) {
    if (light.points[4 * i + 1] != 0.0F) {
      const std::size_t row = i / width;
      const auto low = std::array{static_cast<float>(i % width), static_cast<float>(row)};
      boxes.push_back({low[0], low[1], low[0] + 1.0F, low[1] + 1.0F});
    }
  }
  return boxes;
}

/// Code values of 16 bits that a chain (of rgba16) makes of a picture in one piece.
inline std::vector<std::uint16_t> codes_of(gpu::DisplayChain& chain, const PictureLight& light) {
  const View& view = light.view;
  const gpu::Texture frame = texture_of(view, light.frame);
  const gpu::Texture points = texture_of(view, light.points);
  const gpu::Texture pixels = gpu::make_texture(view.width, view.height, gpu::PixelFormat::rgba16);
  const gpu::ShaderLibrary library;
  gpu::PointTiles tiles(library);
  tiles.start(view.width, view.height);
  tiles.mark(boxes_of_points(light));
  tiles.list({0, view.height});
  const gpu::StripLight strip{frame, points, tiles, {0, view.height}};
  chain.start(view);
  chain.look(strip);
  chain.map(strip, pixels);
  std::vector<std::uint16_t> codes(light.frame.size());
  glGetTextureImage(pixels.name(), 0, GL_RGBA, GL_UNSIGNED_SHORT,
                    static_cast<GLsizei>(codes.size() * sizeof(std::uint16_t)), codes.data());
  return codes;
}

/// X, Y, Z in cd/m2 that leave the display at a pixel.
inline f64::vec3 light_at(const std::vector<std::uint16_t>& codes, int width, int column, int row,
                          const f64::DisplayModel& display, double mean_cd_m2) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
  return f64::display_light(f64::vec3(codes[at], codes[at + 1], codes[at + 2]) / 65535.0, display, mean_cd_m2);
}

/// What a star adds to the light that the display sends to its viewer's eye, lux: the sum over a window of what exceeds
/// its rim.
struct SeenExcess {
  double lux = 0.0;
  double background_cd_m2 = 0.0;
};
inline SeenExcess excess_at(const std::vector<std::uint16_t>& codes, const View& view, int column, int row, int reach,
                            const f64::DisplayModel& display, double mean_cd_m2) {
  double rim = 0.0;
  int rim_pixels = 0;
  double inside = 0.0;
  int inside_pixels = 0;
  for (int y = row - reach - 2; y <= row + reach + 2; ++y) {
    for (int x = column - reach - 2; x <= column + reach + 2; ++x) {
      const double luminance = light_at(codes, view.width, x, y, display, mean_cd_m2).y;
      if (std::abs(x - column) > reach || std::abs(y - row) > reach) {
        rim += luminance;
        ++rim_pixels;
      } else {
        inside += luminance;
        ++inside_pixels;
      }
    }
  }
  SeenExcess excess;
  excess.background_cd_m2 = rim / rim_pixels;
  excess.lux = (inside - inside_pixels * excess.background_cd_m2) * display.pixel_sr;
  return excess;
}

} // namespace vesper::test
