// The quantities of a scene that can be reported, each a column.
#pragma once

#include "vesper/sky/sky_state.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace vesper {

/// A quantity whose name carries its unit.
struct SceneColumn {
  std::string_view name;
  double (*value)(const SkyState& sky);
};

/// All columns, in the order in which they are written.
[[nodiscard]] std::span<const SceneColumn> scene_columns();

/// The columns of a comma-separated list, in its order; all for an empty list. Throws Error(argument) naming an unknown
/// or repeated one.
[[nodiscard]] std::vector<SceneColumn> select_columns(std::string_view list);

} // namespace vesper
