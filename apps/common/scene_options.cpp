#include "common/scene_options.hpp"

#include "common/scene_option_table.hpp"
#include "common/sky_tables_cache.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/base/error.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <mutex>

namespace vesper {
namespace {

// The Royal Observatory: the place when none is given.
constexpr double greenwich_latitude_deg = 51.4769;
constexpr double greenwich_longitude_deg = 0.0;
constexpr double greenwich_height_m = 47.0;

// Twice the field of a fast lens: wide enough for a constellation with its neighbours. The default of the other
// projections, 180 degrees, is beyond what a perspective can show.
constexpr double perspective_fov_deg = 60.0;

/// Of the scene's medium, found once for it.
std::shared_ptr<const EarthShadowLight> shadow_light_of(const SceneOptions& scene) {
  static std::mutex mutex;
  static std::shared_ptr<const Medium> medium;
  static std::shared_ptr<const EarthShadowLight> light;
  const std::scoped_lock lock(mutex);
  if (medium != scene.medium) {
    light = std::make_shared<const EarthShadowLight>(cached_earth_shadow_light(*scene.medium, user_cache_folder()));
    medium = scene.medium;
  }
  return light;
}

void overwrite(GivenOptions& target, const GivenOptions& source) {
  for (const auto& [name, value] : source) {
    target[name] = value;
  }
}

void assume_missing_place(SceneOptions& scene) {
  const bool any = scene.latitude_given || scene.longitude_given;
  if (!scene.latitude_given) {
    scene.observer.latitude = greenwich_latitude_deg * deg;
  }
  if (!scene.longitude_given) {
    scene.observer.longitude = greenwich_longitude_deg * deg;
  }
  if (!scene.height_given && !any) {
    scene.observer.height = greenwich_height_m * metre;
  }
}

void apply(const SceneOptionDescription& described, const GivenOption& option, SceneOptions& scene) {
  std::string allowed;
  try {
    allowed = described.apply(option.text, scene);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::argument) {
      throw; // of a file that the option names, and which the error names too
    }
    throw Error(ErrorKind::argument, option.label + ": " + e.message(),
                {option.file, option.place, e.context().remedy});
  }
  if (!allowed.empty()) {
    throw Error(ErrorKind::argument,
                fmt::format("{}: '{}' is not allowed; allowed: {}", option.label, option.text, allowed),
                {option.file, option.place, ""});
  }
}

void say_assumptions(const SceneOptions& scene) {
  if (!scene.latitude_given && !scene.longitude_given) {
    spdlog::info("no place given: taking Greenwich (51.4769, 0.0, 47 m)");
  } else if (!scene.latitude_given || !scene.longitude_given) {
    spdlog::info("no {} given: taking that of Greenwich", scene.latitude_given ? "longitude" : "latitude");
  }
  for (const std::string& remark : time_remarks(scene.instant)) {
    spdlog::info("{}", remark);
  }
}

} // namespace

SceneOptionSet::SceneOptionSet(CLI::App& app) {
  scene_option_ = app.add_option("--scene", scene_file_, "TOML file of scene options: keys as here, without dashes")
                      ->type_name("FILE")
                      ->group("Scene");
  for (const SceneOptionDescription& described : scene_option_table()) {
    std::string& value = values_.emplace_back();
    const CLI::Option* option = app.add_option("--" + std::string(described.name), value, std::string(described.help))
                                    ->type_name(std::string(described.value_name))
                                    ->group(std::string(described.group));
    bound_.push_back({described.name, option});
  }
}

SceneOptions SceneOptionSet::resolve(Assumptions assumptions) const {
  GivenOptions given;
  std::error_code ignored;
  if (const auto settings = user_settings_path(); std::filesystem::exists(settings, ignored)) {
    overwrite(given, read_scene_file(settings));
  }
  if (scene_option_->count() > 0) {
    overwrite(given, read_scene_file(scene_file_));
  }
  for (std::size_t i = 0; i < bound_.size(); ++i) {
    if (bound_[i].option->count() > 0) {
      const std::string name(bound_[i].name);
      given[name] = {values_[i], "--" + name, "", ""};
    }
  }
  SceneOptions scene = scene_from(given);
  if (assumptions == Assumptions::said) {
    say_assumptions(scene);
  }
  return scene;
}

Refraction refraction_of(const SceneOptions& scene, Length height) {
  Refraction refraction = standard_refraction(height, scene.tier);
  refraction.conditions.pressure_hpa = scene.pressure_hpa.value_or(refraction.conditions.pressure_hpa);
  refraction.conditions.temperature_c = scene.temperature_c.value_or(refraction.conditions.temperature_c);
  return refraction;
}

SkyState sky_state_of(const SceneOptions& scene) { return sky_state_of(scene, scene.instant, scene.observer); }

SkyState sky_state_of(const SceneOptions& scene, const Instant& instant, const Observer& observer) {
  SkyState sky = sky_state(instant, observer, scene.tier);
  sky.refraction = refraction_of(scene, observer.height);
  sky.eclipse_air.danjon = scene.danjon;
  if (sky.lunar_eclipse.penumbral_magnitude > 0.0 && scene.medium_name != SceneOptions().medium_name) {
    sky.eclipse_air.light = shadow_light_of(scene);
  }
  return sky;
}

SceneOptions scene_from(const GivenOptions& given) {
  SceneOptions scene;
  for (const SceneOptionDescription& described : scene_option_table()) {
    const auto found = given.find(described.name);
    if (found == given.end()) {
      continue;
    }
    apply(described, found->second, scene);
  }
  if (!given.contains("time")) {
    scene.instant = parse_instant("now", scene.time_scale);
  }
  if (!given.contains("fov") && scene.view.projection == Projection::perspective) {
    scene.view.fov = perspective_fov_deg * deg;
  }
  if (!given.contains("size") && scene.view.projection == Projection::cubemap) {
    scene.view.height = 6 * scene.view.width;
  }
  if (!scene.medium) {
    scene.medium = std::make_shared<const Medium>(clear_medium());
  }
  assume_missing_place(scene);
  return scene;
}

} // namespace vesper
