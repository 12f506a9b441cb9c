#include "report/scene_air.hpp"

#include "vesper/atmosphere/medium_presets.hpp"

#include <mutex>
#include <optional>

namespace vesper {

Medium medium_of(const SceneOptions& scene) { return scene.medium ? *scene.medium : clear_medium(); }

struct SceneAir::Parts {
  SceneOptions scene;
  PathBudget budget;
  std::once_flag medium_made, transport_made;
  std::optional<Medium> medium;
  std::optional<ReferenceTransport> transport;
};

SceneAir::SceneAir(const SceneOptions& scene, const PathBudget& budget) : parts_(std::make_unique<Parts>()) {
  parts_->scene = scene;
  parts_->budget = budget;
}
SceneAir::~SceneAir() = default;
SceneAir::SceneAir(SceneAir&&) noexcept = default;
SceneAir& SceneAir::operator=(SceneAir&&) noexcept = default;

const Medium& SceneAir::medium() const {
  std::call_once(parts_->medium_made, [this] { parts_->medium = medium_of(parts_->scene); });
  return *parts_->medium;
}

const ReferenceTransport& SceneAir::transport() const {
  std::call_once(parts_->transport_made, [this] { parts_->transport.emplace(medium(), medium().wavelengths_nm); });
  return *parts_->transport;
}

const PathBudget& SceneAir::budget() const { return parts_->budget; }

} // namespace vesper
