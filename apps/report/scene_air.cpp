#include "report/scene_air.hpp"

#include "common/sky_tables_cache.hpp"

#include <map>
#include <mutex>
#include <optional>

namespace vesper {

struct SceneAir::Parts {
  SceneOptions scene;
  PathBudget budget;
  std::once_flag tables_made;
  std::shared_ptr<const SkyTables> tables;
  std::mutex dark_air_made;
  std::map<Length, std::shared_ptr<const DarkAir>> dark_airs;
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

const std::shared_ptr<const SkyTables>& SceneAir::shared_tables() const {
  std::call_once(parts_->tables_made, [this] { parts_->tables = scene_sky_tables(parts_->scene); });
  return parts_->tables;
}

std::shared_ptr<const DarkAir> SceneAir::dark_air(Length height) const {
  constexpr std::size_t most_heights = 64; // of a table with places all over
  const std::shared_ptr<const SkyTables>& tables = shared_tables();
  const std::lock_guard lock(parts_->dark_air_made);
  const auto known = parts_->dark_airs.find(height);
  if (known != parts_->dark_airs.end()) {
    return known->second;
  }
  if (parts_->dark_airs.size() >= most_heights) {
    parts_->dark_airs.clear();
  }
  return parts_->dark_airs.emplace(height, std::make_shared<const DarkAir>(medium(), tables, height, dark_sky().glow))
      .first->second;
}

const DarkSkyOptions& SceneAir::dark_sky() const { return parts_->scene.dark_sky; }

const std::shared_ptr<const EclipsedAir>& SceneAir::eclipsed() const {
  std::call_once(parts_->eclipsed_made, [this] { parts_->eclipsed = std::make_shared<const EclipsedAir>(medium()); });
  return parts_->eclipsed;
}

const ReferenceTransport& SceneAir::transport() const {
  std::call_once(parts_->transport_made, [this] { parts_->transport.emplace(medium(), medium().wavelengths_nm); });
  return *parts_->transport;
}

const PathBudget& SceneAir::budget() const { return parts_->budget; }

double SceneAir::field_factor() const { return parts_->scene.field_factor; }

} // namespace vesper
