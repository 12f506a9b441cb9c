// The Sun and the Moon as seen from a place on the Earth.
#pragma once

#include "vesper/astro/earth_state.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// From the observer now to the Sun when the light left it, au along ICRS axes, before aberration. By eraEpv00:
/// within 0.02 arcsec and 6 km of JPL DE431 from 1900 to 2100.
[[nodiscard]] Vec3 sun_from_observer_au(const EarthState& earth);

/// From the observer now to the Moon when the light left it, au along ICRS axes, before aberration. By eraMoon98 (Meeus
/// 1998 after ELP 2000-82): against JPL DE431 3 arcsec and 3 km RMS, 12 arcsec and 10 km at worst of 200 places.
[[nodiscard]] Vec3 moon_from_observer_au(const EarthState& earth);

} // namespace vesper
