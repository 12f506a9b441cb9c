// Sun, Earth, Moon and planets by analytic series, for dates outside the embedded table.
#pragma once

#include "vesper/astro/ephemeris.hpp"

namespace vesper {

[[nodiscard]] SunEarthMoon sun_earth_moon_series(JulianDate<TDB> tdb);
[[nodiscard]] StateVector planet_heliocentric_series(Planet planet, JulianDate<TDB> tdb);

} // namespace vesper
