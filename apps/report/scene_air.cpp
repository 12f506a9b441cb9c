#include "report/scene_air.hpp"

#include <mutex>
#include <optional>

namespace vesper {

struct SceneAir::Parts {
  std::shared_ptr<const Medium> medium;
  PathBudget budget;
  std::once_flag transport_made;
  std::optional<ReferenceTransport> transport;
};

SceneAir::SceneAir(const SceneOptions& scene, const PathBudget& budget) : parts_(std::make_unique<Parts>()) {
  parts_->medium = scene.medium;
  parts_->budget = budget;
}
SceneAir::~SceneAir() = default;
SceneAir::SceneAir(SceneAir&&) noexcept = default;
SceneAir& SceneAir::operator=(SceneAir&&) noexcept = default;

const Medium& SceneAir::medium() const { return *parts_->medium; }

const ReferenceTransport& SceneAir::transport() const {
  std::call_once(parts_->transport_made, [this] { parts_->transport.emplace(medium(), medium().wavelengths_nm); });
  return *parts_->transport;
}

const PathBudget& SceneAir::budget() const { return parts_->budget; }

} // namespace vesper
