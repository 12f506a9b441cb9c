#include "vesper/catalog_tools/globe_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

constexpr double pi = std::numbers::pi;

/// Area of one pixel of a row, by the width of its column in radians.
double row_area(int row, int height) {
  const auto edge = [&](int r) { return std::cos(pi * r / height); };
  return edge(row) - edge(row + 1);
}

/// The eight pixels around one, those beyond a pole on the other side of it.
std::array<std::size_t, 8> neighbours(const GlobeGrid& grid, std::size_t pixel) {
  const int column = static_cast<int>(pixel % static_cast<std::size_t>(grid.width));
  const int row = static_cast<int>(pixel / static_cast<std::size_t>(grid.width));
  std::array<std::size_t, 8> found{};
  std::size_t count = 0;
  for (int y = row - 1; y <= row + 1; ++y) {
    const bool beyond = y < 0 || y >= grid.height;
    const int r = std::clamp(y, 0, grid.height - 1);
    for (int x = column - 1; x <= column + 1; ++x) {
      if (x != column || y != row) {
        const int c = (x + grid.width + (beyond ? grid.width / 2 : 0)) % grid.width;
        found[count++] = static_cast<std::size_t>(r) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(c);
      }
    }
  }
  return found;
}

} // namespace

FillReport fill_missing(GlobeGrid& grid) {
  FillReport report;
  // The missing pixels that touch a known one; each round fills them from what was known before it.
  std::vector<std::size_t> border;
  double area = 0.0;
  const auto missing = [&](std::size_t i) { return std::isnan(grid.values[i]); };
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    if (missing(i)) {
      ++report.filled;
      area += row_area(static_cast<int>(i / static_cast<std::size_t>(grid.width)), grid.height);
      const auto around = neighbours(grid, i);
      if (!std::all_of(around.begin(), around.end(), missing)) {
        border.push_back(i);
      }
    }
  }
  report.area_share = area / (2.0 * grid.width);
  while (!border.empty()) {
    std::vector<std::pair<std::size_t, float>> round;
    for (const std::size_t i : border) {
      double sum = 0.0;
      int known = 0;
      for (const std::size_t neighbour : neighbours(grid, i)) {
        if (!missing(neighbour)) {
          sum += static_cast<double>(grid.values[neighbour]);
          ++known;
        }
      }
      round.emplace_back(i, static_cast<float>(sum / known));
    }
    for (const auto& [i, value] : round) {
      grid.values[i] = value;
    }
    border.clear();
    for (const auto& [i, value] : round) {
      const auto around = neighbours(grid, i);
      std::copy_if(around.begin(), around.end(), std::back_inserter(border), missing);
    }
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
  }
  return report;
}

GlobeMeans::GlobeMeans(const GlobeGrid& grid)
    : width_(grid.width), height_(grid.height), west_edge_rad_(grid.west_edge_deg * pi / 180.0) {
  const auto corners = static_cast<std::size_t>(width_) + 1;
  sums_.resize(corners * (static_cast<std::size_t>(height_) + 1));
  areas_.resize(static_cast<std::size_t>(height_) + 1);
  for (std::size_t row = 0; row < static_cast<std::size_t>(height_); ++row) {
    const double pixel_area = row_area(static_cast<int>(row), height_);
    const float* values = &grid.values[row * (corners - 1)];
    const double* above = &sums_[row * corners];
    double* below = &sums_[(row + 1) * corners];
    double in_row = 0.0;
    for (std::size_t column = 1; column < corners; ++column) {
      in_row += pixel_area * static_cast<double>(values[column - 1]);
      below[column] = above[column] + in_row;
    }
    areas_[row + 1] = areas_[row] + pixel_area;
  }
}

double GlobeMeans::mean(const Vec3& direction, double size_rad) const {
  const double across = std::hypot(direction.x, direction.y);
  const double pixels_per_rad = height_ / pi;
  const double row = std::atan2(across, direction.z) * pixels_per_rad;
  const double half_rows = 0.5 * std::max(size_rad * pixels_per_rad, 1.0);
  const double top = std::max(row - half_rows, 0.0);
  const double bottom = std::min(row + half_rows, static_cast<double>(height_));
  const double columns = std::clamp(size_rad * pixels_per_rad / std::max(across, 1.0e-12), 1.0, double(width_));
  double left = (std::atan2(direction.y, direction.x) - west_edge_rad_) * pixels_per_rad - 0.5 * columns;
  left -= std::floor(left / width_) * width_;
  const double right = left + columns;
  return (sum(right, bottom) - sum(left, bottom) - sum(right, top) + sum(left, top)) /
         ((area(bottom) - area(top)) * columns);
}

double GlobeMeans::sum(double column, double row) const {
  // The map repeats after its right edge.
  const bool again = column >= width_;
  const double c = again ? column - width_ : column;
  const int x = std::clamp(static_cast<int>(c), 0, width_ - 1);
  const int y = std::min(static_cast<int>(row), height_ - 1);
  const double u = c - x;
  const double v = row - y;
  const auto corners = static_cast<std::size_t>(width_) + 1;
  const double* above = &sums_[static_cast<std::size_t>(y) * corners];
  const double* below = above + corners;
  const double here = (1.0 - v) * ((1.0 - u) * above[x] + u * above[x + 1]) +
                      v * ((1.0 - u) * below[x] + u * below[x + 1]);
  return again ? here + (1.0 - v) * above[width_] + v * below[width_] : here;
}

double GlobeMeans::area(double row) const {
  const int y = std::min(static_cast<int>(row), height_ - 1);
  const auto i = static_cast<std::size_t>(y);
  return areas_[i] + (row - y) * (areas_[i + 1] - areas_[i]);
}

} // namespace vesper
