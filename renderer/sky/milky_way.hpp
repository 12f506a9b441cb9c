// The light of all stars too faint to be drawn, with what dust and other galaxies add to it.
#pragma once

#include "vesper/assets/cube_pyramid.hpp"
#include "vesper/assets/sky_map.hpp"

#include <memory>

namespace vesper {

/// X, Y, Z and S in cd/m2 in ICRS axes. Frames share it: it is copied to the GPU once. For a map of one's own whose
/// drawn stars were removed.
[[nodiscard]] std::shared_ptr<const CubePyramid> make_milky_way(SkyMap map);

/// Of the embedded map, made at the first call.
[[nodiscard]] const std::shared_ptr<const CubePyramid>& default_milky_way();

} // namespace vesper
