#include "report/scene_air.hpp"

#include "common/sky_tables_cache.hpp"

#include <mutex>
#include <optional>

namespace vesper {

struct SceneAir::Parts {
  SceneOptions scene;
  PathBudget budget;
  std::once_flag tables_made;
  std::shared_ptr<const SkyTables> tables;
  std::once_flag eclipsed_made;
  std::shared_ptr<const EclipsedAir> eclipsed;
  std::once_flag transport_made;
  std::optional<ReferenceTransport> transport;
};

SceneAir::SceneAir(const SceneOptions& scene, const PathBudget& budget) : parts_(std::make_unique<Parts>()) {
  parts_->scene = scene;
  parts_->budget = budget;
}
SceneAir::~SceneAir() = default;
SceneAir::SceneAir(SceneAir&&) noexcept = default;
SceneAir& SceneAir::operator=(SceneAir&&) noexcept = default;

const Medium& SceneAir::medium() const { return *parts_->scene.medium; }

SkyModel SceneAir::model() const { return parts_->scene.sky; }

const SkyTables& SceneAir::tables() const {
  std::call_once(parts_->tables_made, [this] { parts_->tables = scene_sky_tables(parts_->scene); });
  return *parts_->tables;
}

const std::shared_ptr<const EclipsedAir>& SceneAir::eclipsed() const {
  std::call_once(parts_->eclipsed_made, [this] { parts_->eclipsed = std::make_shared<const EclipsedAir>(medium()); });
  return parts_->eclipsed;
}

const ReferenceTransport& SceneAir::transport() const {
  std::call_once(parts_->transport_made, [this] { parts_->transport.emplace(medium(), medium().wavelengths_nm); });
  return *parts_->transport;
}

const PathBudget& SceneAir::budget() const { return parts_->budget; }

} // namespace vesper
