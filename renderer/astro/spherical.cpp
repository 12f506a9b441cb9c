#include "vesper/astro/spherical.hpp"

#include <cmath>
#include <numbers>

namespace vesper {

Vec3 unit_vector(double longitude_rad, double latitude_rad) {
  const double c = std::cos(latitude_rad);
  return {c * std::cos(longitude_rad), c * std::sin(longitude_rad), std::sin(latitude_rad)};
}

Angle whole_turn_atan2(double y, double x) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double angle = std::atan2(y, x);
  const double positive = angle < 0.0 ? angle + turn : angle;
  return (positive >= turn ? 0.0 : positive) * rad;
}

Angle latitude_of(const Vec3& v) { return std::atan2(v.z, std::hypot(v.x, v.y)) * rad; }

Angle angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * rad;
}

Angle position_angle(const Vec3& from, const Vec3& to) {
  // East and north components of `to`, both times the cosine of the declination of `from`.
  const double east = from.x * to.y - from.y * to.x;
  const double north = to.z - from.z * glm::dot(from, to);
  return whole_turn_atan2(east, north);
}

Mat3 horizon_from_disc(const Vec3& direction) {
  const double across = std::hypot(direction.x, direction.y);
  const Vec2 azimuth = across > 0.0 ? Vec2(direction.x, direction.y) / across : Vec2(0.0, 1.0);
  return {Vec3(azimuth.y, -azimuth.x, 0.0), Vec3(-direction.z * azimuth.x, -direction.z * azimuth.y, across),
          direction};
}

} // namespace vesper
