// The dark sky's own light in one frame.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/plan/layers.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/sky_state.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace vesper {

/// What the dark sky's light does not depend on the instant for; plans share it.
struct DarkSkyPlace {
  std::shared_ptr<const Medium> medium;        ///< none: no air
  std::shared_ptr<const SkyTables> sky_tables; ///< none: nothing is scattered
  Length height;
  std::optional<RefractionConditions> bending;
  double horizon_sin_altitude = 0.0;
  CityGlow glow;

  f64::SkyMapFrame frame{};         ///< of the map's rows
  std::vector<Vec2> airglow_paths;  ///< by row: f64::airglow_paths
  std::vector<Vec4> airglow_shares; ///< by row: what air leaves of the second
  std::vector<double> glow_pattern; ///< by row and column, over the zenith; empty without sky glow
  std::optional<SpreadLightViews> views;
};

/// Ready for the GPU.
struct PlannedDarkSky {
  /// Steps over azimuth, and rows that meet the ground and that do not: one less is a multiple of row_step.
  static constexpr int columns = 64;
  static constexpr int rows_below = 13;
  static constexpr int rows_above = 97;
  static constexpr int row_step = 4; ///< rows of scattered light and of sky glow, which are smooth

  std::shared_ptr<const DarkSkyPlace> place;
  DarkSky sources;
  bool zodiacal = false; ///< what is drawn behind the air, through it
  bool starlight = false;
  /// What is added before everything but the ground and what is nearer: airglow, sky glow and the light that the air
  /// scatters of all layers: X, Y, Z and S in cd/m2, in the order of the sky's map (shaders/lib/sky_map.glsl).
  std::vector<f32::vec4> air;
};

/// Whether any of the layers milky_way, airglow, zodiacal and sky_glow is drawn.
[[nodiscard]] bool draws_dark_sky(const LayerSet& layers);

/// None where none of these layers is drawn.
/// \param bending none for rays that are straight
/// \param before an earlier one, whose place serves again (and need not be made, in 30 ms) where it is the same
[[nodiscard]] std::shared_ptr<const PlannedDarkSky>
plan_dark_sky(const SkyState& sky, const LayerSet& layers, const DarkSkyOptions& options,
              const std::shared_ptr<const Medium>& medium, const std::shared_ptr<const SkyTables>& sky_tables,
              const std::optional<RefractionConditions>& bending, double horizon_sin_altitude,
              const PlannedDarkSky* before);

} // namespace vesper
