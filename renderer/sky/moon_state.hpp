// The Moon as one observer sees it: place, phase, and how its globe is turned.
#pragma once

#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/lunar_orientation.hpp"
#include "vesper/sky/apparent_place.hpp"

namespace vesper {

struct MoonState {
  BodyPlace place;
  double illuminated_fraction = 0.0; ///< 0 to 1, topocentric
  Angle phase_angle;                 ///< Sun-Moon-observer, 0 (full) to 180 degrees (new)
  Angle bright_limb;                 ///< position angle of the bright limb's midpoint, north through east, 0 to 360

  // The globe when the light left it, in mean-Earth axes. Librations are optical and physical together: they are the
  // selenographic longitude and latitude of the point whose zenith the observer stands in.
  Mat3 moon_fixed_from_icrs{1.0};     ///< mean-Earth axes
  Selenographic libration;            ///< topocentric
  Selenographic geocentric_libration; ///< the same for the centre of the Earth
  Selenographic subsolar;             ///< where the Sun stands in the zenith
  Angle colongitude;                  ///< selenographic longitude of the morning terminator, west positive, 0 to 360
  Angle axis;                         ///< position angle of the north pole, north through east, 0 to 360
  Angle parallactic;                  ///< position angle of the zenith at the Moon, -180 to 180, positive in the west
};

/// \param moon_au, sun_au from the observer to where the body was when the light left it, along ICRS axes
[[nodiscard]] MoonState moon_state(const EarthState& earth, const StarFrame& frame, const Vec3& moon_au,
                                   const Vec3& sun_au);

} // namespace vesper
