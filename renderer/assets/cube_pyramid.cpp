#include "vesper/assets/cube_pyramid.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace vesper {
namespace {

using Level = CubePyramid::Level;

/// From the middle of a face to a place on it.
double solid_angle_to(double right, double up) {
  return std::atan2(right * up, std::sqrt(1.0 + right * right + up * up));
}

/// Of the texels of one face, row by row; all faces are alike.
std::vector<double> solid_angles(int face_size) {
  const auto place = [&](int i) { return 2.0 * i / face_size - 1.0; };
  std::vector<double> result;
  for (int row = 0; row < face_size; ++row) {
    for (int column = 0; column < face_size; ++column) {
      result.push_back(cube_solid_angle_sr({place(column), place(row)}, {place(column + 1), place(row + 1)}));
    }
  }
  return result;
}

/// A texel that one of the next size covers, and how much of its side.
struct Covered {
  int index = 0;
  double share = 0.0;
};

/// By texel of the smaller size: along one side, since what they cover is rectangles.
std::vector<std::vector<Covered>> covered_along(int large, int small) {
  std::vector<std::vector<Covered>> all;
  for (int i = 0; i < small; ++i) {
    const double from = static_cast<double>(i) * large / small;
    const double to = static_cast<double>(i + 1) * large / small;
    auto& covered = all.emplace_back();
    for (int k = static_cast<int>(from); k < large && k < to; ++k) {
      covered.push_back({k, std::min(to, k + 1.0) - std::max(from, static_cast<double>(k))});
    }
  }
  return all;
}

Level half(const Level& from) {
  const int large = from.face_size;
  const int small = std::max(large / 2, 1);
  const std::vector<double> weights = solid_angles(large);
  const auto covered = covered_along(large, small);
  Level to{small, {}};
  to.texels.reserve(4 * cube_texel_count(small));
  for (int face = 0; face < 6; ++face) {
    for (const auto& rows : covered) {
      for (const auto& columns : covered) {
        Vec4 light(0.0);
        double solid_angle = 0.0;
        for (const Covered& row : rows) {
          for (const Covered& column : columns) {
            const auto on_face = static_cast<std::size_t>(row.index) * static_cast<std::size_t>(large) +
                                 static_cast<std::size_t>(column.index);
            const float* texel =
                &from.texels[4 * (static_cast<std::size_t>(face) * weights.size() + on_face)];
            const double weight = row.share * column.share * weights[on_face];
            light += weight * Vec4(texel[0], texel[1], texel[2], texel[3]);
            solid_angle += weight;
          }
        }
        light /= solid_angle;
        for (int channel = 0; channel < 4; ++channel) {
          to.texels.push_back(static_cast<float>(light[channel]));
        }
      }
    }
  }
  return to;
}

Vec4 texel_of(const Level& level, int face, int column, int row) {
  const int n = level.face_size;
  const auto index = static_cast<std::size_t>((face * n + row) * static_cast<std::ptrdiff_t>(n) + column);
  const float* texel = &level.texels[4 * index];
  return {texel[0], texel[1], texel[2], texel[3]};
}

/// Of a column and a row of which one may be -1 or the number of texels a side: those of the face beyond that edge.
Vec4 texel_across(const Level& level, int face, int column, int row) {
  const int n = level.face_size;
  if (column >= 0 && column < n && row >= 0 && row < n) {
    return texel_of(level, face, column, row);
  }
  constexpr double beyond = 1.0 + 1.0e-6; // of the edge, by less than any texel's width
  const auto place = [&](int i) { return i < 0 ? -beyond : i >= n ? beyond : (2.0 * i + 1.0) / n - 1.0; };
  const Vec3 direction = f64::cube_direction(face, {place(column), -place(row)});
  const int other = f64::cube_face(direction, 0);
  const Vec3 local = glm::transpose(f64::cube_face_axes(other)) * direction;
  const auto index = [&](double at) { return std::clamp(static_cast<int>(0.5 * (at + 1.0) * n), 0, n - 1); };
  return texel_of(level, other, index(local.x / local.z), index(-local.y / local.z));
}

/// Beyond a corner there is no texel: the mean of the three that meet at it, as OpenGL 4.5 has it (section 8.14.1).
Vec4 texel_around(const Level& level, int face, int column, int row) {
  const int inner_column = std::clamp(column, 0, level.face_size - 1);
  const int inner_row = std::clamp(row, 0, level.face_size - 1);
  if (inner_column == column || inner_row == row) {
    return texel_across(level, face, column, row);
  }
  return (texel_of(level, face, inner_column, inner_row) + texel_across(level, face, column, inner_row) +
          texel_across(level, face, inner_column, row)) /
         3.0;
}

Vec4 between_texels(const Level& level, const Vec3& direction) {
  const int face = f64::cube_face(direction, 0);
  const Vec3 local = glm::transpose(f64::cube_face_axes(face)) * direction;
  const double x = 0.5 * (local.x / local.z + 1.0) * level.face_size - 0.5;
  const double y = 0.5 * (1.0 - local.y / local.z) * level.face_size - 0.5;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const auto along = [&](int in_row) {
    return glm::mix(texel_around(level, face, column, in_row), texel_around(level, face, column + 1, in_row),
                    x - column);
  };
  return glm::mix(along(row), along(row + 1), y - row);
}

} // namespace

double cube_solid_angle_sr(const Vec2& low, const Vec2& high) {
  return solid_angle_to(high.x, high.y) - solid_angle_to(low.x, high.y) - solid_angle_to(high.x, low.y) +
         solid_angle_to(low.x, low.y);
}

CubePyramid::CubePyramid(int face_size, std::vector<float> texels) {
  if (face_size < 1 || texels.size() != 4 * cube_texel_count(face_size)) {
    throw Error(ErrorKind::argument,
                std::to_string(texels.size()) + " numbers are no six faces of " + std::to_string(face_size) +
                    " texels a side with four each",
                {});
  }
  levels_.push_back({face_size, std::move(texels)});
  while (levels_.back().face_size > 1) {
    levels_.push_back(half(levels_.back()));
  }
}

Vec4 CubePyramid::at(const Vec3& direction, double level) const {
  const double clamped = std::clamp(level, 0.0, static_cast<double>(levels_.size() - 1));
  const auto low = static_cast<std::size_t>(clamped);
  const double share = clamped - static_cast<double>(low);
  const Vec4 light = between_texels(levels_[low], direction);
  return share > 0.0 ? glm::mix(light, between_texels(levels_[low + 1], direction), share) : light;
}

} // namespace vesper
