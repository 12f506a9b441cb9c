// The medium's densities on a fine grid of heights, and straight rays through it in cells short enough for quadrature.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/ray_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vesper {

/// A straight ray's part inside the air. Places on it are distances in km from its perigee, the point nearest to the
/// planet's centre, positive behind it.
struct AirRay {
  double perigee_km = 0.0; ///< its distance from the centre
  double origin_km = 0.0;  ///< where the ray starts, which may lie outside the air
  double begin_km = 0.0;   ///< of the part inside
  double end_km = 0.0;     ///< equal to begin_km where the ray meets no air
  bool meets_ground = false;

  [[nodiscard]] double radius_km(double place_km) const {
    return std::sqrt(perigee_km * perigee_km + place_km * place_km);
  }
};

/// Densities of all components, linear between heights of 10 m. For profiles that are smooth over 100 m, optical depths
/// by their columns hold within 1e-5 of themselves, or 5e-7 where the air is thin.
class SampledAir {
public:
  static constexpr std::size_t most_components = 8;
  /// A number a component: densities, or columns in km.
  using PerComponent = std::array<double, most_components>;

  /// Throws Error(argument) for impossible radii and for more components than `most_components`.
  explicit SampledAir(const Medium& medium);

  [[nodiscard]] double ground_km() const { return ground_km_; }
  [[nodiscard]] double top_km() const { return top_km_; }
  [[nodiscard]] std::size_t component_count() const { return components_; }

  /// \param radius_km from the planet's centre; below the ground and above the top as at them
  [[nodiscard]] PerComponent density(double radius_km) const {
    const double place = std::clamp((radius_km - ground_km_) / step_km, 0.0, last_place_);
    const auto cell = std::min(static_cast<std::size_t>(place), intervals_ - 1);
    const double t = place - static_cast<double>(cell);
    const double* low = &densities_[cell * components_];
    const double* high = low + components_;
    PerComponent result{};
    for (std::size_t c = 0; c < components_; ++c) {
      result[c] = low[c] + t * (high[c] - low[c]);
    }
    return result;
  }

  /// The ray from a point at that distance from the centre (not below the ground but by rounding) under that cosine of
  /// the zenith angle.
  [[nodiscard]] AirRay ray(double radius_km, double cos_zenith) const;

  /// Columns between two places of a ray that belong to one cell: Gauss's rule with two nodes.
  void add_columns(const AirRay& ray, double from_km, double to_km, PerComponent& columns_km) const {
    constexpr double node = 0.57735026918962576; // 1 / sqrt(3)
    const double middle = 0.5 * (from_km + to_km);
    const double half = 0.5 * (to_km - from_km);
    const PerComponent a = density(ray.radius_km(middle - node * half));
    const PerComponent b = density(ray.radius_km(middle + node * half));
    for (std::size_t c = 0; c < components_; ++c) {
      columns_km[c] += half * (a[c] + b[c]);
    }
  }

  /// Calls `visit(from_km, to_km)` for consecutive cells that make up the part inside the air, until it returns false.
  /// Within a cell the densities are smooth enough for `add_columns`.
  /// \param longest_km of a cell
  template <class Visit> void for_each_cell(const AirRay& ray, double longest_km, Visit&& visit) const;

  /// Columns from the ray's origin to where it leaves the air, for a ray that meets no ground.
  /// \param stop tells from the columns so far that no light is left
  template <class Stop> [[nodiscard]] PerComponent columns_to_space(const AirRay& ray, Stop&& stop) const {
    PerComponent columns{};
    for_each_cell(ray, longest_cell_km, [&](double from, double to) {
      add_columns(ray, from, to, columns);
      return !stop(columns);
    });
    return columns;
  }

  /// Densities along a level ray change over the square root of radius times scale height, 90 km and more.
  static constexpr double longest_cell_km = 25.0;
  /// Between the heights of the grid.
  static constexpr double step_km = 0.01;

private:
  void split(std::size_t first, std::size_t last, const std::vector<std::size_t>& breaks,
             const PerComponent& tolerance_km);

  double ground_km_ = 0.0;
  double top_km_ = 0.0;
  std::size_t components_ = 0;
  std::size_t intervals_ = 0;
  double last_place_ = 0.0;
  std::vector<double> densities_; ///< by height, then component
  std::vector<double> levels_km_; ///< radii of the shells, from the ground to the top
};

template <class Visit> void SampledAir::for_each_cell(const AirRay& ray, double longest_km, Visit&& visit) const {
  if (!(ray.end_km > ray.begin_km)) {
    return;
  }
  const double radius = ray.radius_km(ray.begin_km);
  auto above =
      static_cast<std::size_t>(std::upper_bound(levels_km_.begin(), levels_km_.end(), radius) - levels_km_.begin());
  above = std::clamp<std::size_t>(above, 1, levels_km_.size() - 1);
  std::size_t below = above - 1;
  double from = ray.begin_km;
  while (from < ray.end_km) {
    double to = ray.end_km;
    if (from < 0.0) {
      const double crossing = -crossing_km(ray.perigee_km, levels_km_[below]);
      if (crossing < 0.0 && below > 0) {
        to = crossing;
        --below;
      } else {
        to = std::min(0.0, ray.end_km);
        above = below + 1;
      }
      to = std::min(to, ray.end_km);
    } else {
      to = above + 1 < levels_km_.size() ? std::min(crossing_km(ray.perigee_km, levels_km_[above]), ray.end_km)
                                         : ray.end_km;
      ++above;
    }
    if (to <= from) {
      continue;
    }
    const double length = to - from;
    const auto pieces = static_cast<int>(std::ceil(length / longest_km));
    for (int i = 0; i < pieces; ++i) {
      const double a = from + length * (static_cast<double>(i) / pieces);
      const double b = i + 1 < pieces ? from + length * (static_cast<double>(i + 1) / pieces) : to;
      if (!visit(a, b)) {
        return;
      }
    }
    from = to;
  }
}

} // namespace vesper
