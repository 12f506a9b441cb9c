#include "vesper/atmosphere/earth_shadow_solver.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/base/shader_math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

using std::numbers::pi;

/// Integrals of the powers of mu, 0 to 5, over the angle of a circle about a point, inside the Sun's disc of radius 1.
/// \param ring radius of the circle
/// \param off distance of its centre from the Sun's, both >= 0
LimbSeries around(double ring, double off) {
  constexpr std::size_t nodes = 12;
  struct Rule {
    std::array<double, nodes> sine, weight; // of a quarter of a turn: the ends of an arc lie at the Sun's limb
  };
  static const Rule rule = [] {
    Rule made{};
    const std::vector<QuadratureNode> gauss = gauss_legendre(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
      const double angle = 0.5 * pi * gauss[i].place;
      made.sine.at(i) = std::sin(angle);
      made.weight.at(i) = 0.5 * pi * gauss[i].weight * std::cos(angle);
    }
    return made;
  }();
  LimbSeries sums{};
  const bool whole = ring + off <= 1.0;
  if (!whole && (ring >= 1.0 + off || off >= 1.0 + ring)) {
    return sums;
  }
  const double half = whole ? pi : f64::common_chord_half_angle(ring, 1.0, off);
  for (std::size_t i = 0; i < nodes; ++i) {
    const double angle = half * rule.sine.at(i);
    const double mu2 = 1.0 - ring * ring - off * off + 2.0 * ring * off * std::cos(angle);
    const double mu = std::sqrt(std::max(mu2, 0.0));
    double term = 2.0 * half * rule.weight.at(i);
    for (double& sum : sums) {
      sum += term;
      term *= mu;
    }
  }
  return sums;
}

} // namespace

EarthShadowSolver::EarthShadowSolver(const Medium& medium, std::vector<double> wavelengths_nm,
                                     std::vector<EarthShadowLoad> loads)
    : wavelengths_nm_(std::move(wavelengths_nm)), loads_(std::move(loads)),
      rays_(grazing_rays(with_stratospheric_dust(medium))),
      glow_(with_stratospheric_dust(medium), wavelengths_nm_, loads_) {
  const Medium dusty = with_stratospheric_dust(medium);
  const std::size_t dust = dusty.components.size() - 1;
  std::vector<double> extinction;
  for (const double nm : wavelengths_nm_) {
    for (const MediumComponent& component : dusty.components) {
      extinction.push_back(component.extinction_per_km(nm));
    }
    darkening_.push_back(limb_series(nm, LimbDarkening::hestroffer_magnan));
  }
  for (const GrazingRay& ray : rays_) {
    for (const EarthShadowLoad& load : loads_) {
      const double passing = share_past_clouds(load, ray.height_km);
      for (std::size_t i = 0; i < wavelengths_nm_.size(); ++i) {
        double depth = 0.0;
        for (std::size_t c = 0; c <= dust; ++c) {
          depth +=
              extinction[i * (dust + 1) + c] * ray.columns_km[c] * (c == dust ? load.stratospheric_optical_depth : 1.0);
        }
        transmittance_.push_back(passing * std::exp(-depth));
      }
    }
  }
}

/// Adds the light of one circle about the Earth's centre.
void EarthShadowSolver::add_direct(double ring, double off, double weight, const double* transmittance,
                                   std::vector<double>& sums) const {
  const LimbSeries arc = around(ring, off);
  if (arc[0] == 0.0) {
    return;
  }
  const std::size_t count = wavelengths_nm_.size();
  for (std::size_t i = 0; i < count; ++i) {
    double light = 0.0;
    for (std::size_t k = 0; k < limb_terms; ++k) {
      light += darkening_[i].at(k) * arc.at(k) / pi;
    }
    for (std::size_t l = 0; l < loads_.size(); ++l) {
      sums[l * count + i] += weight * light * (transmittance != nullptr ? transmittance[l * count + i] : 1.0);
    }
  }
}

std::vector<double> EarthShadowSolver::shares(const Vec2& place_km, Length sun_distance) const {
  const std::size_t count = wavelengths_nm_.size();
  std::vector<double> sums(loads_.size() * count, 0.0);
  const double moon_km = std::hypot(place_km.x, place_km.y);
  const double per_km = 1.0 / moon_km + 1.0 / sun_distance.to(kilometre);
  const double sun_rad = std::asin(sun_radius / sun_distance);
  const double off_rad = std::atan2(place_km.x, place_km.y);
  const double off = off_rad / sun_rad;

  // Past the air.
  const double clear = rays_.back().impact_km * per_km / sun_rad;
  const double first = std::max(clear, std::max(off - 1.0, 0.0));
  if (first < 1.0 + off) {
    static const std::vector<QuadratureNode> rule = gauss_legendre(64);
    for (const QuadratureNode& node : rule) {
      const double ring = first + (1.0 + off - first) * 0.5 * (1.0 - std::cos(pi * node.place));
      const double step = (1.0 + off - first) * 0.5 * pi * std::sin(pi * node.place) * node.weight;
      add_direct(ring, off, ring * step, nullptr, sums);
    }
  }
  // Through it.
  const double scale = per_km * per_km / (sun_rad * sun_rad);
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    const GrazingRay& ray = rays_[r];
    const double ring = std::abs(ray.impact_km * per_km - ray.bending_rad) / sun_rad;
    add_direct(ring, off, scale * ray.impact_km * ray.impact_step_km, &transmittance_[r * loads_.size() * count], sums);
  }
  // From the air.
  constexpr int azimuths = 12; // of half a turn
  const double to_sun = 1.0 + place_km.y / sun_distance.to(kilometre);
  for (int k = 0; k < azimuths; ++k) {
    const double above = f64::earth_radius_km * per_km - off_rad * std::cos(pi * (k + 0.5) / azimuths);
    const double weight = 2.0 * pi / azimuths / (moon_km * moon_km) * to_sun * to_sun;
    for (std::size_t l = 0; l < loads_.size(); ++l) {
      glow_.add(l, above, weight, std::span(sums).subspan(l * count, count));
    }
  }
  return sums;
}

} // namespace vesper
