#include "vesper/atmosphere/sampled_air.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/sine.hpp"

#include <algorithm>
#include <string>

namespace vesper {

SampledAir::SampledAir(const Medium& medium) : components_(medium.components.size()) {
  validate_radii(medium);
  if (components_ > most_components) {
    throw Error(ErrorKind::argument, "a medium of " + std::to_string(components_) + " components",
                {"", "", "Give at most " + std::to_string(most_components) + " and join those of one phase function"});
  }
  ground_km_ = medium.ground_radius.to(kilometre);
  top_km_ = medium.top_radius.to(kilometre);
  const double height_km = top_km_ - ground_km_;
  intervals_ = static_cast<std::size_t>(std::ceil(height_km / step_km));
  last_place_ = height_km / step_km;
  densities_.reserve((intervals_ + 1) * components_);
  PerComponent tolerance_km{};
  for (std::size_t i = 0; i <= intervals_; ++i) {
    for (std::size_t c = 0; c < components_; ++c) {
      densities_.push_back(medium.components[c].profile.at(static_cast<double>(i) * step_km));
      constexpr double relative = 1.0e-7;
      tolerance_km[c] += relative * step_km * densities_.back();
    }
  }
  std::vector<std::size_t> breaks;
  for (const MediumComponent& component : medium.components) {
    for (const double km : component.profile.breaks_km()) {
      breaks.push_back(static_cast<std::size_t>(std::lround(std::clamp(km, 0.0, height_km) / step_km)));
    }
  }
  std::sort(breaks.begin(), breaks.end());
  levels_km_.push_back(ground_km_);
  split(0, intervals_, breaks, tolerance_km);
}

/// Appends the upper borders of shells in which `add_columns` holds the columns of a vertical ray. Shells are divided
/// where profiles break, as long as one does inside: a kink within a shell would take many halvings to enclose.
void SampledAir::split(std::size_t first, std::size_t last, const std::vector<std::size_t>& breaks,
                       const PerComponent& tolerance_km) {
  const double low_km = static_cast<double>(first) * step_km;
  const double width_km = static_cast<double>(last - first) * step_km;
  constexpr std::size_t narrowest = 2;
  // What grows with height keeps the cells of slanted rays in proportion to the air that is left there.
  bool good = width_km <= 0.5 + 0.1 * low_km;
  if (good && last - first > narrowest) {
    PerComponent error_km{};
    AirRay vertical;
    add_columns(vertical, ground_km_ + low_km, ground_km_ + low_km + width_km, error_km);
    for (std::size_t c = 0; c < components_; ++c) {
      double sum = 0.5 * (densities_[last * components_ + c] - densities_[first * components_ + c]);
      for (std::size_t i = first; i < last; ++i) {
        sum += densities_[i * components_ + c];
      }
      good = good && std::abs(sum * step_km - error_km[c]) <= tolerance_km[c];
    }
  }
  if (good || last - first <= narrowest) {
    levels_km_.push_back(std::min(ground_km_ + low_km + width_km, top_km_));
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  const auto from_middle = [&](std::size_t place) { return place > middle ? place - middle : middle - place; };
  const auto inside = std::upper_bound(breaks.begin(), breaks.end(), first);
  const auto nearest =
      std::min_element(inside, std::max(inside, std::lower_bound(breaks.begin(), breaks.end(), last)),
                       [&](std::size_t one, std::size_t other) { return from_middle(one) < from_middle(other); });
  const std::size_t cut = nearest != breaks.end() && *nearest < last ? *nearest : middle;
  split(first, cut, breaks, tolerance_km);
  split(cut, last, breaks, tolerance_km);
}

AirRay SampledAir::ray(double radius_km, double cos_zenith) const {
  const double radius = std::max(radius_km, ground_km_);
  AirRay ray;
  ray.origin_km = radius * cos_zenith;
  ray.perigee_km = radius * sine_of(cos_zenith);
  const double reach = crossing_km(ray.perigee_km, top_km_);
  ray.begin_km = std::max(ray.origin_km, -reach);
  ray.meets_ground = cos_zenith < 0.0 && ray.perigee_km < ground_km_;
  ray.end_km = std::max(ray.begin_km, ray.meets_ground ? -crossing_km(ray.perigee_km, ground_km_) : reach);
  return ray;
}

} // namespace vesper
