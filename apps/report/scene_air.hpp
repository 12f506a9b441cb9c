// The air of a scene and the light in it, made once for all that asks.
#pragma once

#include "common/scene_options.hpp"
#include "report/dark_light.hpp"

#include "vesper/atmosphere/eclipsed_air.hpp"
#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/atmosphere/sky_tables.hpp"

#include <memory>

namespace vesper {

/// Medium, tables and transport of a scene; what takes long is made when it is first asked for. Any thread may ask.
class SceneAir {
public:
  /// \param scene  with a medium, as scene_from gives it
  /// \param budget how well light is to be known; its stream is the asker's
  explicit SceneAir(const SceneOptions& scene, const PathBudget& budget = {});
  ~SceneAir();
  SceneAir(SceneAir&&) noexcept;
  SceneAir& operator=(SceneAir&&) noexcept;

  [[nodiscard]] const Medium& medium() const;
  /// How the light in it is to be found.
  [[nodiscard]] SkyModel model() const;
  /// From a cache, if they are there (sky_tables_cache.hpp); takes seconds otherwise.
  [[nodiscard]] const SkyTables& tables() const { return *shared_tables(); }
  [[nodiscard]] const std::shared_ptr<const SkyTables>& shared_tables() const;
  /// The air before the dark sky at a height, and what is said of that sky. By the tables in any model.
  [[nodiscard]] std::shared_ptr<const DarkAir> dark_air(Length height) const;
  [[nodiscard]] const DarkSkyOptions& dark_sky() const;
  /// What becomes of its light in the Moon's shadow. Takes some tenths of a second at first.
  [[nodiscard]] const std::shared_ptr<const EclipsedAir>& eclipsed() const;
  /// At the medium's wavelengths. Takes seconds at first.
  [[nodiscard]] const ReferenceTransport& transport() const;
  [[nodiscard]] const PathBudget& budget() const;
  /// Of who looks into it: limiting_magnitude in star_visibility.hpp.
  [[nodiscard]] double field_factor() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace vesper
