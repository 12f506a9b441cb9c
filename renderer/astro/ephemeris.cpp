#include "vesper/astro/ephemeris.hpp"

#include "vesper/astro/ephemeris_cheap.hpp"
#include "vesper/astro/ephemeris_series.hpp"

namespace vesper {

SunEarthMoon sun_earth_moon(JulianDate<TDB> tdb, Tier tier) {
  return tier == Tier::cheap ? sun_earth_moon_cheap(tdb) : sun_earth_moon_series(tdb);
}

StateVector planet_heliocentric(Planet planet, JulianDate<TDB> tdb, Tier tier) {
  return tier == Tier::cheap ? planet_heliocentric_cheap(planet, tdb) : planet_heliocentric_series(planet, tdb);
}

} // namespace vesper
