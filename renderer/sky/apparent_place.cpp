#include "vesper/sky/apparent_place.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/star_place.hpp"

namespace vesper {

BodyPlace apparent_place(const Vec3& from_observer_au, const StarFrame& frame) {
  const Vec3 apparent = apparent_direction_icrs(from_observer_au, frame);
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

Vec3 apparent_equatorial(const Vec3& from_observer_au, const StarFrame& frame) {
  return glm::normalize(frame.equator_of_date_from_icrs * apparent_direction_icrs(from_observer_au, frame));
}

} // namespace vesper
