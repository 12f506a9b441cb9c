#include "vesper/astro/ephemeris_series.hpp"

#include <erfa.h>

namespace vesper {
namespace {

StateVector state_of(const double (&pv)[2][3]) {
  return {{pv[0][0], pv[0][1], pv[0][2]}, {pv[1][0], pv[1][1], pv[1][2]}};
}

} // namespace

SunEarthMoon sun_earth_moon_series(JulianDate<TDB> tdb) {
  double heliocentric[2][3];
  double barycentric[2][3];
  double geocentric[2][3];
  eraEpv00(tdb.day, tdb.fraction, heliocentric, barycentric); // its warning outside 1900 to 2100 is in the docstring
  eraMoon98(tdb.day, tdb.fraction, geocentric);
  SunEarthMoon bodies;
  bodies.earth = state_of(barycentric);
  const StateVector from_sun = state_of(heliocentric);
  bodies.sun = {bodies.earth.position_au - from_sun.position_au, bodies.earth.velocity_au_d - from_sun.velocity_au_d};
  bodies.moon = state_of(geocentric);
  return bodies;
}

StateVector planet_heliocentric_series(Planet planet, JulianDate<TDB> tdb) {
  constexpr int erfa_numbers[planet_count] = {1, 2, 4, 5, 6, 7, 8};
  double pv[2][3];
  eraPlan94(tdb.day, tdb.fraction, erfa_numbers[static_cast<int>(planet)], pv);
  return state_of(pv);
}

} // namespace vesper
