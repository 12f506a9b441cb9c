// The Sun in directions rather than places on its disc.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"

namespace vesper::test {

/// Luminance of disc and corona, with the Moon before them, in a direction (unit vector): X, Y, Z, S.
inline Vec4 sun_seen(const Vec3& direction, const f64::SunShading& sun) {
  if (glm::dot(direction, sun.direction) <= 0.0 || glm::length(direction - sun.moon_direction) < sun.moon_chord) {
    return Vec4(0.0);
  }
  const Vec2 place = Vec2(glm::dot(direction, sun.aside), glm::dot(direction, sun.upward)) / sun.sin_radius;
  const double r = glm::length(place);
  return r <= 1.0 ? f64::sun_disc_luminance(r, sun) : f64::corona_luminance(place, sun);
}

} // namespace vesper::test
