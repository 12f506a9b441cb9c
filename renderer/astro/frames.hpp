// Celestial reference frames and the rotations between them.
#pragma once

#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// Right-handed axes. Longitudes of all but the horizon frame run from x towards y; directions turn between frames
/// without aberration or refraction, which belong to the place of a body and not to the axes.
enum class CelestialFrame {
  icrs,
  mean_of_date,     ///< mean equator and equinox of date, frame bias and precession
  true_of_date,     ///< true equator and equinox of date: nutation IAU 2000A too
  ecliptic_of_date, ///< ecliptic of date, longitudes from the true equinox: those of apparent places
  ecliptic_j2000,   ///< mean ecliptic and equinox of J2000.0
  galactic,         ///< IAU 1958 as the Hipparcos catalogue ties it to the ICRS
  horizon,          ///< x = East, y = North, z = geodetic zenith
};

/// The rotation that gives a vector of ICRS axes along `frame` at the state's instant and place.
[[nodiscard]] Mat3 frame_from_icrs(CelestialFrame frame, const EarthState& earth);

/// What frame_from_icrs needs no state of the Earth for: the mean ecliptic and equinox of a date, and galactic axes.
[[nodiscard]] Mat3 mean_ecliptic_from_icrs(JulianDate<TT> tt);
[[nodiscard]] Mat3 galactic_from_icrs();

/// The rotation from one frame to another; `frame_rotation(b, a)` is its transpose.
[[nodiscard]] Mat3 frame_rotation(CelestialFrame from, CelestialFrame to, const EarthState& earth);

} // namespace vesper
