// Sun, Moon and planets as seen from a place on the Earth.
#pragma once

#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/star_frame.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// From the observer now to where the body was when the light that arrives left it: au along ICRS axes, before
/// aberration.
[[nodiscard]] Vec3 sun_from_observer_au(const EarthState& earth);
[[nodiscard]] Vec3 moon_from_observer_au(const EarthState& earth);
[[nodiscard]] Vec3 planet_from_observer_au(Planet planet, const EarthState& earth);
/// The same from bodies at hand and a place given from the Earth's centre (au, ICRS axes).
[[nodiscard]] Vec3 sun_from_observer_au(const SunEarthMoon& bodies, const Vec3& earth_to_observer_au);
[[nodiscard]] Vec3 moon_from_observer_au(const SunEarthMoon& bodies, const Vec3& earth_to_observer_au);

/// Where an observer who moves as `frame` has it sees a body of the solar system: such a vector with aberration, a unit
/// vector along ICRS axes.
[[nodiscard]] Vec3 apparent_direction_icrs(const Vec3& from_observer_au, const StarFrame& frame);

} // namespace vesper
