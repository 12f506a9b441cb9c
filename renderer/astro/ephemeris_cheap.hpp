// Sun, Earth and Moon by the short series of the night-sky literature, planets by mean elements: the cheap tier.
#pragma once

#include "vesper/astro/ephemeris.hpp"

namespace vesper {

/// Sun and Moon by Jensen et al. 2001 (printed in Perez 2022, section 3.3) with the coefficient 0.000351 of sin 2M put
/// in, in the mean ecliptic of date, turned to ICRS by the rotations of Mueller et al. 2012, eq. 8. The Sun stands for
/// the barycentre of the solar system; velocities are central differences.
///
/// From 1900 to 2100: Moon within 6 arcmin (RMS 110 arcsec) and 800 km, Sun within 35 arcsec (RMS 11). The rates of the
/// formulas have no secular terms: errors grow to degrees within some millennia.
[[nodiscard]] SunEarthMoon sun_earth_moon_cheap(JulianDate<TDB> tdb);

/// By eraPlan94 (Simon et al. 1994, A&A 282, 663, section 6): seen from the Sun 6 to 81 arcsec worst from 1800 to 2050
/// by planet, up to a degree between 1000 and 3000, without a warrant outside.
[[nodiscard]] StateVector planet_heliocentric_cheap(Planet planet, JulianDate<TDB> tdb);

} // namespace vesper
