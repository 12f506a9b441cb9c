// Sun, Earth, Moon and planets by analytic theories cut short, for dates outside the embedded table.
#pragma once

#include "vesper/astro/ephemeris.hpp"

namespace vesper {

/// Moon by ELP/MPP02 with the constants of DE405 (Chapront and Francou 2003, A&A 404, 735), 838 terms. Earth and Sun by
/// VSOP87B (Bretagnon and Francou 1988, A&A 202, 309); the Sun's distance from the barycentre by the four giant
/// planets.
///
/// Against JPL ephemerides from 1900 to 2100: Moon 0.7 arcsec and 2 km worst, Sun 0.1 arcsec. Outside, errors grow:
/// - Moon: with the tidal acceleration, known to about 0.05 arcsec per century squared (0.1 arcsec in 1800, 20 arcsec
/// in
///   the year 0, 2 arcmin in -3000), and beyond -3000 and +3000 with the polynomials of its mean arguments, by degrees
///   at -4712 and 9999. Distances keep sound everywhere.
/// - Sun: about 1 arcsec over 4000 years around 2000 (the VSOP87 paper), some arcsec at -4712 and 9999.
///
/// For an observer both errors stay small against that of Delta-T: an hour or more in -3000 is half a degree of the
/// Moon and 15 degrees of the Earth's rotation.
[[nodiscard]] SunEarthMoon sun_earth_moon_series(JulianDate<TDB> tdb);

/// VSOP87B. Against JPL ephemerides from 1900 to 2100, seen from the Earth: 3 arcsec (Mercury to Saturn), 5 arcsec
/// (Uranus, Neptune). The full theory holds 1 arcsec over 4000 years around 2000 for Mercury to Mars, 2000 for Jupiter
/// and Saturn, 6000 for Uranus and Neptune; outside, errors grow with the power of the time: about arcminutes for
/// Jupiter and Saturn at -4712 and 9999.
[[nodiscard]] StateVector planet_heliocentric_series(Planet planet, JulianDate<TDB> tdb);

/// The Moon of sun_earth_moon_series, from the Earth's centre. Its velocity is good to 1e-8 au a day.
[[nodiscard]] StateVector moon_geocentric_series(JulianDate<TDB> tdb);

} // namespace vesper
