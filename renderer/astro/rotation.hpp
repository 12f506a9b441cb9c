// Rotations about the coordinate axes.
//
// Each turns vectors by an angle in radians, right-handed; the axes turned by an angle, as astronomers often write
// their R_x, R_y, R_z, are vectors turned by its negative.
#pragma once

#include "vesper/base/vector.hpp"

#include <cmath>

namespace vesper {

/// About x, y towards z.
[[nodiscard]] inline Mat3 turn_x(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {1.0, 0.0, 0.0, 0.0, c, s, 0.0, -s, c};
}

/// About y, z towards x.
[[nodiscard]] inline Mat3 turn_y(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, c};
}

/// About z, x towards y.
[[nodiscard]] inline Mat3 turn_z(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0};
}

} // namespace vesper
