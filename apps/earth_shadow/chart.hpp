// A picture of the light in the Earth's shadow.
#pragma once

#include "vesper/atmosphere/earth_shadow_light.hpp"

#include <string>

namespace vesper {

/// An SVG: share of full light against distance from the shadow's axis at the Moon's mean distance, for L = 0 to 4, and
/// under it the colours.
[[nodiscard]] std::string shadow_chart(const EarthShadowLight& light);

} // namespace vesper
