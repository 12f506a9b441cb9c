#include "vesper/atmosphere/refracted_columns.hpp"

#include "vesper/astro/refraction_trace.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesper {
namespace {

/// n r and n + r dn/dr.
struct Optics {
  double n_r;
  double slope;
};

/// Heights of the shells' boundaries: those between which profiles are smooth, and others so near to each other that
/// they are straight. 0.01 km at the ground, 4 % of the height, 1 km at most.
std::vector<double> boundaries_km(const Medium& medium, double lowest_km, double observer_km, double top_km) {
  std::vector<double> heights{observer_km};
  for (const MediumComponent& component : medium.components) {
    const std::vector<double>& breaks = component.profile.breaks_km();
    heights.insert(heights.end(), breaks.begin(), breaks.end());
  }
  double height = lowest_km;
  while (height < top_km) {
    heights.push_back(height);
    height += std::min(0.01 + 0.04 * std::abs(height), 1.0);
  }
  heights.push_back(0.0);
  heights.push_back(top_km);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::upper_bound(heights.begin(), heights.end(), top_km), heights.end());
  heights.erase(heights.begin(), std::lower_bound(heights.begin(), heights.end(), lowest_km));
  // Shells thinner than a micrometre would be rounding.
  const auto one = [](double low, double high) { return high - low < 1.0e-9; };
  heights.erase(std::unique(heights.begin(), heights.end(), one), heights.end());
  return heights;
}

} // namespace

RefractedColumns::RefractedColumns(const Medium& medium, Length height,
                                   const std::optional<RefractionConditions>& bending)
    : components_(medium.components.size()) {
  validate_radii(medium);
  const double observer_km = height.to(kilometre);
  const double ground_km = medium.ground_radius.to(kilometre);
  const double top_km = medium.top_radius.to(kilometre) - ground_km;
  radius_km_ = ground_km + observer_km;
  if (!std::isfinite(observer_km) || !(radius_km_ > 0.0)) {
    throw Error(ErrorKind::argument, "an observer at a height that is none", {"", "", "Give a finite height"});
  }
  std::optional<AirProfile> air;
  double lowest_km = std::min(0.0, observer_km);
  if (bending) {
    air.emplace(*bending);
    const RefractionTracer tracer(*bending, fast_trace);
    lowest_km = std::max(lowest_km, tracer.trace(tracer.horizon()).lowest.to(kilometre));
  }
  const auto optics = [&](double height_km) {
    const AirProfile::Air at = air ? air->at(height_km) : AirProfile::Air{0.0, 0.0};
    const double radius = ground_km + height_km;
    return Optics{(1.0 + at.refractivity) * radius, 1.0 + at.refractivity + radius * at.gradient_per_km};
  };
  observer_n_r_ = optics(observer_km).n_r;
  lowest_radius_km_ = ground_km + lowest_km;
  const double lowest_n_r = optics(lowest_km).n_r;
  sin_horizon_ = -std::sqrt(std::max((observer_n_r_ - lowest_n_r) * (observer_n_r_ + lowest_n_r), 0.0)) / observer_n_r_;

  const std::vector<double> heights = boundaries_km(medium, lowest_km, std::min(observer_km, top_km), top_km);
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double middle = 0.5 * (heights[i] + heights[i + 1]);
    if (middle < observer_km) {
      first_above_ = i + 1;
    }
    // Gauss's two points: never on a boundary, where densities may jump.
    const double offset = 0.5 * (heights[i + 1] - heights[i]) / std::numbers::sqrt3;
    const Optics low = optics(middle - offset);
    const Optics high = optics(middle + offset);
    const double low_square = low.n_r * low.n_r;
    const double high_square = high.n_r * high.n_r;
    shells_.push_back({std::pow(optics(heights[i]).n_r, 2), std::pow(optics(heights[i + 1]).n_r, 2),
                       0.5 * (low_square + high_square)});
    for (const MediumComponent& component : medium.components) {
      const double at_low = component.profile.at(std::max(middle - offset, 0.0)) / low.slope;
      const double at_high = component.profile.at(std::max(middle + offset, 0.0)) / high.slope;
      densities_.push_back({0.5 * (at_low + at_high), (at_high - at_low) / (high_square - low_square)});
    }
  }
}

void RefractedColumns::add_shells(std::size_t from, std::size_t to, double invariant, double factor,
                                  std::vector<double>& km) const {
  const double square = invariant * invariant;
  double low = -1.0;
  for (std::size_t i = from; i < to; ++i) {
    const Shell& shell = shells_[i];
    if (shell.high_square <= square) {
      continue;
    }
    if (low < 0.0) {
      low = std::sqrt(std::max(shell.low_square - square, 0.0));
    }
    const double high = std::sqrt(shell.high_square - square);
    // Without the difference of two long distances.
    const double path = factor * (shell.high_square - std::max(shell.low_square, square)) / (high + low);
    // The mean of q^2 along it, from the middle's.
    const double off = (high * high + high * low + low * low) / 3.0 - (shell.middle_square - square);
    for (std::size_t k = 0; k < components_; ++k) {
      const Density& density = densities_[i * components_ + k];
      km[k] += path * (density.value + density.slope * off);
    }
    low = high;
  }
}

std::vector<double> RefractedColumns::columns_km(double sin_altitude) const {
  std::vector<double> km(components_, 0.0);
  const double sine = std::clamp(sin_altitude, sin_horizon_, 1.0);
  const double invariant = observer_n_r_ * std::sqrt((1.0 - sine) * (1.0 + sine));
  if (sine < 0.0) {
    add_shells(0, first_above_, invariant, 2.0, km);
  }
  add_shells(first_above_, shells_.size(), invariant, 1.0, km);
  // A straight line through a shell that the ray but grazes may leave less than nothing.
  for (double& column : km) {
    column = std::max(column, 0.0);
  }
  return km;
}

} // namespace vesper
