// The Earth and the observer on it at one instant: what every place in the sky is reduced with.
#pragma once

#include "vesper/astro/ephemeris.hpp"
#include "vesper/astro/observer.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// Vectors in au and au/day along ICRS axes.
struct EarthState {
  Instant instant;
  Observer observer;
  Tier tier = Tier::standard;
  JulianDate<TDB> tdb;
  SunEarthMoon bodies;
  Vec3 earth_to_observer_au{};
  Vec3 observer_velocity_au_d{};        ///< geocentric: the diurnal motion
  Mat3 equator_of_date_from_icrs{1.0};  ///< bias, precession and nutation, IAU 2006/2000A
  double local_sidereal_time_rad = 0.0; ///< apparent, 0 to 2 pi
};

/// Sun, Earth and Moon by sun_earth_moon, precession and nutation by IAU 2006/2000A (nutation from the embedded table
/// where it reaches, within 0.00002" of ERFA; else by series, within 0.0001"), sidereal time after that; before 1600
/// and after 2400 the long-term precession of precession.hpp. The observer stands on WGS84; polar motion (0.6" at most)
/// is left out. Throws Error(argument) outside the supported span of time (time.hpp).
[[nodiscard]] EarthState earth_state(const Instant& instant, const Observer& observer, Tier tier = Tier::standard);

/// Apparent sidereal time at Greenwich (IAU 2006/2000A), radians, 0 to 2 pi. As in earth_state.
[[nodiscard]] double greenwich_apparent_sidereal_time_rad(const Instant& instant);

} // namespace vesper
