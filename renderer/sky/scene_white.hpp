// The light that a scene is seen by, to whose colour the eye adapts.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/sky/sky_state.hpp"

namespace vesper {

/// Share of a light's illuminance above the air that reaches level ground, directly or from the sky, in clear air:
/// within a factor of 1.8 of Janiczek and DeYoung's fits for the Sun (1987, USNO Circular 171) from -12 to 90 degrees.
/// \param altitude of the light, without refraction; never falls with it
[[nodiscard]] double share_on_level_ground(Angle altitude);

/// X, Y, Z in lux on level ground. Sun and Moon give as much as they light the ground by, from below the horizon too,
/// but in their colours above the air: a low Sun is red to an eye that takes its light of noon for white, and so is an
/// eclipsed Moon to one that takes the full Moon's. The night sky gives 1e-3 lux of the displays' white D65, so that
/// without Sun and Moon colours are shown as they measure. All changes steadily with time.
[[nodiscard]] Vec3 adapting_light(const SkyState& sky);

} // namespace vesper
