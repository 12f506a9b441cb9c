#include "vesper/sky/apparent_place.hpp"

#include "vesper/astro/star_place.hpp"

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

Vec3 aberrated(const Vec3& from_observer_au, const StarFrame& frame) {
  return f64::star_aberration(glm::normalize(from_observer_au), place_frame(frame));
}

} // namespace

BodyPlace apparent_place(const Vec3& from_observer_au, const StarFrame& frame) {
  const Vec3 apparent = aberrated(from_observer_au, frame);
  BodyPlace place;
  place.direction_equatorial = glm::normalize(frame.equator_of_date_from_icrs * apparent);
  const Equatorial equatorial = equatorial_of(place.direction_equatorial);
  place.right_ascension = equatorial.right_ascension;
  place.declination = equatorial.declination;
  place.direction_horizon = glm::normalize(frame.horizon_from_icrs * apparent);
  const Horizontal horizontal = horizontal_of(place.direction_horizon);
  place.azimuth = horizontal.azimuth;
  place.altitude = horizontal.altitude;
  place.distance = glm::length(from_observer_au) * astronomical_unit;
  return place;
}

Vec3 apparent_direction(const Vec3& from_observer_au, const StarFrame& frame) {
  return glm::normalize(frame.equator_of_date_from_icrs * aberrated(from_observer_au, frame));
}

Angle position_angle(const Vec3& from, const Vec3& to) {
  // East and north components of `to`, both times the cosine of the declination of `from`.
  const double east = from.x * to.y - from.y * to.x;
  const double north = to.z - from.z * glm::dot(from, to);
  constexpr double turn = 2.0 * std::numbers::pi;
  const double angle = std::atan2(east, north);
  const double positive = angle < 0.0 ? angle + turn : angle;
  return (positive >= turn ? 0.0 : positive) * rad;
}

} // namespace vesper
