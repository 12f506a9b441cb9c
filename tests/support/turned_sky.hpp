// Real skies turned so that a body stands where a test wants it.
#pragma once

#include "vesper/astro/star_place.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/sky/sky_state.hpp"

#include <cmath>

namespace vesper::test {

/// The smallest turn that takes one unit vector to another.
inline Mat3 turn_between(const Vec3& from, const Vec3& to) {
  const Vec3 axis = glm::cross(from, to);
  const double cosine = glm::dot(from, to);
  if (cosine < -0.999999) {
    const Vec3 aside = glm::normalize(glm::cross(from, std::abs(from.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
    return 2.0 * glm::outerProduct(aside, aside) - Mat3(1.0);
  }
  const Mat3 cross_product(Vec3(0.0, axis.z, -axis.y), Vec3(-axis.z, 0.0, axis.x), Vec3(axis.y, -axis.x, 0.0));
  return Mat3(1.0) + cross_product + cross_product * cross_product / (1.0 + cosine);
}

inline void move_to(BodyPlace& place, const Vec3& direction) {
  place.direction_horizon = direction;
  const Horizontal horizontal = horizontal_of(direction);
  place.azimuth = horizontal.azimuth;
  place.altitude = horizontal.altitude;
}

/// All of the sky that Moon and Sun need, turned about the observer.
inline SkyState turned(const SkyState& sky, const Mat3& turn) {
  SkyState result = sky;
  result.stars.horizon_from_icrs = turn * sky.stars.horizon_from_icrs;
  move_to(result.sun, turn * sky.sun.direction_horizon);
  move_to(result.moon.place, turn * sky.moon.place.direction_horizon);
  return result;
}
inline SkyState with_moon_at(const SkyState& sky, const Vec3& direction) {
  return turned(sky, turn_between(sky.moon.place.direction_horizon, direction));
}
inline SkyState with_sun_at(const SkyState& sky, const Vec3& direction) {
  return turned(sky, turn_between(sky.sun.direction_horizon, direction));
}

} // namespace vesper::test
