// Everything true about the sky at one instant for one observer.
#pragma once

#include "vesper/astro/lunar_eclipse.hpp"
#include "vesper/astro/observer.hpp"
#include "vesper/astro/solar_eclipse.hpp"
#include "vesper/astro/refraction.hpp"
#include "vesper/astro/star_frame.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// Apparent topocentric place of a body: true equator and equinox of date, airless.
struct BodyPlace {
  Angle right_ascension;
  Angle declination;
  Angle azimuth;            ///< north through east
  Angle altitude;           ///< airless
  Length distance;          ///< from the observer now to the body when the light left it
  Vec3 direction_horizon{}; ///< unit vector, x = East, y = North, z = zenith
};

struct MoonState {
  BodyPlace place;
  double illuminated_fraction = 0.0; ///< 0 to 1, topocentric
  Angle phase_angle;                 ///< Sun-Moon-observer, 0 (full) to 180 degrees (new)
  Angle bright_limb;                 ///< position angle of the bright limb's midpoint, north through east, 0 to 360
};

struct SkyState {
  Instant instant;
  Observer observer;
  Tier tier = Tier::standard;
  StarFrame stars;
  Refraction refraction; ///< of the standard atmosphere, without a table, as sky_state() leaves it
  BodyPlace sun;
  MoonState moon;
  LunarEclipseState lunar_eclipse; ///< Danjon's shadow, whether the Moon is near it or not
  SolarEclipseState solar_eclipse; ///< for the observer, whether Sun and Moon are up or not
  double seconds = 0.0; ///< TT seconds since J2000.0, the clock of scintillation
};

[[nodiscard]] SkyState sky_state(const Instant& instant, const Observer& observer, Tier tier = Tier::standard);

} // namespace vesper
