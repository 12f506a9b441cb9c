#pragma once

#include "report/scene_columns.hpp"

namespace vesper {

/// What the air does to light and how bright it is, from the scene's medium and model of the sky; to be asked for by
/// name, since all but the first take seconds a row.
///
/// - zenith_extinction_v_mag: magnitudes in V that sunlight loses from the zenith down to the observer.
/// - horizontal_illuminance_lux: of Sun and Moon, their own light through the air (a disc that the horizon cuts counts
///   in part) and that of the sky and the ground.
/// - zenith_luminance_cd_m2: of the sky there, without the discs of Sun and Moon.
///
/// Both within the budget's relative error of themselves, or of a hundredth of the darkest night where less light is.
/// Random numbers are drawn after seed, instant and place: a scene has the same values alone and in any table.
[[nodiscard]] std::span<const SceneColumn> light_columns();

} // namespace vesper
