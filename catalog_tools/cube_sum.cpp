#include "vesper/catalog_tools/cube_sum.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

/// A polygon of few corners. Four cuts of a face's pyramid and two of a texel row add one corner each; the cuts of
/// columns take turns.
struct Polygon {
  static constexpr std::size_t most = 16;
  std::array<Vec2, most> corners;
  std::size_t size = 0;

  void push(const Vec2& corner) {
    if (size < most) {
      corners[size++] = corner;
    }
  }
};

/// Cuts along the line where coordinate `axis` is `at` (Sutherland and Hodgman 1974, both sides at once).
template <glm::length_t axis> void cut(const Polygon& polygon, double at, Polygon& below, Polygon& above) {
  below.size = above.size = 0;
  Vec2 a = polygon.corners[polygon.size - 1];
  double from = a[axis] - at;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec2 b = polygon.corners[i];
    const double to = b[axis] - at;
    if ((from < 0.0) != (to < 0.0)) {
      Vec2 crossing = a + (from / (from - to)) * (b - a);
      crossing[axis] = at;
      below.push(crossing);
      above.push(crossing);
    }
    (to < 0.0 ? below : above).push(b);
    a = b;
    from = to;
  }
}

/// Twice the signed area and the centroid.
struct Moments {
  double twice_area = 0.0;
  Vec2 centroid{0.0};
};
Moments moments(const Polygon& polygon) {
  Moments result;
  const Vec2 origin = polygon.corners[0];
  Vec2 sum(0.0);
  Vec2 a = polygon.corners[1] - origin;
  for (std::size_t i = 2; i < polygon.size; ++i) {
    const Vec2 b = polygon.corners[i] - origin;
    const double twice = a.x * b.y - a.y * b.x;
    result.twice_area += twice;
    sum += twice * (a + b);
    a = b;
  }
  result.centroid = origin;
  if (result.twice_area != 0.0) {
    result.centroid += sum / (3.0 * result.twice_area);
  }
  return result;
}

class Spreader {
public:
  Spreader(const std::array<float, 3>& brightness, int face_size, LightPatch& patch)
      : brightness_(brightness), half_texel_(1.0 / static_cast<double>(face_size)), patch_(patch) {}

  /// Gives the whole polygon, which lies within one texel, to that.
  void give(const Polygon& polygon, int column, int row) {
    if (polygon.size < 3) {
      return;
    }
    const Moments piece = moments(polygon);
    const double x = 2.0 * half_texel_ * piece.centroid.x - 1.0;
    const double y = 2.0 * half_texel_ * piece.centroid.y - 1.0;
    const double r2 = 1.0 + x * x + y * y;
    // The mean over the piece of the density r2^(-3/2), whose Laplacian over itself is (9 - 15 / r2) / r2, for a piece
    // as round as a square.
    const double area = 2.0 * half_texel_ * half_texel_ * piece.twice_area * sign_;
    const double density = (1.0 + area * (9.0 - 15.0 / r2) / (24.0 * r2)) / (r2 * std::sqrt(r2));
    const double solid_angle = area * density;
    total_ += solid_angle;
    const auto weight = static_cast<float>(solid_angle);
    LightSum& sum = patch_.at(column, row);
    for (std::size_t i = 0; i < brightness_.size(); ++i) {
      sum.light[i] += weight * brightness_[i];
    }
    sum.solid_angle_sr += weight;
  }

  /// The texels of one row.
  void give_row(Polygon polygon, int first, int last, int row) {
    Polygon left;
    Polygon rest;
    for (int column = first; column < last; ++column) {
      cut<0>(polygon, column + 1.0, left, rest);
      give(left, column, row);
      std::swap(polygon, rest);
      if (polygon.size < 3) {
        return;
      }
    }
    give(polygon, last, row);
  }

  double spread(Polygon polygon) {
    Vec2 low = polygon.corners[0];
    Vec2 high = low;
    for (std::size_t i = 1; i < polygon.size; ++i) {
      low = min(low, polygon.corners[i]);
      high = max(high, polygon.corners[i]);
    }
    const Vec2 patch_low(patch_.column, patch_.row);
    const Vec2 patch_high(patch_.column + patch_.width, patch_.row + patch_.height);
    if (!(high.x > patch_low.x && high.y > patch_low.y && low.x < patch_high.x && low.y < patch_high.y)) {
      return 0.0;
    }
    const double twice_area = moments(polygon).twice_area;
    sign_ = twice_area < 0.0 ? -1.0 : 1.0; // pictures of the sky may be mirrored
    Polygon side;
    Polygon rest;
    if (low.x < patch_low.x) {
      cut<0>(polygon, patch_low.x, side, rest);
      std::swap(polygon, rest);
    }
    if (high.x > patch_high.x) {
      cut<0>(polygon, patch_high.x, side, rest);
      std::swap(polygon, side);
    }
    if (low.y < patch_low.y) {
      cut<1>(polygon, patch_low.y, side, rest);
      std::swap(polygon, rest);
    }
    if (high.y > patch_high.y) {
      cut<1>(polygon, patch_high.y, side, rest);
      std::swap(polygon, side);
    }
    low = max(low, patch_low);
    high = min(high, patch_high);
    const int first_column = static_cast<int>(low.x);
    const int last_column = std::min(static_cast<int>(high.x), patch_.column + patch_.width - 1);
    const int first_row = static_cast<int>(low.y);
    const int last_row = std::min(static_cast<int>(high.y), patch_.row + patch_.height - 1);
    for (int row = first_row; row < last_row && polygon.size >= 3; ++row) {
      cut<1>(polygon, row + 1.0, side, rest);
      if (side.size >= 3) {
        give_row(side, first_column, last_column, row);
      }
      std::swap(polygon, rest);
    }
    if (polygon.size >= 3) {
      give_row(polygon, first_column, last_column, last_row);
    }
    return total_;
  }

private:
  const std::array<float, 3>& brightness_;
  double half_texel_;
  LightPatch& patch_;
  double sign_ = 1.0;
  double total_ = 0.0;
};

/// The part of the polygon before the face where any corner comes near its horizon or lies behind it.
Polygon before_the_face(const std::array<Vec3, 4>& corners, int face_size) {
  // A wider pyramid than the face's, so that what is cut here is cut nowhere else.
  constexpr double slope = 1.25;
  const std::array<Vec3, 4> planes{Vec3(1, 0, slope), Vec3(-1, 0, slope), Vec3(0, 1, slope), Vec3(0, -1, slope)};
  std::array<Vec3, Polygon::most> now{corners[0], corners[1], corners[2], corners[3]};
  std::size_t size = 4;
  for (const Vec3& plane : planes) {
    std::array<Vec3, Polygon::most> next;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Vec3& a = now[(i + size - 1) % size];
      const Vec3& b = now[i];
      const double from = dot(plane, a);
      const double to = dot(plane, b);
      if ((from < 0.0) != (to < 0.0)) {
        next[kept++] = a + (from / (from - to)) * (b - a);
      }
      if (to >= 0.0) {
        next[kept++] = b;
      }
    }
    now = next;
    size = kept;
  }
  Polygon polygon;
  for (std::size_t i = 0; i < size; ++i) {
    if (now[i].z > 0.0) {
      polygon.push(texel_place(now[i], face_size));
    }
  }
  return polygon;
}

} // namespace

double spread_pixel(const std::array<Vec2, 4>& corners, const std::array<float, 3>& brightness, int face_size,
                    LightPatch& patch) {
  Polygon polygon;
  std::copy(corners.begin(), corners.end(), polygon.corners.begin());
  polygon.size = corners.size();
  return Spreader(brightness, face_size, patch).spread(polygon);
}

double spread_pixel(const std::array<Vec3, 4>& corners, const std::array<float, 3>& brightness, int face_size,
                    LightPatch& patch) {
  Polygon polygon;
  for (const Vec3& corner : corners) {
    if (!lies_well_before_face(corner)) {
      polygon = before_the_face(corners, face_size);
      break;
    }
    polygon.push(texel_place(corner, face_size));
  }
  return polygon.size < 3 ? 0.0 : Spreader(brightness, face_size, patch).spread(polygon);
}

double texel_solid_angle_sr(int column, int row, int face_size) {
  // The solid angle of the rectangle from the face's centre to (x, y) is atan(x y / sqrt(1 + x^2 + y^2)).
  const auto from_centre = [](double x, double y) { return std::atan2(x * y, std::sqrt(1.0 + x * x + y * y)); };
  const auto place = [&](int index) { return 2.0 * index / static_cast<double>(face_size) - 1.0; };
  const double left = place(column);
  const double right = place(column + 1);
  const double top = place(row);
  const double bottom = place(row + 1);
  return from_centre(right, bottom) - from_centre(left, bottom) - from_centre(right, top) + from_centre(left, top);
}

void CubeSum::add(const LightPatch& patch) {
  for (int y = 0; y < patch.height; ++y) {
    LightSum* to = row(patch.face, patch.row + y) + patch.column;
    const LightSum* from = patch.sums.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(patch.width);
    for (int x = 0; x < patch.width; ++x) {
      to[x].add(from[x]);
    }
  }
}

} // namespace vesper
