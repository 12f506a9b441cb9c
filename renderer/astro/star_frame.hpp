// What every star of a frame shares when its place is computed: the state of the Earth, as the GPU gets it.
#pragma once

#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/observer.hpp"
#include "vesper/astro/tier.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// The Earth's part in a star's topocentric apparent place, all in ICRS axes unless named otherwise.
struct StarFrame {
  double years_since_j2000 = 0.0;      ///< Julian years of TDB since J2000.0, for proper motion
  Vec3 observer_barycentric_au{};      ///< observer's barycentric position, for parallax
  Vec3 observer_velocity_c{};          ///< observer's barycentric velocity in units of c (diurnal part included)
  double lorentz_inverse = 1.0;        ///< sqrt(1 - v^2) of that velocity
  Vec3 sun_to_observer{};              ///< unit vector from the Sun to the observer, for light deflection
  double sun_distance_au = 1.0;        ///< Sun to observer
  bool solar_deflection = false;       ///< whether the Sun bends starlight (not in the cheap tier)
  Mat3 equator_of_date_from_icrs{1.0}; ///< bias, precession and nutation: true equator and equinox of date
  Mat3 horizon_from_icrs{1.0};         ///< x = East, y = North, z = geodetic zenith
  double sidereal_time_rad = 0.0;      ///< local apparent sidereal time, 0 to 2 pi
};

/// \param tier `cheap` gives Mueller et al. 2012 eq. 7 and 8: precession only, mean sidereal time, no proper motion,
///        parallax, aberration, nutation or deflection. Others give the complete chain from earth_state(), whose errors
///        they throw.
[[nodiscard]] StarFrame star_frame(const Instant& instant, const Observer& observer, Tier tier = Tier::standard);

/// The complete chain from a state at hand.
[[nodiscard]] StarFrame star_frame(const EarthState& earth);

/// Horizon frame (x = East, y = North, z = geodetic zenith) from the equator and equinox of a date.
/// \param sidereal_time_rad local sidereal time that belongs to that equinox
[[nodiscard]] Mat3 horizon_from_equator(Angle latitude, double sidereal_time_rad);

/// Precession only, Mueller et al. 2012 eq. 8: within 2 arcsec of ERFA's mean precession from 1900 to 2100.
/// \param centuries Julian centuries since J2000.0
[[nodiscard]] Mat3 cheap_equator_of_date_from_icrs(double centuries);

} // namespace vesper
