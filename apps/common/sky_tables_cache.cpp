#include "common/sky_tables_cache.hpp"

namespace vesper {

std::shared_ptr<const SkyTables> scene_sky_tables(const SceneOptions& scene) {
  return std::make_shared<const SkyTables>(make_sky_tables(*scene.medium));
}

} // namespace vesper
