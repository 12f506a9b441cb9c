// The light of the planets in the frame's four responses.
#pragma once

#include "vesper/astro/ephemeris.hpp"
#include "vesper/base/units.hpp"
#include "vesper/light/reflected_light.hpp"

namespace vesper {

/// Sunlight reflected with the planet's geometric albedo in the bands of Johnson and Cousins (Mallama, Krobusek
/// and Pavlov 2017, Icarus 282, 19), linear between the bands' wavelengths. Methane bands of the outer planets are in
/// it only as far as broad bands see them. From a table made at the first call.
[[nodiscard]] const ReflectedLight& planet_light(Planet planet);

/// Above the atmosphere, from a V magnitude.
[[nodiscard]] Illuminance planet_illuminance(Planet planet, double magnitude);

} // namespace vesper
