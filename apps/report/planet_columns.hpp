#pragma once

#include "report/scene_columns.hpp"

namespace vesper {

/// What can be reported of each planet: mercury_right_ascension_deg to neptune_equatorial_diameter_arcsec. Conventions
/// are those of the Moon's columns; distances from the observer, magnitudes V above the atmosphere.
[[nodiscard]] std::span<const SceneColumn> planet_columns();

} // namespace vesper
