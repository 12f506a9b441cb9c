// The corners of a picture's pixels on the sky, most of them interpolated.
#pragma once

#include "vesper/base/vector.hpp"
#include "vesper/catalog_tools/picture_wcs.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace vesper {

/// A rectangle of pixels.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
};

/// The corners of all pixels of a box, as directions of any length.
///
/// The projection is computed at nodes and interpolated between them by a quadratic in x and y, in cells whose error,
/// computed where it is largest, keeps below `tolerance_px`; elsewhere corner by corner. Cells meet without a gap.
class PixelCorners {
public:
  /// Interpolation may move a corner by this part of a pixel.
  static constexpr double tolerance_px = 0.01;

  PixelCorners(PictureWcs& wcs, const PixelBox& box);

  /// The corners of a pixel of the box (x and y in the picture), in order around it. Where a corner is not on the sky
  /// but the pixel's centre is, the corner is drawn in to the border; none where the centre is not on the sky either.
  [[nodiscard]] std::optional<std::array<Vec3, 4>> of_pixel(int x, int y);

  /// All corners, row by row; zero vectors where not on the sky. (box.width + 1) x (box.height + 1).
  [[nodiscard]] const std::vector<Vec3>& all() const { return corners_; }

private:
  [[nodiscard]] bool interpolate(const PixelBox& cell);
  void compute(const PixelBox& cell);
  [[nodiscard]] Vec3& corner(int x, int y) {
    return corners_[static_cast<std::size_t>(y - box_.y) * static_cast<std::size_t>(box_.width + 1) +
                    static_cast<std::size_t>(x - box_.x)];
  }

  PictureWcs& wcs_;
  PixelBox box_;
  std::vector<Vec3> corners_;
  std::vector<Vec2> places_;
  std::vector<Vec3> directions_;
};

} // namespace vesper
