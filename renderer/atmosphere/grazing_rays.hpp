// Rays that pass the Earth through its air, from space to space.
#pragma once

#include "vesper/atmosphere/medium.hpp"

#include <vector>

namespace vesper {

/// A ray of light bent by the air, by its lowest point.
struct GrazingRay {
  double height_km;               ///< of the lowest point above the ground
  double impact_km;               ///< distance from the Earth's centre of its straight parts
  double impact_step_km;          ///< that this ray stands for: the weight in an integral over impact_km
  double bending_rad;             ///< angle between its straight parts, towards the Earth
  std::vector<double> columns_km; ///< of each component of the medium along the ray
};

/// Rays from the ground to the top of the air, at lowest points dense enough to integrate over the Sun's disc: 10 m
/// apart in the lowest 20 km.
///
/// Rays are bent by the US Standard Atmosphere 1976 at 555 nm (blue light is bent by 1 % more than red, which is left
/// out). Heights are those above the medium's ground; the Earth is a sphere of its mean radius, 6371 km, whatever the
/// medium's. Columns as RefractedColumns gives them.
[[nodiscard]] std::vector<GrazingRay> grazing_rays(const Medium& medium);

} // namespace vesper
