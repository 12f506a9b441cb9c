#include "report/sky_request.hpp"

#include "common/option_text.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/sha256.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/spectral_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesper {
namespace {

/// The number that an option gives. Throws Error(argument).
double number_of(std::string_view option, const std::string& text, double lowest, double highest,
                 std::string_view unit = "") {
  const auto value = number_within(text, lowest, highest);
  if (!value) {
    refuse_option(option, text, fmt::format("{} to {}{}", lowest, highest, unit));
  }
  return *value;
}

std::uint64_t count_of(std::string_view option, const std::string& text, std::uint64_t lowest, std::uint64_t highest) {
  const auto value = number_within(text, lowest, highest);
  if (!value) {
    refuse_option(option, text, fmt::format("an integer from {} to {}", lowest, highest));
  }
  return *value;
}

SeenPlace place_of(const std::string& body, const std::string& altitude, const std::string& azimuth) {
  return {number_of("--" + body + "-altitude", altitude, -90.0, 90.0, " degrees"),
          number_of("--" + body + "-azimuth", azimuth, -360.0, 360.0, " degrees, north through east")};
}

std::vector<SkyLight> lights_set_by_hand(const SkyOptions& options, bool sun_in_table) {
  std::vector<SkyLight> lights;
  if (sun_in_table && !options.sun_altitude.empty()) {
    refuse_option("--sun-altitude", options.sun_altitude, "none, since the table of --directions has sun_altitude_deg");
  }
  if (sun_in_table || !options.sun_altitude.empty()) {
    // In a table every row turns it to its own place.
    const SeenPlace place = place_of("sun", sun_in_table ? "0" : options.sun_altitude, options.sun_azimuth);
    lights.push_back(sun_light(place.direction(), astronomical_unit));
  }
  if (!options.moon_altitude.empty()) {
    const SeenPlace place = place_of("moon", options.moon_altitude, options.moon_azimuth);
    const double phase_angle = number_of("--moon-phase-angle", options.moon_phase_angle, 0.0, 180.0, " degrees");
    lights.push_back(moon_light(place.direction(), moon_mean_distance, astronomical_unit, phase_angle * deg));
  }
  return lights;
}

std::vector<SkyLight> chosen_lights(const SkyOptions& options, const SceneOptions& scene,
                                    const std::optional<CsvTable>& directions) {
  const bool by_hand = lights_by_hand(options, directions);
  std::vector<SkyLight> lights;
  if (by_hand) {
    lights = lights_set_by_hand(options, directions && table_has_sun(*directions));
  } else {
    lights = lights_of(sky_state_of(scene));
  }
  if (!options.sun_radius.empty()) {
    const Angle radius = number_of("--sun-radius", options.sun_radius, 0.0, 1.0, " degrees") * deg;
    for (SkyLight& light : lights) {
      light.angular_radius = light.name == "sun" ? radius : light.angular_radius;
    }
  }
  const std::string& choice = options.light;
  if (!choice.empty() && choice != "sun" && choice != "moon" && choice != "both") {
    refuse_option("--light", choice, "sun, moon, both");
  }
  for (const char* name : {"sun", "moon"}) {
    const bool there =
        std::any_of(lights.begin(), lights.end(), [&](const SkyLight& light) { return light.name == name; });
    if (by_hand && !there && (choice == name || choice == "both")) {
      refuse_option("--light", choice, fmt::format("lights with a place; give --{}-altitude too", name));
    }
  }
  std::erase_if(lights,
                [&](const SkyLight& light) { return !choice.empty() && choice != "both" && choice != light.name; });
  return lights;
}

std::vector<double> requested_wavelengths(const SkyOptions& options, const Medium& medium) {
  std::vector<double> wavelengths;
  if (options.wavelengths.empty()) {
    return options.unit_irradiance ? medium.wavelengths_nm : wavelengths;
  }
  const double lowest = medium.wavelengths_nm.front();
  const double highest = medium.wavelengths_nm.back();
  for (const std::string_view item : list_items(options.wavelengths)) {
    const auto value = number_within(item, lowest, highest);
    if (!value || std::find(wavelengths.begin(), wavelengths.end(), *value) != wavelengths.end()) {
      refuse_option(
          "--wavelengths", options.wavelengths,
          fmt::format("a comma-separated list of {} to {} nm, where the medium is known, each once", lowest, highest));
    }
    wavelengths.push_back(*value);
  }
  return wavelengths;
}

/// What is to be known: X, Y, Z and S unless the light is a bare 1, then the radiances.
void ask_for_quantities(const SkyOptions& options, const std::vector<double>& radiances,
                        const std::vector<SkyLight>& lights, SkyRequest& request) {
  std::vector<double>& wavelengths = request.wavelengths_nm;
  wavelengths = radiances;
  if (!options.unit_irradiance) {
    wavelengths.insert(wavelengths.end(), request.medium->wavelengths_nm.begin(), request.medium->wavelengths_nm.end());
    request.quantities = {{"luminance", "cd_m2"}, {"x", "cd_m2"}, {"z", "cd_m2"}, {"s", "cd_m2"}};
  }
  std::sort(wavelengths.begin(), wavelengths.end());
  wavelengths.erase(std::unique(wavelengths.begin(), wavelengths.end()), wavelengths.end());
  for (const double wavelength : radiances) {
    request.quantities.push_back(
        {fmt::format("radiance_{}nm", wavelength), options.unit_irradiance ? "per_sr" : "w_m2_sr_nm"});
  }
  for (const SkyLight& light : lights) {
    WeightedLight weighted{light, {}, light.name == "sun" ? 0U : 1U};
    if (!options.unit_irradiance) {
      SpectralWeights weights = spectral_weights(light.irradiance, wavelengths);
      weighted.functionals = {std::move(weights.y), std::move(weights.x), std::move(weights.z), std::move(weights.s)};
    }
    for (const double wavelength : radiances) {
      SpectralFunctional& radiance = weighted.functionals.emplace_back(wavelengths.size(), 0.0);
      const auto place = std::find(wavelengths.begin(), wavelengths.end(), wavelength) - wavelengths.begin();
      radiance[static_cast<std::size_t>(place)] = options.unit_irradiance ? 1.0 : light.irradiance(wavelength);
    }
    request.lights.push_back(std::move(weighted));
  }
}

/// Numbers in a form that keeps every digit.
template <class Numbers> void append_all(std::string& text, const Numbers& numbers) {
  for (const double number : numbers) {
    append_number(text, number);
    text += ',';
  }
  text += '\n';
}

std::string description(const Medium& medium, const std::vector<double>& wavelengths) {
  std::string text;
  const double top_km = (medium.top_radius - medium.ground_radius).to(kilometre);
  append_all(text, std::array{medium.ground_radius.to(kilometre), top_km});
  for (const double wavelength : wavelengths) {
    append_all(text, std::array{medium.ground_albedo(wavelength)});
  }
  for (const MediumComponent& component : medium.components) {
    append_all(text, component.profile.breaks_km());
    constexpr int steps = 512;
    for (int i = 0; i <= steps; ++i) {
      append_all(text, std::array{component.profile.at(top_km * i / steps)});
    }
    for (const double wavelength : wavelengths) {
      append_all(text, std::array{component.scattering_per_km(wavelength), component.absorption_per_km(wavelength),
                                  component.phase.parameter(wavelength), static_cast<double>(component.phase.kind)});
    }
  }
  return text;
}

} // namespace

void add_budget_options(CLI::App& app, BudgetOptions& options) {
  const char* const group = "Reference sky";
  app.add_option("--relative-error", options.relative_error,
                 "Standard error over value at which a quantity of `sky` or a column of light is known well enough, "
                 "1e-6 to 1; default 0.01")
      ->type_name("X")
      ->group(group);
  app.add_option("--most-paths", options.most_paths,
                 fmt::format("Paths of light for a quantity after which the error is taken as it is, 1 to 1e15 as an "
                             "integer; default {}",
                             PathBudget().most_paths))
      ->type_name("N")
      ->group(group);
  app.add_option("--orders", options.orders,
                 "How often light may have been scattered or reflected, 1 to 1000000; default without limit")
      ->type_name("N")
      ->group(group);
  app.add_option("--threads", options.threads,
                 "Threads of a process, 1 to 1024; default 0, one per core (one per process under mpirun). Results do "
                 "not depend on it")
      ->type_name("N")
      ->group(group);
}

PathBudget path_budget(const BudgetOptions& options, const SceneOptions& scene) {
  PathBudget budget;
  budget.relative_error = number_of("--relative-error", options.relative_error, 1.0e-6, 1.0);
  if (!options.most_paths.empty()) {
    budget.most_paths = count_of("--most-paths", options.most_paths, 1, 1'000'000'000'000'000);
    budget.least_paths = std::min(budget.least_paths, budget.most_paths);
  }
  if (!options.orders.empty()) {
    budget.orders = static_cast<int>(count_of("--orders", options.orders, 1, 1'000'000));
  }
  budget.threads = static_cast<unsigned>(count_of("--threads", options.threads, 0, 1024));
  budget.seed = scene.seed;
  return budget;
}

CLI::App* add_sky_command(CLI::App& app, SkyOptions& options) {
  CLI::App* sky = app.add_subcommand(
      "sky",
      "Luminance of the sky under Sun and Moon as CSV, JSON or an EXR picture, by tables or by the reference, which "
      "also "
      "gives radiances and standard errors (1 sigma). Their discs are not in it. Rays are straight and the lights "
      "stand "
      "at their airless places; eclipses dim them. With --reference and -o FILE, finished directions are kept in "
      "FILE.partial until FILE is complete: the same request goes on from there");
  sky->add_flag(
      "--reference", options.reference,
      "By the reference, a spectral Monte Carlo of all orders, with standard errors; the same as --sky reference");
  sky->add_flag("--zenith", options.zenith, "Look to the zenith; the default");
  sky->add_option("--directions", options.directions,
                  "Look where a CSV tells: columns altitude_deg, azimuth_deg, and perhaps sun_altitude_deg, "
                  "sun_azimuth_deg for a Sun by hand in each row")
      ->type_name("FILE");
  sky->add_flag("--picture", options.picture,
                "Look at every pixel of the view (see View); implied by an output NAME.exr, which gets X, Y, Z, S in "
                "cd/m2");
  sky->add_option("--light", options.light, "sun, moon or both; default all there are")->type_name("NAME");
  sky->add_option("--sun-altitude", options.sun_altitude,
                  "Set the Sun by hand, 1 au away, -90 to 90: time and place then do not count, the height is 0 unless "
                  "given")
      ->type_name("DEG");
  sky->add_option("--sun-azimuth", options.sun_azimuth, "Its azimuth, -360 to 360; default 180")->type_name("DEG");
  sky->add_option("--sun-radius", options.sun_radius,
                  "Angular radius of the Sun, 0 (a parallel beam) to 1; default that at its distance, 0.2666 at 1 au")
      ->type_name("DEG");
  sky->add_option("--moon-altitude", options.moon_altitude, "Set the Moon by hand, at its mean distance, -90 to 90")
      ->type_name("DEG");
  sky->add_option("--moon-azimuth", options.moon_azimuth, "Its azimuth, -360 to 360; default 180")->type_name("DEG");
  sky->add_option("--moon-phase-angle", options.moon_phase_angle, "Its phase angle, 0 (full) to 180 (new); default 0")
      ->type_name("DEG");
  sky->add_option("--wavelengths", options.wavelengths,
                  "Radiance too, W/(m2 sr nm), at these comma-separated wavelengths in nm, within those of the medium")
      ->type_name("LIST");
  sky->add_flag("--unit-irradiance", options.unit_irradiance,
                "Radiance alone, 1/sr, of one light that gives 1 at each wavelength above the air; at all wavelengths "
                "of the medium unless --wavelengths names some");
  sky->add_flag("--illuminance", options.illuminance,
                "Illuminance of a level surface too: horizontal_illuminance_lux with its error, and "
                "direct_illuminance_lux, the part of it that comes from Sun and Moon themselves");
  sky->add_flag("--timings", options.timings, "A column of seconds too; no two runs then write the same");
  sky->footer("Scene options, --relative-error, --most-paths, --orders, --threads, --seed, -o and --json: see "
              "vesper-report --help");
  return sky;
}

std::optional<CsvTable> directions_table(const SkyOptions& options) {
  return options.directions.empty()
             ? std::nullopt
             : std::optional<CsvTable>(std::in_place, read_file(options.directions), options.directions);
}

bool lights_by_hand(const SkyOptions& options, const std::optional<CsvTable>& directions) {
  return !options.sun_altitude.empty() || !options.moon_altitude.empty() || (directions && table_has_sun(*directions));
}

SkyRequest sky_request(const SkyOptions& options, const BudgetOptions& budget, const SceneOptions& scene,
                       const std::optional<CsvTable>& directions, bool picture_by_output) {
  const SkyModel model = options.reference ? SkyModel::reference : scene.sky;
  if (model != SkyModel::reference) {
    for (const auto& [option, given] :
         {std::pair("--wavelengths", !options.wavelengths.empty()),
          std::pair("--unit-irradiance", options.unit_irradiance), std::pair("--orders", !budget.orders.empty())}) {
      if (given) {
        throw Error(ErrorKind::argument, fmt::format("{}: only with --reference; tables hold the light of all orders "
                                                     "in X, Y, Z and S",
                                                     option));
      }
    }
  }
  if (static_cast<int>(options.zenith) + static_cast<int>(options.picture || picture_by_output) +
          static_cast<int>(directions.has_value()) >
      1) {
    throw Error(ErrorKind::argument, "sky: give one of --zenith, --directions FILE and --picture (or -o NAME.exr)");
  }
  if (options.unit_irradiance && picture_by_output) {
    throw Error(ErrorKind::argument, "--unit-irradiance: not for a picture, which holds X, Y, Z, S in cd/m2");
  }
  if (options.illuminance && (options.unit_irradiance || options.picture || picture_by_output)) {
    throw Error(ErrorKind::argument, "--illuminance: not for a picture, where it is the same everywhere, and not with "
                                     "--unit-irradiance");
  }
  SkyRequest request;
  request.model = model;
  request.illuminance = options.illuminance;
  request.budget = path_budget(budget, scene);
  request.medium_name = scene.medium_name;
  request.medium = scene.medium;
  request.timings = options.timings;
  const bool height_matters = scene.height_given || !lights_by_hand(options, directions);
  request.height = height_matters ? height_in_air(scene.observer) : 0.0 * metre;
  const std::vector<double> radiances = requested_wavelengths(options, *request.medium);
  const std::vector<SkyLight> lights = chosen_lights(options, scene, directions);
  if (options.unit_irradiance && lights.size() != 1) {
    throw Error(ErrorKind::argument,
                fmt::format("--unit-irradiance: takes one light and there are {}; give --light sun or --light moon",
                            lights.size()));
  }
  ask_for_quantities(options, radiances, lights, request);
  if (options.picture || picture_by_output) {
    request.picture = scene.view;
    request.points = points_of_view(scene.view);
  } else {
    request.points = directions ? points_of_table(*directions) : zenith_point();
  }
  return request;
}

std::string fingerprint(const SkyRequest& request) {
  std::string text = "vesper " VESPER_VERSION "\n" + description(*request.medium, request.wavelengths_nm);
  append_all(text, request.wavelengths_nm);
  append_all(text, std::array{request.height.to(metre), request.budget.relative_error, request.timings ? 1.0 : 0.0,
                              request.illuminance ? 1.0 : 0.0});
  text += fmt::format("{} {} {} {}\n", request.budget.least_paths, request.budget.most_paths, request.budget.orders,
                      request.budget.seed);
  for (const WeightedLight& weighted : request.lights) {
    const Vec3& d = weighted.light.direction;
    append_all(text, std::array{d.x, d.y, d.z, weighted.light.angular_radius.to(rad)});
    text += fmt::format("{}\n", weighted.stream);
    for (const SpectralFunctional& functional : weighted.functionals) {
      append_all(text, functional);
    }
  }
  for (const SkyQuantity& quantity : request.quantities) {
    text += quantity.name + " " + quantity.unit + "\n";
  }
  for (const SkyPoint& point : request.points) {
    const SeenPlace sun = point.sun.value_or(SeenPlace{-999.0, 0.0});
    append_all(text, std::array{point.place.altitude_deg, point.place.azimuth_deg, sun.altitude_deg, sun.azimuth_deg});
  }
  return sha256_hex(std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace vesper
