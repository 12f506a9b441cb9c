// The quantities of a scene that can be reported, each a column.
#pragma once

#include "report/scene_air.hpp"
#include "report/table_light.hpp"

#include "vesper/sky/moon_illumination.hpp"
#include "vesper/sky/sky_state.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vesper {

/// Sun and Moon above the air, as body_columns.hpp reports them.
struct DiscBrightness {
  double sun_magnitude = 0.0;
  double sun_illuminance_lux = 0.0;
  MoonBrightness moon;
  double moon_danjon = 0.0;
};

/// What columns are made from, and what several of them share. For one thread.
struct ReportedScene {
  const SkyState& sky;
  const SceneAir& air;
  mutable std::optional<SceneLight> light;       ///< by source: see light_of in light_columns.hpp
  mutable std::optional<DarkLight> dark;         ///< likewise
  mutable std::optional<DiscBrightness> discs{}; ///< see body_columns.hpp
};

/// A quantity whose name carries its unit.
struct SceneColumn {
  std::string_view name;
  double (*value)(const ReportedScene& scene);
  bool of_light = false; ///< needs the light of the air: seconds by the reference
};

/// The columns that are written unless others are asked for, in their order.
[[nodiscard]] std::span<const SceneColumn> scene_columns();

/// The columns of a comma-separated list, in its order: names, those of planets (planet_columns.hpp), of the discs of
/// Sun and Moon (body_columns.hpp) and of light (light_columns.hpp) too, and the groups "default", "planets", "discs"
/// and "light". An empty list is "default". Throws Error(argument) naming an unknown or repeated one.
[[nodiscard]] std::vector<SceneColumn> select_columns(std::string_view list);

} // namespace vesper
