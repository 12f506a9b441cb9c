// Sun, Earth, Moon and planets by analytic theories cut short, for dates outside the embedded table.
#pragma once

#include "vesper/astro/ephemeris.hpp"

namespace vesper {

/// Moon by ELP/MPP02 with the constants of DE405 (Chapront and Francou 2003, A&A 404, 735), 838 terms. Earth and Sun by
/// VSOP87B (Bretagnon and Francou 1988, A&A 202, 309); the Sun's distance from the barycentre by the four giant
/// planets. Any date that times may have, -4712 to 9999.
///
/// Against JPL ephemerides from 1900 to 2100: Moon 0.7 arcsec and 1 km worst, Sun 0.05 arcsec and 15 km. Errors grow
/// with the distance from 2000:
/// - Moon: with its tidal acceleration, known to about 0.05 arcsec per century squared (0.2 arcsec in 1800, 20 in the
///   year 0, 2 arcmin in -3000), and beyond -3000 and +3000 with the polynomials of its mean arguments: eraMoon98, of
///   another generation of the theory, leaves it by 3 arcmin in -3000, 6 arcmin in -4712, 20 arcmin in 9999.
/// - Sun: 0.2 arcsec in 1600 and 2400 against eraEpv00, about 1 arcsec over 4000 years around 2000 (the VSOP87 paper),
///   perhaps 10 arcsec at -4712 and 9999.
///
/// For an observer both are small against the error of Delta-T, which turns the Earth under the sky: a quarter of an
/// hour of it is 4 degrees of the Earth's rotation and 8 arcmin of the Moon.
[[nodiscard]] SunEarthMoon sun_earth_moon_series(JulianDate<TDB> tdb);

/// VSOP87B. Against JPL ephemerides from 1900 to 2100, seen from the Earth: 1.1 arcsec worst (Mercury to Saturn), 2.5
/// (Uranus, Neptune). The full theory holds 1 arcsec over 4000 years around 2000 for Mercury to Mars, 2000 for Jupiter
/// and Saturn, 6000 for Uranus and Neptune; outside, errors grow with the last powers of the time: by its size an
/// arcminute for Mercury and Venus, some for Mars, Uranus and Neptune, and for Jupiter and Saturn tenths of a degree at
/// -4712 and a degree or more at 9999.
[[nodiscard]] StateVector planet_heliocentric_series(Planet planet, JulianDate<TDB> tdb);

/// The Moon of sun_earth_moon_series, from the Earth's centre. Its velocity is good to 1e-8 au a day.
[[nodiscard]] StateVector moon_geocentric_series(JulianDate<TDB> tdb);

} // namespace vesper
