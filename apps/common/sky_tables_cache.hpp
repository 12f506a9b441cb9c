// The sky's tables of a scene.
#pragma once

#include "common/scene_options.hpp"

#include "vesper/atmosphere/sky_tables.hpp"

#include <memory>

namespace vesper {

/// Tables for the scene's medium. Throws as make_sky_tables().
[[nodiscard]] std::shared_ptr<const SkyTables> scene_sky_tables(const SceneOptions& scene);

} // namespace vesper
