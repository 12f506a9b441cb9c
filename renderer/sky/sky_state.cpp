#include "vesper/sky/sky_state.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/star_place.hpp"

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

BodyPlace body_place(const Vec3& from_observer_au, const StarFrame& frame) {
  const double distance_au = glm::length(from_observer_au);
  const Vec3 apparent = f64::star_aberration(from_observer_au / distance_au, place_frame(frame));
  const Equatorial equatorial = equatorial_of(frame.equator_of_date_from_icrs * apparent);
  BodyPlace place;
  place.right_ascension = equatorial.right_ascension;
  place.declination = equatorial.declination;
  place.direction_horizon = glm::normalize(frame.horizon_from_icrs * apparent);
  const Horizontal horizontal = horizontal_of(place.direction_horizon);
  place.azimuth = horizontal.azimuth;
  place.altitude = horizontal.altitude;
  place.distance = distance_au * astronomical_unit;
  return place;
}

/// Position angle of `to` at `from`, north through east, 0 to 360 degrees (Meeus 1998, eq. 48.5).
Angle position_angle(const BodyPlace& from, const BodyPlace& to) {
  const double dra = (to.right_ascension - from.right_ascension).to(rad);
  const double dec_to = to.declination.to(rad);
  const double dec_from = from.declination.to(rad);
  const double east = std::cos(dec_to) * std::sin(dra);
  const double north = std::sin(dec_to) * std::cos(dec_from) - std::cos(dec_to) * std::sin(dec_from) * std::cos(dra);
  const double angle = std::atan2(east, north);
  return (angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle) * rad;
}

MoonState moon_state(const Vec3& moon_au, const Vec3& sun_au, const BodyPlace& sun, const StarFrame& frame) {
  MoonState moon;
  moon.place = body_place(moon_au, frame);
  const Vec3 to_sun = sun_au - moon_au;
  const Vec3 to_observer = -moon_au;
  // The arc cosine would lose digits near new and full Moon.
  moon.phase_angle = std::atan2(glm::length(glm::cross(to_sun, to_observer)), glm::dot(to_sun, to_observer)) * rad;
  const double half = std::cos(0.5 * moon.phase_angle.to(rad));
  moon.illuminated_fraction = half * half;
  moon.bright_limb = position_angle(moon.place, sun);
  return moon;
}

} // namespace

SkyState sky_state(const Instant& instant, const Observer& observer, Tier tier) {
  const EarthState earth = earth_state(instant, observer, tier);
  const StarFrame frame = star_frame(earth);
  const Vec3 sun_au = sun_from_observer_au(earth);
  const Vec3 moon_au = moon_from_observer_au(earth);

  SkyState state;
  state.instant = instant;
  state.observer = observer;
  state.tier = tier;
  state.refraction.model = tier == Tier::cheap ? RefractionModel::published : RefractionModel::traced;
  state.refraction.conditions = standard_conditions(observer.height);
  state.stars = tier == Tier::cheap ? star_frame(instant, observer, tier) : frame;
  state.sun = body_place(sun_au, frame);
  state.moon = moon_state(moon_au, sun_au, state.sun, frame);
  state.lunar_eclipse = lunar_eclipse_state(apparent_sun_moon(earth.bodies));
  state.solar_eclipse = solar_eclipse_state(state.sun.direction_horizon * state.sun.distance.to(kilometre),
                                            state.moon.place.direction_horizon *
                                                state.moon.place.distance.to(kilometre));
  state.seconds = instant.tt.days_since({2451545.0, 0.0}) * 86400.0;
  return state;
}

} // namespace vesper
