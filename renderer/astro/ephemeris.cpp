#include "vesper/astro/ephemeris.hpp"

#include "vesper/astro/ephemeris_series.hpp"
#include "vesper/astro/ephemeris_table.hpp"

namespace vesper {

SunEarthMoon sun_earth_moon(JulianDate<TDB> tdb, Tier tier) {
  if (tier != Tier::cheap) {
    if (const auto bodies = EphemerisTable::embedded().sun_earth_moon(tdb)) {
      return *bodies;
    }
  }
  return sun_earth_moon_series(tdb);
}

StateVector planet_heliocentric(Planet planet, JulianDate<TDB> tdb, Tier tier) {
  if (tier != Tier::cheap) {
    if (const auto state = EphemerisTable::embedded().planet_heliocentric(planet, tdb)) {
      return *state;
    }
  }
  return planet_heliocentric_series(planet, tdb);
}

} // namespace vesper
