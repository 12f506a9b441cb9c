// The Earth and the observer on it at one instant: what every place in the sky is reduced with.
#pragma once

#include "vesper/astro/observer.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// Vectors in au and au/day along ICRS axes.
struct EarthState {
  Instant instant;
  Observer observer;
  Vec3 sun_to_earth_au{};
  Vec3 earth_barycentric_au{};
  Vec3 earth_velocity_au_d{}; ///< barycentric
  Vec3 sun_velocity_au_d{};   ///< barycentric
  Vec3 earth_to_observer_au{};
  Vec3 observer_velocity_au_d{};        ///< geocentric: the diurnal motion
  Mat3 equator_of_date_from_icrs{1.0};  ///< bias, precession and nutation, IAU 2006/2000A
  double local_sidereal_time_rad = 0.0; ///< apparent, 0 to 2 pi
};

/// Earth and Sun by the series of ERFA's eraEpv00 (after VSOP2000; 11 km at worst from 1900 to 2100, less outside),
/// precession and nutation by eraPnm06a, sidereal time by eraGst06, the observer on WGS84 without polar motion.
[[nodiscard]] EarthState earth_state(const Instant& instant, const Observer& observer);

/// Apparent sidereal time at Greenwich (IAU 2006/2000A), radians, 0 to 2 pi.
[[nodiscard]] double greenwich_apparent_sidereal_time_rad(const Instant& instant);

} // namespace vesper
