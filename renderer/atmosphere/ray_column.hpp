// What a straight ray passes of one profile, for the quadratures along rays.
#pragma once

#include "vesper/atmosphere/height_profile.hpp"
#include "vesper/atmosphere/quadrature.hpp"

#include <cmath>
#include <vector>

namespace vesper {

/// A part of a straight line. Places on it are its distances in km from its perigee, the point nearest to the planet's
/// centre.
struct RaySpan {
  double perigee_km = 0.0; ///< distance of that point from the centre
  double begin_km = 0.0;
  double end_km = 0.0;
};

/// Distance from the perigee at which a line crosses a sphere; 0 where it passes above.
[[nodiscard]] inline double crossing_km(double perigee_km, double radius_km) {
  return radius_km > perigee_km ? std::sqrt((radius_km - perigee_km) * (radius_km + perigee_km)) : 0.0;
}

/// Adds the places on the span at which the profile's pieces meet.
void append_cuts(std::vector<double>& cuts, const HeightProfile& profile, const RaySpan& span, double ground_km);

/// Integral of the profile along the span in km, with the bound of its error, below 1e-8 of it. Where the span lies
/// under the ground, by rounding, the density is that of the ground.
[[nodiscard]] Integral column(const HeightProfile& profile, const RaySpan& span, double ground_km);

} // namespace vesper
