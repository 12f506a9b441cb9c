#pragma once

#include "report/scene_columns.hpp"

namespace vesper {

/// What the air does to light and how bright it is, from the scene's medium and model of the sky:
///
/// - zenith_extinction_v_mag: magnitudes in V that sunlight loses from the zenith down to the observer.
/// - horizontal_illuminance_lux: of Sun and Moon, their own light through the air (a disc that the horizon cuts counts
///   in part) and that of the sky and the ground; and of the dark sky's own light. Stars and planets that are points
///   add nothing.
/// - zenith_luminance_cd_m2: of the sky there, without the discs of Sun and Moon.
/// - limiting_magnitude: V above the air of the faintest star seen in the zenith (star_visibility.hpp), by the tables
/// in
///   any model.
/// - sun_direct_illuminance_lux, sun_diffuse_illuminance_lux, sun_zenith_luminance_cd_m2, and the same of the
///   Moon: what the two before are sums of.
/// - airglow_illuminance_lux, airglow_zenith_luminance_cd_m2, and the same of zodiacal, starlight (of stars too faint
/// for
///   the catalogue) and sky_glow: the rest of them, with what the air scatters of each. Always by the tables.
///
/// By the tables what is left out of them (docs/ACCURACY.md). By the reference, in seconds a column and row, each
/// within the budget's relative error of itself, or of a hundredth of the darkest night where less light is; random
/// numbers are drawn after seed, instant and place: a scene has the same values alone and in any table.
[[nodiscard]] std::span<const SceneColumn> light_columns();

/// The light of a scene by its sources, found once.
[[nodiscard]] const SceneLight& light_of(const ReportedScene& scene);
[[nodiscard]] const DarkLight& dark_light_of(const ReportedScene& scene);

} // namespace vesper
