#include "vesper/catalog_tools/pixel_corners.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

constexpr int cell_size = 32;           // pixels
constexpr std::size_t nodes_a_side = 3; // of a quadratic

/// The weights of the values at 0, 1/2 and 1 in the quadratic through them.
std::array<double, nodes_a_side> quadratic_weights(double t) {
  return {(2.0 * t - 1.0) * (t - 1.0), 4.0 * t * (1.0 - t), t * (2.0 * t - 1.0)};
}

bool on_sky(const Vec3& direction) { return direction.x != 0.0 || direction.y != 0.0 || direction.z != 0.0; }

} // namespace

PixelCorners::PixelCorners(PictureWcs& wcs, const PixelBox& box)
    : wcs_(wcs), box_(box),
      corners_(static_cast<std::size_t>(box.width + 1) * static_cast<std::size_t>(box.height + 1)) {
  for (int y = 0; y < box.height; y += cell_size) {
    for (int x = 0; x < box.width; x += cell_size) {
      const PixelBox cell{box.x + x, box.y + y, std::min(cell_size, box.width - x),
                          std::min(cell_size, box.height - y)};
      if (!interpolate(cell)) {
        compute(cell);
      }
    }
  }
}

bool PixelCorners::interpolate(const PixelBox& cell) {
  // Where the error of a quadratic through three points is largest.
  constexpr std::array<double, 2> worst{0.2113248654, 0.7886751346};
  constexpr std::size_t nodes = nodes_a_side * nodes_a_side;
  const auto place = [&](double s, double t) { return Vec2(cell.x + s * cell.width, cell.y + t * cell.height); };
  places_.clear();
  for (const double t : {0.0, 0.5, 1.0}) {
    for (const double u : {0.0, 0.5, 1.0}) {
      places_.push_back(place(u, t));
    }
  }
  for (const double t : worst) {
    for (const double s : worst) {
      places_.push_back(place(s, t));
    }
  }
  directions_.resize(places_.size());
  wcs_.directions(places_, directions_);
  if (!std::all_of(directions_.begin(), directions_.end(), on_sky)) {
    return false;
  }
  const std::vector<Vec3>& node = directions_;
  const auto at = [&](const std::array<double, nodes_a_side>& across, const std::array<double, nodes_a_side>& up) {
    Vec3 sum(0.0);
    for (std::size_t i = 0; i < nodes; ++i) {
      sum += across[i % nodes_a_side] * up[i / nodes_a_side] * node[i];
    }
    return sum;
  };
  const double step = std::max(distance(node[0], node[2]) / cell.width, distance(node[0], node[6]) / cell.height);
  for (std::size_t i = 0; i < worst.size() * worst.size(); ++i) {
    const Vec3 found = at(quadratic_weights(worst[i % worst.size()]), quadratic_weights(worst[i / worst.size()]));
    if (distance(found, node[nodes + i]) > tolerance_px * step) {
      return false;
    }
  }
  std::array<std::array<double, nodes_a_side>, cell_size + 1> across;
  for (int x = 0; x <= cell.width; ++x) {
    across[static_cast<std::size_t>(x)] = quadratic_weights(static_cast<double>(x) / cell.width);
  }
  for (int y = 0; y <= cell.height; ++y) {
    const auto up = quadratic_weights(static_cast<double>(y) / cell.height);
    std::array<Vec3, nodes_a_side> row;
    for (std::size_t i = 0; i < nodes_a_side; ++i) {
      row[i] = up[0] * node[i] + up[1] * node[nodes_a_side + i] + up[2] * node[2 * nodes_a_side + i];
    }
    for (int x = 0; x <= cell.width; ++x) {
      const auto& weights = across[static_cast<std::size_t>(x)];
      corner(cell.x + x, cell.y + y) = weights[0] * row[0] + weights[1] * row[1] + weights[2] * row[2];
    }
  }
  return true;
}

void PixelCorners::compute(const PixelBox& cell) {
  places_.clear();
  for (int y = 0; y <= cell.height; ++y) {
    for (int x = 0; x <= cell.width; ++x) {
      places_.emplace_back(cell.x + x, cell.y + y);
    }
  }
  directions_.resize(places_.size());
  wcs_.directions(places_, directions_);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    corner(static_cast<int>(places_[i].x), static_cast<int>(places_[i].y)) = directions_[i];
  }
}

std::optional<std::array<Vec3, 4>> PixelCorners::of_pixel(int x, int y) {
  std::array<Vec3, 4> result{corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)};
  if (std::all_of(result.begin(), result.end(), on_sky)) {
    return result;
  }
  const Vec2 centre(x + 0.5, y + 0.5);
  const Vec3 middle = wcs_.direction(centre);
  if (!on_sky(middle)) {
    return std::nullopt;
  }
  const std::array<Vec2, 4> offsets{Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)};
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (on_sky(result[i])) {
      continue;
    }
    constexpr int halvings = 12;
    double inside = 0.0;
    double outside = 1.0;
    result[i] = middle;
    for (int step = 0; step < halvings; ++step) {
      const double between = 0.5 * (inside + outside);
      const Vec3 tried = wcs_.direction(centre + between * offsets[i]);
      if (on_sky(tried)) {
        inside = between;
        result[i] = tried;
      } else {
        outside = between;
      }
    }
  }
  return result;
}

} // namespace vesper
