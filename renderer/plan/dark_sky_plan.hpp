// The dark sky's own light in one frame.
#pragma once

#include "vesper/astro/refraction.hpp"
#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/atmosphere/star_extinction_table.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/plan/layers.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/sky_state.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace vesper {

/// What the dark sky's light depends on besides the instant.
struct DarkSkySetting {
  std::shared_ptr<const Medium> medium;             ///< none: no air
  std::shared_ptr<const SkyTables> sky_tables;      ///< none: nothing is scattered
  std::shared_ptr<const StarExtinction> extinction; ///< none: nothing is taken of what shines from beyond
  Refraction refraction;                            ///< with its table
  Length height;
  double horizon_sin_altitude = 0.0;
  CityGlow glow;

  /// A refraction's model and conditions tell its table.
  friend bool operator==(const DarkSkySetting& a, const DarkSkySetting& b);
};

/// What the air does to what shines from beyond it, over rows as those of the sky's map (sky_map_row_texel).
struct AirBeforeStars {
  static constexpr int rows_below = 64;
  static constexpr int rows_above = 384;
  static constexpr int hues = 32; ///< of Z over Y + Z, 0 to 1
  std::vector<f32::vec4> shares;  ///< logarithms to base 2 of what is left of X, Y, Z and S, row by row
  std::vector<f32::vec4> bends;   ///< x: refraction of what is seen there, rad over the cosine of its altitude
};

/// What follows from it; plans share it.
struct DarkSkyPlace {
  DarkSkySetting setting;
  f64::SkyMapFrame frame{}; ///< of the map's rows
  AirBeforeStars air;
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
  bool air_with_sky = false; ///< what is in the air is drawn with a sky, whose map ends where this one does
  /// What is added before everything but the ground and what is nearer: airglow, sky glow and the light that the air
  /// scatters of all layers: X, Y, Z and S in cd/m2, in the order of the sky's map (shaders/lib/sky_map.glsl).
  std::vector<f32::vec4> air;
};

/// Whether any of the layers milky_way, airglow, zodiacal and sky_glow is drawn.
[[nodiscard]] bool draws_dark_sky(const LayerSet& layers);

/// None where none of these layers is drawn.
/// \param sky_is_drawn whether the plan has lights of the sky
/// \param before an earlier one, whose place serves again (and need not be made, in 35 ms) where its setting is the
/// same
[[nodiscard]] std::shared_ptr<const PlannedDarkSky> plan_dark_sky(const SkyState& sky, const LayerSet& layers,
                                                                  const DarkSkyOptions& options, DarkSkySetting setting,
                                                                  bool sky_is_drawn, const PlannedDarkSky* before);

} // namespace vesper
