#include "vesper/astro/body_place.hpp"

namespace vesper {
namespace {

constexpr double light_days_per_au = 499.004783836156412 / 86400.0; // IAU 2012 au over c

/// Where a body was, seen from a fixed point, when the light that arrives now left it. Its velocity is uniform enough
/// over minutes; two steps settle the light time below a microsecond.
Vec3 delayed(const Vec3& now_au, const Vec3& velocity_au_d) {
  Vec3 then = now_au;
  for (int i = 0; i < 2; ++i) {
    then = now_au - glm::length(then) * light_days_per_au * velocity_au_d;
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
  const Vec3 observer = earth.bodies.earth.position_au + earth.earth_to_observer_au;
  const StateVector& sun = earth.bodies.sun;
  Vec3 from_observer{};
  double light_days = 0.0;
  // Over the hours that light takes from the outer planets a velocity is not uniform enough: the place is computed anew
  // for the retarded time. Neptune moves 0.003 au in its 4 h: three steps settle it.
  for (int i = 0; i < 3; ++i) {
    const StateVector from_sun = planet_heliocentric(planet, earth.tdb.plus_days(-light_days), earth.tier);
    from_observer = sun.position_au - light_days * sun.velocity_au_d + from_sun.position_au - observer;
    light_days = glm::length(from_observer) * light_days_per_au;
  }
  return from_observer;
}

} // namespace vesper
