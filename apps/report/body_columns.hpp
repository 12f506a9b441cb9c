#pragma once

#include "report/scene_columns.hpp"

namespace vesper {

/// How bright Sun and Moon are above the air, eclipses included:
///
/// - sun_magnitude, moon_magnitude: of the whole disc, in V; infinite without light.
/// - sun_illuminance_lux, moon_illuminance_lux: on a plane that faces it.
/// - sun_disc_luminance_cd_m2, moon_disc_luminance_cd_m2: mean over the whole disc, lit or not.
/// - moon_danjon: Danjon's L that observers give the Moon as dim as it is now, 0 to 4; not a number unless all of it
///   stands in the umbra.
[[nodiscard]] std::span<const SceneColumn> body_columns();

/// As the column moon_danjon.
/// \param moon moon_illumination() of the sky
[[nodiscard]] double seen_danjon_of(const SkyState& sky, const MoonIllumination& moon);

} // namespace vesper
