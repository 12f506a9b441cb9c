// A picture of the sky spread over the faces of a cube, strip by strip, without losing or inventing light.
#pragma once

#include "vesper/catalog_tools/cube_sum.hpp"
#include "vesper/catalog_tools/picture_wcs.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace vesper {

/// Some rows of a picture in memory, one or three channels.
struct PictureStrip {
  int first_row = 0, rows = 0, width = 0, channels = 0;
  std::vector<float> values; ///< channel by channel, row by row; NaN where missing

  [[nodiscard]] float* row(int channel, int y) {
    return values.data() + (static_cast<std::size_t>(channel) * static_cast<std::size_t>(rows) +
                            static_cast<std::size_t>(y - first_row)) *
                               static_cast<std::size_t>(width);
  }
  [[nodiscard]] const float* row(int channel, int y) const { return const_cast<PictureStrip*>(this)->row(channel, y); }
};

/// Light of the picture's channels times solid angle, in the picture's unit times sr.
struct LightTotal {
  std::array<double, 3> light{};
  double solid_angle_sr = 0.0;

  void add(const LightTotal& other) {
    for (std::size_t i = 0; i < light.size(); ++i) {
      light[i] += other.light[i];
    }
    solid_angle_sr += other.solid_angle_sr;
  }
};

/// Spreads rows of a picture over a cube: each pixel, the polygon of great circles through its corners, gives each
/// texel its brightness times the solid angle of their overlap, so that light is conserved by construction. A single
/// channel fills the first of three. Works on all cores; the result does not depend on their number.
class PanoramaResampler {
public:
  PanoramaResampler(PictureWcs wcs, int face_size) : wcs_(std::move(wcs)), cube_(face_size) {}

  /// Rows [first, last) of the strip. Each row of the picture once.
  void add(const PictureStrip& strip, int first, int last);

  [[nodiscard]] CubeSum& cube() { return cube_; }
  /// What was spread so far.
  [[nodiscard]] const LightTotal& total() const { return total_; }

private:
  PictureWcs wcs_;
  CubeSum cube_;
  LightTotal total_;
};

} // namespace vesper
