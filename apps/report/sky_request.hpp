// `vesper-report sky`: its options, and what they ask for.
#pragma once

#include "report/sky_light.hpp"
#include "report/sky_points.hpp"

#include "common/scene_options.hpp"

#include "vesper/atmosphere/medium.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vesper {

/// How well the reference transport is to know its answers: options that `sky` shares with columns of light.
struct BudgetOptions {
  std::string relative_error = "0.01";
  std::string most_paths;
  std::string orders;
  std::string threads = "0";
};
void add_budget_options(CLI::App& app, BudgetOptions& options);
/// Throws Error(argument) naming the option, its value and what is allowed.
[[nodiscard]] PathBudget path_budget(const BudgetOptions& options, const SceneOptions& scene);

/// The options of `sky` as they were given.
struct SkyOptions {
  bool reference = false; ///< as --sky reference
  bool zenith = false;
  bool picture = false;
  std::string directions;
  std::string light;
  std::string sun_altitude, sun_azimuth = "180", sun_radius;
  std::string moon_altitude, moon_azimuth = "180", moon_phase_angle = "0";
  std::string wavelengths;
  bool unit_irradiance = false;
  bool illuminance = false;
  bool timings = false;
};

/// Adds the subcommand `sky` with its options to `app`.
[[nodiscard]] CLI::App* add_sky_command(CLI::App& app, SkyOptions& options);

/// The table of --directions, if there is one. Throws Error(file) and Error(input).
[[nodiscard]] std::optional<CsvTable> directions_table(const SkyOptions& options);

/// Whether the lights are set by hand: time and place then do not matter, the height is 0 unless given.
[[nodiscard]] bool lights_by_hand(const SkyOptions& options, const std::optional<CsvTable>& directions);

/// What is reported of each direction; its column is "name_unit", that of its error "name_error_unit".
struct SkyQuantity {
  std::string name, unit;
};

struct SkyRequest {
  SkyModel model = SkyModel::tables;
  std::string medium_name;
  std::shared_ptr<const Medium> medium;
  std::vector<double> wavelengths_nm; ///< of the reference's transport
  Length height;                      ///< above the medium's ground
  std::vector<WeightedLight> lights;  ///< the Sun first, if it is one of them
  std::vector<SkyQuantity> quantities;
  std::vector<SkyPoint> points;
  std::optional<View> picture; ///< whose pixels the points are
  PathBudget budget;           ///< of the reference, without a stream
  bool illuminance = false;    ///< of a level surface too
  bool timings = false;
};

/// Throws Error(argument) naming the option, its value and what is allowed; Error(input) for the directions.
/// \param picture_by_output whether the output is a picture
[[nodiscard]] SkyRequest sky_request(const SkyOptions& options, const BudgetOptions& budget, const SceneOptions& scene,
                                     const std::optional<CsvTable>& directions, bool picture_by_output);

/// A digest of all that the request's answer depends on.
[[nodiscard]] std::string fingerprint(const SkyRequest& request);

} // namespace vesper
