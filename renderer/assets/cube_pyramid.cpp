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

/// A texel and its share of what is seen at a place.
struct Share {
  std::size_t texel = 0;
  double share = 0.0;
};

/// The texels that a place is mixed from: four, of which one may stand for the two that meet it at a corner.
struct Shares {
  std::array<Share, 6> parts{};
  std::size_t count = 0;
  void add(std::size_t texel, double share) { parts.at(count++) = {texel, share}; }
};

std::size_t texel_index(int n, int face, int column, int row) {
  return static_cast<std::size_t>((face * n + row) * static_cast<std::ptrdiff_t>(n) + column);
}

/// Of a column and a row of which one may be -1 or n: that of the face beyond the edge.
std::size_t texel_across(int n, int face, int column, int row) {
  if (column >= 0 && column < n && row >= 0 && row < n) {
    return texel_index(n, face, column, row);
  }
  constexpr double beyond = 1.0 + 1.0e-6; // of the edge, by less than any texel's width
  const auto place = [&](int i) { return i < 0 ? -beyond : i >= n ? beyond : (2.0 * i + 1.0) / n - 1.0; };
  const Vec3 direction = f64::cube_direction(face, {place(column), -place(row)});
  const int other = f64::cube_face(direction, 0);
  const Vec3 local = glm::transpose(f64::cube_face_axes(other)) * direction;
  const auto index = [&](double at) { return std::clamp(static_cast<int>(0.5 * (at + 1.0) * n), 0, n - 1); };
  return texel_index(n, other, index(local.x / local.z), index(-local.y / local.z));
}

/// At a place of a face, in texels from the middle of its first one.
Shares shares_at(int n, int face, const Vec2& place) {
  const int first_column = static_cast<int>(std::floor(place.x));
  const int first_row = static_cast<int>(std::floor(place.y));
  const Vec2 second = place - Vec2(first_column, first_row);
  Shares shares;
  for (int k = 0; k < 4; ++k) {
    const int column = first_column + k % 2;
    const int row = first_row + k / 2;
    const double share = (k % 2 == 0 ? 1.0 - second.x : second.x) * (k / 2 == 0 ? 1.0 - second.y : second.y);
    const int inner_column = std::clamp(column, 0, n - 1);
    const int inner_row = std::clamp(row, 0, n - 1);
    if (inner_column == column || inner_row == row) {
      shares.add(texel_across(n, face, column, row), share);
      continue;
    }
    // Beyond a corner there is no texel: the mean of the three that meet at it, as OpenGL 4.5 has it (section 8.14.1).
    shares.add(texel_index(n, face, inner_column, inner_row), share / 3.0);
    shares.add(texel_across(n, face, column, inner_row), share / 3.0);
    shares.add(texel_across(n, face, inner_column, row), share / 3.0);
  }
  return shares;
}

Vec4 light_of(const Level& level, std::size_t texel) {
  const float* values = &level.texels[4 * texel];
  return {values[0], values[1], values[2], values[3]};
}

Vec4 between_texels(const Level& level, const Vec3& direction) {
  const int face = f64::cube_face(direction, 0);
  const Vec3 local = glm::transpose(f64::cube_face_axes(face)) * direction;
  const Vec2 place = 0.5 * level.face_size * (Vec2(1.0) + Vec2(local.x, -local.y) / local.z) - Vec2(0.5);
  const Shares shares = shares_at(level.face_size, face, place);
  Vec4 light(0.0);
  for (std::size_t i = 0; i < shares.count; ++i) {
    light += shares.parts.at(i).share * light_of(level, shares.parts.at(i).texel);
  }
  return light;
}

/// A level, and over what solid angle that which is seen of each of its texels adds up.
struct CountedLevel {
  Level level;
  std::vector<double> solid_angles_sr;
};

CountedLevel smaller(const CountedLevel& from, int small) {
  const int large = from.level.face_size;
  std::vector<Vec4> light(cube_texel_count(small), Vec4(0.0));
  std::vector<double> solid_angles(light.size(), 0.0);
  const auto place = [&](int i) { return (i + 0.5) * small / large - 0.5; };
  std::size_t texel = 0;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < large; ++row) {
      for (int column = 0; column < large; ++column, ++texel) {
        const Shares shares = shares_at(small, face, {place(column), place(row)});
        for (std::size_t i = 0; i < shares.count; ++i) {
          const double given = shares.parts.at(i).share * from.solid_angles_sr[texel];
          light[shares.parts.at(i).texel] += given * light_of(from.level, texel);
          solid_angles[shares.parts.at(i).texel] += given;
        }
      }
    }
  }
  Level to{small, {}};
  to.texels.reserve(4 * light.size());
  for (std::size_t i = 0; i < light.size(); ++i) {
    for (int channel = 0; channel < 4; ++channel) {
      to.texels.push_back(static_cast<float>(light[i][channel] / solid_angles[i]));
    }
  }
  return {std::move(to), std::move(solid_angles)};
}

/// From this size on down, texels are so large that one size made of the next would not be what is seen of it within
/// 0.1 %: these are all made of the last that is larger.
constexpr int coarse_face_size = 64;

} // namespace

CubePyramid::CubePyramid(int face_size, std::vector<float> texels) {
  if (face_size < 1 || texels.size() != 4 * cube_texel_count(face_size)) {
    throw Error(ErrorKind::argument,
                std::to_string(texels.size()) + " numbers are no six faces of " + std::to_string(face_size) +
                    " texels a side with four each",
                {});
  }
  CountedLevel from{{face_size, std::move(texels)}, {}};
  for (std::size_t i = 0; i < cube_texel_count(face_size); ++i) {
    from.solid_angles_sr.push_back(cube_texel(face_size, i).solid_angle_sr);
  }
  levels_.push_back(from.level);
  while (levels_.back().face_size > 1) {
    CountedLevel next = smaller(from, levels_.back().face_size / 2);
    levels_.push_back(next.level);
    if (next.level.face_size > coarse_face_size) {
      from = std::move(next);
    }
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
