#include "vesper/astro/body_place.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/star_place.hpp"

namespace vesper {
namespace {

constexpr double gm_sun_au3_d2 = 2.9591220828559e-4; // the square of Gauss' constant

/// Where a body was, seen from a fixed point, when the light that arrives now left it. Its velocity is uniform enough
/// over minutes; two steps settle the light time below a microsecond.
Vec3 delayed(const Vec3& now_au, const Vec3& velocity_au_d) {
  Vec3 then = now_au;
  for (int i = 0; i < 2; ++i) {
    then = now_au - glm::length(then) * light_time_d_per_au * velocity_au_d;
  }
  return then;
}

} // namespace

Vec3 sun_from_observer_au(const SunEarthMoon& bodies, const Vec3& earth_to_observer_au) {
  return delayed(bodies.sun.position_au - bodies.earth.position_au - earth_to_observer_au, bodies.sun.velocity_au_d);
}

Vec3 moon_from_observer_au(const SunEarthMoon& bodies, const Vec3& earth_to_observer_au) {
  return delayed(bodies.moon.position_au - earth_to_observer_au,
                 bodies.moon.velocity_au_d + bodies.earth.velocity_au_d);
}

Vec3 sun_from_observer_au(const EarthState& earth) {
  return sun_from_observer_au(earth.bodies, earth.earth_to_observer_au);
}

Vec3 moon_from_observer_au(const EarthState& earth) {
  return moon_from_observer_au(earth.bodies, earth.earth_to_observer_au);
}

Vec3 planet_from_observer_au(Planet planet, const EarthState& earth) {
  const StateVector from_sun = planet_heliocentric(planet, earth.tdb, earth.tier);
  const double sun_distance = glm::length(from_sun.position_au);
  const Vec3 now =
      from_sun.position_au + earth.bodies.sun.position_au - earth.bodies.earth.position_au - earth.earth_to_observer_au;
  const Vec3 velocity = from_sun.velocity_au_d + earth.bodies.sun.velocity_au_d;
  // Over the minutes and hours that light takes the Sun's pull bends the path by up to 0.1 arcsec (Mercury); what its
  // change adds is below 0.001 arcsec, so one place of the planet, which may be a long series, is enough.
  const Vec3 acceleration = -gm_sun_au3_d2 / (sun_distance * sun_distance * sun_distance) * from_sun.position_au;
  Vec3 then = now;
  for (int i = 0; i < 3; ++i) {
    const double light_days = glm::length(then) * light_time_d_per_au;
    then = now - light_days * (velocity - 0.5 * light_days * acceleration);
  }
  return then;
}

Vec3 apparent_direction_icrs(const Vec3& from_observer_au, const StarFrame& frame) {
  return f64::star_aberration(glm::normalize(from_observer_au), place_frame(frame));
}

} // namespace vesper
