#include "vesper/astro/refraction_trace.hpp"

#include "vesper/base/shader_math.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesper {
namespace {

/// Below this n + r n' is taken for a duct, out of which no ray leads.
constexpr double least_slope = 0.1;

void gauss_legendre(int order, std::vector<double>& abscissae, std::vector<double>& weights) {
  for (int i = 0; i < order; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (order + 0.5));
    double derivative = 1.0;
    for (int iteration = 0; iteration < 8; ++iteration) {
      double p = x;
      double before = 1.0;
      for (int k = 2; k <= order; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      derivative = order * (x * p - before) / (x * x - 1.0);
      x -= p / derivative;
    }
    abscissae.push_back(x);
    weights.push_back(2.0 / ((1.0 - x * x) * derivative * derivative));
  }
}

} // namespace

RefractionTracer::RefractionTracer(const RefractionConditions& conditions, TraceQuality quality)
    : air_(conditions), ground_km_(std::min(0.0, air_.observer_km())), panels_(quality.panels) {
  gauss_legendre(quality.order, abscissae_, weights_);
  // Above 21 km there is little left to bend light.
  boundaries_km_ = quality.every_corner
                       ? air_profile_corners_km()
                       : std::vector<double>{10.016, 12.023, 19.057, 21.070, 32.0, 50.0, top_of_air_km};
  constexpr double step_km = 0.05;
  double free_of_ducts = air_.observer_km();
  while (free_of_ducts > ground_km_ && optics(free_of_ducts - step_km).n_r_slope > least_slope) {
    free_of_ducts -= step_km;
  }
  ground_km_ = std::max(ground_km_, free_of_ducts);
}

RefractionTracer::Optics RefractionTracer::optics(double height_km) const {
  const AirProfile::Air air = air_.at(height_km);
  const double radius = f64::earth_radius_km + height_km;
  const double n = 1.0 + air.refractivity;
  const double slope = n + radius * air.gradient_per_km;
  return {n * radius, slope, -radius * air.gradient_per_km / slope};
}

Angle RefractionTracer::horizon() const {
  const double here = optics(air_.observer_km()).n_r;
  const double ground = optics(ground_km_).n_r;
  return -std::atan2(std::sqrt((here - ground) * (here + ground)), ground) * rad;
}

double RefractionTracer::lowest_of(double invariant_km) const {
  double height = air_.observer_km();
  for (int i = 0; i < 30; ++i) {
    const Optics o = optics(height);
    const double step = (o.n_r - invariant_km) / o.n_r_slope;
    height = std::clamp(height - step, ground_km_, air_.observer_km());
    if (std::abs(step) < 1.0e-10) {
      break;
    }
  }
  return height;
}

/// The integral along the part of a ray that rises from one height to another.
double RefractionTracer::between(double low_km, double high_km, double invariant_km) const {
  const auto zenith_angle = [&](double height) {
    const double n_r = optics(height).n_r;
    return std::atan2(invariant_km, std::sqrt(std::max((n_r - invariant_km) * (n_r + invariant_km), 0.0)));
  };
  double sum = 0.0;
  double height = low_km;
  double steep = zenith_angle(low_km);
  for (const double boundary : boundaries_km_) {
    if (boundary <= low_km) {
      continue;
    }
    const double flat = zenith_angle(std::min(boundary, high_km));
    const double half = 0.5 * (steep - flat) / panels_;
    for (int panel = 0; panel < panels_; ++panel) {
      const double middle = steep - (2 * panel + 1) * half;
      // From the steepest abscissa on, so that each height is a start for the next.
      for (std::size_t i = 0; i < abscissae_.size(); ++i) {
        const double n_r = invariant_km / std::sin(middle + half * abscissae_[i]);
        Optics o = optics(height);
        for (int iteration = 0; iteration < 20; ++iteration) {
          const double step = (n_r - o.n_r) / o.n_r_slope;
          height += step;
          o = optics(height);
          // Newton's next step would be the square of this one over the scale height.
          if (std::abs(step) < 1.0e-4) {
            break;
          }
        }
        sum += half * weights_[i] * o.bending;
      }
    }
    if (boundary >= high_km) {
      break;
    }
    steep = flat;
  }
  return sum;
}

TracedRay RefractionTracer::trace(Angle apparent_altitude) const {
  const double altitude = apparent_altitude.to(rad);
  const double here = air_.observer_km();
  const double invariant = optics(here).n_r * std::cos(altitude);
  // At the zenith the zenith angle is no variable to integrate over.
  if (invariant < 1.0e-9) {
    const bool down = altitude < 0.0;
    return {0.0 * rad, down, (down ? ground_km_ : here) * kilometre};
  }
  if (altitude >= 0.0) {
    return {between(here, top_of_air_km, invariant) * rad, false, here * kilometre};
  }
  // Heights differ by less than a micrometre between a ray that grazes the ground and its rounded altitude.
  if (invariant < optics(ground_km_).n_r - 1.0e-9) {
    return {0.0 * rad, true, ground_km_ * kilometre};
  }
  const double lowest = lowest_of(invariant);
  return {(between(lowest, here, invariant) + between(lowest, top_of_air_km, invariant)) * rad, false,
          lowest * kilometre};
}

} // namespace vesper
