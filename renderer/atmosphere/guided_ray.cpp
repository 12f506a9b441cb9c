#include "vesper/atmosphere/guided_ray.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesper {

GuidedRay::GuidedRay(const SampledAir& air, const SpectralAir& optics, const TransportGuide& guide,
                     const Vec3& light_direction)
    : air_(air), optics_(optics), guide_(guide), light_direction_(light_direction) {
  for (std::size_t c = 0; c < air.component_count(); ++c) {
    for (std::size_t k = 0; k < guide.wavelengths().size(); ++k) {
      scattering_per_km_[c][k] = optics.scattering_per_km(c, guide.wavelengths()[k]);
      extinction_per_km_[c][k] = optics.extinction_per_km(c, guide.wavelengths()[k]);
    }
  }
}

double GuidedRay::cos_light_zenith(double place_km) const {
  return (light_at_origin_km_ + (place_km - ray_.origin_km) * cos_light_) / ray_.radius_km(place_km);
}

void GuidedRay::find_phases() {
  for (std::size_t c = 0; c < air_.component_count(); ++c) {
    for (std::size_t k = 0; k < guide_.wavelengths().size(); ++k) {
      phase_[c][k] = optics_.phase(c, guide_.wavelengths()[k], cos_light_);
    }
  }
}

void GuidedRay::lay(const Vec3& origin_km, const Vec3& direction) {
  const double radius = glm::length(origin_km);
  origin_km_ = origin_km;
  direction_ = direction;
  ray_ = air_.ray(radius, std::clamp(glm::dot(origin_km, direction) / radius, -1.0, 1.0));
  cos_light_ = glm::dot(direction, light_direction_);
  light_at_origin_km_ = glm::dot(origin_km, light_direction_);
  find_phases();
  cells_.clear();
  guided_sum_ = {};
  plain_sum_ = {};
  Passed passed;
  bool seen_through = true;
  air_.for_each_cell(ray_, SampledAir::longest_cell_km, [&](double from, double to) {
    // Thick air is cut finer, because a cell's places are drawn evenly.
    constexpr double deepest = 0.5;
    const double depth = (to - from) * optics_.most_extinction_per_km(air_.density(ray_.radius_km(0.5 * (from + to))));
    const auto pieces = static_cast<int>(std::clamp(std::ceil(depth / deepest), 1.0, 64.0));
    double begin = from;
    for (int i = 1; i <= pieces && seen_through; ++i) {
      const double end = i < pieces ? from + (to - from) * (static_cast<double>(i) / pieces) : to;
      add_cell(begin, end, passed);
      begin = end;
      seen_through = !optics_.opaque(passed.columns_km);
    }
    return seen_through;
  });
  if (ray_.meets_ground && seen_through) {
    add_ground(passed);
  }
}

void GuidedRay::add(const Cell& cell) {
  for (std::size_t k = 0; k < TransportGuide::most_wavelengths; ++k) {
    guided_sum_[k] += cell.guided[k];
    plain_sum_[k] += cell.plain[k];
  }
  cells_.push_back(cell);
}

void GuidedRay::add_cell(double from_km, double to_km, Passed& passed) {
  const double middle = 0.5 * (from_km + to_km);
  const double radius = ray_.radius_km(middle);
  const SampledAir::PerComponent density = air_.density(radius);
  const TransportGuide::Light light = guide_.light(radius, cos_light_zenith(middle));
  Cell cell{from_km, to_km, passed.columns_km, {}, {}};
  air_.add_columns(ray_, from_km, to_km, passed.columns_km);
  Values depth_after{};
  Values guided{};
  double plain = 0.0;
  for (std::size_t c = 0; c < air_.component_count(); ++c) {
    for (std::size_t k = 0; k < TransportGuide::most_wavelengths; ++k) {
      depth_after[k] += extinction_per_km_[c][k] * passed.columns_km[c];
      guided[k] += density[c] * scattering_per_km_[c][k] * (phase_[c][k] * light.beam[k] + light.scattered[k]);
    }
    plain += density[c] * optics_.mean_scattering_per_km(c);
  }
  for (std::size_t k = 0; k < guide_.wavelengths().size(); ++k) {
    const double arrives = (to_km - from_km) * std::exp(-0.5 * (passed.optical_depth[k] + depth_after[k]));
    cell.guided[k] = arrives * guided[k];
    cell.plain[k] = arrives * plain;
  }
  passed.optical_depth = depth_after;
  add(cell);
}

void GuidedRay::add_ground(const Passed& passed) {
  Cell ground{ray_.end_km, ray_.end_km, passed.columns_km, {}, {}};
  const Values irradiance = guide_.ground_irradiance(cos_light_zenith(ray_.end_km));
  for (std::size_t k = 0; k < guide_.wavelengths().size(); ++k) {
    const double arrives = std::exp(-passed.optical_depth[k]);
    ground.guided[k] = arrives * optics_.albedo(guide_.wavelengths()[k]) * irradiance[k] / std::numbers::pi;
    ground.plain[k] = arrives * optics_.mean_albedo();
  }
  add(ground);
}

/// The probability of a cell.
double GuidedRay::share(const Cell& cell, std::size_t k) const {
  constexpr double plain_share = 0.1;
  const double plain = plain_sum_[k] > 0.0 ? cell.plain[k] / plain_sum_[k] : 0.0;
  return guided_sum_[k] > 0.0 ? plain_share * plain + (1.0 - plain_share) * cell.guided[k] / guided_sum_[k] : plain;
}

std::optional<GuidedRay::Place> GuidedRay::draw(std::size_t k, double u) const {
  double left = u;
  const Cell* chosen = nullptr;
  double chosen_share = 0.0;
  for (const Cell& cell : cells_) {
    const double own = share(cell, k);
    if (own > 0.0) {
      chosen = &cell;
      chosen_share = own;
      if (left < own) {
        break;
      }
      left -= own;
    }
  }
  if (chosen == nullptr) {
    return std::nullopt;
  }
  Place place;
  place.columns_km = chosen->columns_km;
  const double length = chosen->to_km - chosen->from_km;
  place.on_ground = !(length > 0.0);
  double at_km = chosen->from_km;
  if (!place.on_ground) {
    at_km += length * std::clamp(left / chosen_share, 0.0, 1.0);
    air_.add_columns(ray_, chosen->from_km, at_km, place.columns_km);
  }
  place.place_km = origin_km_ + (at_km - ray_.origin_km) * direction_;
  place.radius_km = glm::length(place.place_km);
  if (place.on_ground || place.radius_km < air_.ground_km()) {
    place.place_km *= air_.ground_km() / place.radius_km;
    place.radius_km = air_.ground_km();
  }
  for (std::size_t i = 0; i < guide_.wavelengths().size(); ++i) {
    place.density[i] = share(*chosen, i) / (place.on_ground ? 1.0 : length);
  }
  return place;
}

} // namespace vesper
