// The scene options that all programs share, from the command line, a scene file and the user's settings.
#pragma once

#include "vesper/astro/observer.hpp"
#include "vesper/astro/refraction.hpp"
#include "vesper/astro/star_frame.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/atmosphere/medium.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/plan/layers.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/sky_state.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace vesper {

/// Where the light of the air comes from.
enum class SkyModel {
  tables,       ///< solved once for the medium: atmosphere/sky_tables.hpp
  small_tables, ///< Hillaire's tier: atmosphere/small_sky_tables.hpp
  reference,    ///< the Monte Carlo of atmosphere/reference_transport.hpp
};

/// Heights above the ellipsoid that a scene may have, in metres.
inline constexpr double lowest_height_m = -500.0;
inline constexpr double highest_height_m = 1.0e8;

/// What a scene is: when, where, looking at what, modelled how.
struct SceneOptions {
  Instant instant;
  TimeScale time_scale = TimeScale::utc;   ///< of stamps without a scale of their own
  Calendar calendar = Calendar::gregorian; ///< of stamps
  Observer observer;
  bool latitude_given = false;
  bool longitude_given = false;
  bool height_given = false;
  std::optional<double> pressure_hpa;  ///< at the observer; the standard atmosphere's if not given
  std::optional<double> temperature_c; ///< likewise
  View view;
  Tier tier = Tier::standard;
  std::string medium_name = "clear";    ///< of a preset, or the path of the file
  std::shared_ptr<const Medium> medium; ///< the air; scene_from always gives one
  LayerSet layers = all_layers();
  SkyModel sky = SkyModel::tables;
  DarkSkyOptions dark_sky;                         ///< the Sun's activity and artificial light
  double danjon = EclipseAir().danjon;             ///< L of the Earth's air in eclipses of the Moon
  double field_factor = f64::default_field_factor; ///< how much light the observer needs: star_visibility.hpp
  std::uint64_t seed = 0;                          ///< of everything random
};

/// Option values as text with where they were given, by option name without dashes. Later sources overwrite earlier.
struct GivenOption {
  std::string text;
  std::string label; ///< "--fov" or "key 'fov'"
  std::string file;  ///< of a key
  std::string place; ///< "line 3" of a key
};
using GivenOptions = std::map<std::string, GivenOption, std::less<>>;

/// How the scene bends light: the model of its tier, under the air that was given or else the standard atmosphere's at
/// the height. Without a table.
[[nodiscard]] Refraction refraction_of(const SceneOptions& scene, Length height);

/// The sky of the scene, with its air.
[[nodiscard]] SkyState sky_state_of(const SceneOptions& scene);
/// The same at another time and place.
[[nodiscard]] SkyState sky_state_of(const SceneOptions& scene, const Instant& instant, const Observer& observer);

enum class Assumptions { said, silent };

/// The scene options of one program.
class SceneOptionSet {
public:
  /// Adds the options to `app`, which must outlive this object.
  explicit SceneOptionSet(CLI::App& app);

  /// The scene after parsing: command line, then --scene FILE, then the user's settings, then defaults. Throws
  /// Error(argument) naming the option or key, its value and the allowed range; for files also the path and line. Of
  /// files that options name: as scene_from.
  /// \param assumptions whether to say on standard error that a place or the time scale had to be assumed
  [[nodiscard]] SceneOptions resolve(Assumptions assumptions = Assumptions::said) const;

private:
  struct Bound {
    std::string_view name;
    const CLI::Option* option;
  };
  std::deque<std::string> values_; ///< what CLI11 writes to: must not move
  std::deque<Bound> bound_;
  std::string scene_file_;
  const CLI::Option* scene_option_ = nullptr;
};

/// Turns merged values into a scene: each option's own range and the ranges that depend on the projection.
/// Throws Error(argument); Error(file) and Error(input) for what is wrong with a file that an option names.
[[nodiscard]] SceneOptions scene_from(const GivenOptions& given);

/// Reads a flat TOML file whose keys are option names without dashes. Throws Error(argument) with the file and line for
/// malformed TOML, an unknown key or a value of the wrong type, and when the file cannot be read.
[[nodiscard]] GivenOptions read_scene_file(const std::filesystem::path& path);

/// $XDG_CONFIG_HOME/vesper/settings.toml, or the same under ~/.config; empty when neither variable is set.
[[nodiscard]] std::filesystem::path user_settings_path();

} // namespace vesper
