#include "vesper/astro/sun_moon.hpp"

#include <erfa.h>

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

Vec3 sun_from_observer_au(const EarthState& earth) {
  return delayed(-(earth.sun_to_earth_au + earth.earth_to_observer_au), earth.sun_velocity_au_d);
}

Vec3 moon_from_observer_au(const EarthState& earth) {
  double geocentric[2][3];
  eraMoon98(earth.instant.tt.day, earth.instant.tt.fraction, geocentric);
  const Vec3 position(geocentric[0][0], geocentric[0][1], geocentric[0][2]);
  const Vec3 velocity(geocentric[1][0], geocentric[1][1], geocentric[1][2]);
  return delayed(position - earth.earth_to_observer_au, velocity + earth.earth_velocity_au_d);
}

} // namespace vesper
