#include "vesper/astro/ephemeris.hpp"

#include "vesper/astro/ephemeris_cheap.hpp"
#include "vesper/astro/ephemeris_series.hpp"
#include "vesper/astro/ephemeris_table.hpp"

#include <array>

namespace vesper {

std::string_view name_of(Planet planet) {
  constexpr std::array<std::string_view, planet_count> names{"mercury", "venus",  "mars",   "jupiter",
                                                             "saturn",  "uranus", "neptune"};
  return names.at(static_cast<std::size_t>(planet));
}

SunEarthMoon sun_earth_moon(JulianDate<TDB> tdb, Tier tier) {
  if (tier == Tier::cheap) {
    return sun_earth_moon_cheap(tdb);
  }
  if (const auto bodies = EphemerisTable::embedded().sun_earth_moon(tdb)) {
    return *bodies;
  }
  return sun_earth_moon_series(tdb);
}

StateVector planet_heliocentric(Planet planet, JulianDate<TDB> tdb, Tier tier) {
  if (tier == Tier::cheap) {
    return planet_heliocentric_cheap(planet, tdb);
  }
  if (const auto state = EphemerisTable::embedded().planet_heliocentric(planet, tdb)) {
    return *state;
  }
  return planet_heliocentric_series(planet, tdb);
}

} // namespace vesper
