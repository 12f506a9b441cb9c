// Light gathered on the six faces of a cube map, piece by piece.
#pragma once

#include "vesper/base/vector.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace vesper {

/// Three channels of light and the solid angle that it came from. A texel's mean brightness is the one over the other.
struct LightSum {
  std::array<float, 3> light{}; ///< brightness times solid angle, in the picture's unit times sr
  float solid_angle_sr = 0;

  void add(const LightSum& other) {
    for (std::size_t i = 0; i < light.size(); ++i) {
      light[i] += other.light[i];
    }
    solid_angle_sr += other.solid_angle_sr;
  }
};
static_assert(sizeof(LightSum) == 16);

/// A rectangle of texels of one face with what fell into it.
struct LightPatch {
  int face = 0;
  int column = 0, row = 0, width = 0, height = 0; ///< row 0 is on top
  std::vector<LightSum> sums;

  [[nodiscard]] LightSum& at(int texel_column, int texel_row) {
    return sums[static_cast<std::size_t>(texel_row - row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(texel_column - column)];
  }
};

/// Spreads a pixel over the texels of the patch that it overlaps: each gets `brightness` times the solid angle of the
/// overlap. The pixel is the polygon of great circles through its corners; clipped in the plane of the face, where
/// great circles are straight, so that pixels which share an edge leave no gap and no overlap. The solid angle of a
/// piece is its area times the mean of the projection's density, to the second order in the piece's size.
///
/// \param corners in order around the pixel, in the axes of the face (picture right, up, outward), of any length; may
///                reach beyond the face
/// \return the solid angle that fell into the patch, sr
double spread_pixel(const std::array<Vec3, 4>& corners, const std::array<float, 3>& brightness, int face_size,
                    LightPatch& patch);

/// The same for corners that all lie well before the face, in texels (texel_place).
double spread_pixel(const std::array<Vec2, 4>& corners, const std::array<float, 3>& brightness, int face_size,
                    LightPatch& patch);

/// A direction in the axes of a face whose outward part is above this part of its length lies well before the face: its
/// place on the face's plane can be computed. 0.577 at the corners of a face.
inline constexpr double well_before_face = 0.25;
[[nodiscard]] inline bool lies_well_before_face(const Vec3& local) {
  return local.z > 0.0 && local.z * local.z > well_before_face * well_before_face * dot(local, local);
}

/// Where a direction in the axes of a face falls, in texels from its left upper corner.
[[nodiscard]] inline Vec2 texel_place(const Vec3& local, int face_size) {
  const double half = 0.5 * static_cast<double>(face_size);
  const double scale = half / local.z;
  return {half + scale * local.x, half - scale * local.y};
}

/// The solid angle of a texel, sr (exact).
[[nodiscard]] double texel_solid_angle_sr(int column, int row, int face_size);

/// All six faces.
struct CubeSum {
  explicit CubeSum(int size)
      : face_size(size), sums(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

  int face_size;
  std::vector<LightSum> sums; ///< face by face, row by row

  [[nodiscard]] LightSum* row(int face, int row_index) {
    return sums.data() + (static_cast<std::size_t>(face) * static_cast<std::size_t>(face_size) +
                          static_cast<std::size_t>(row_index)) *
                             static_cast<std::size_t>(face_size);
  }
  void add(const LightPatch& patch);
};

} // namespace vesper
