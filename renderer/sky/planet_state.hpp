// The planets as one observer sees them.
#pragma once

#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/planet_appearance.hpp"
#include "vesper/sky/apparent_place.hpp"

#include <array>

namespace vesper {

struct PlanetState {
  BodyPlace place;
  PlanetAppearance appearance; ///< topocentric
  Angle bright_limb;           ///< position angle of the bright limb's midpoint, north through east, 0 to 360
};

/// In the order of Planet.
using PlanetStates = std::array<PlanetState, planet_count>;

/// \param sun_au from the observer to the Sun when its light left it, along ICRS axes
[[nodiscard]] PlanetStates planet_states(const EarthState& earth, const StarFrame& frame, const Vec3& sun_au);

} // namespace vesper
