// vesper-report: what the sky is at a place and time.
#include "report/batch.hpp"
#include "report/body_columns.hpp"
#include "report/crew.hpp"
#include "report/eclipse_report.hpp"
#include "report/event_report.hpp"
#include "report/light_columns.hpp"
#include "report/scene_columns.hpp"
#include "report/scene_text.hpp"
#include "report/sky_report.hpp"
#include "report/star_report.hpp"

#include "common/option_text.hpp"
#include "common/program.hpp"
#include "common/scene_options.hpp"
#include "common/sky_tables_cache.hpp"

#include "vesper/assets/default_stars.hpp"
#include "vesper/astro/delta_t.hpp"
#include "vesper/base/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace vesper {
namespace {

struct ReportOptions {
  bool json = false;
  std::string output;
  std::string batch;
  std::string columns;
  std::string ids;
  std::string catalogue;
  bool visibility = false;
  std::string from, to, kind;
  std::string shadow = "danjon";
  std::string lunar_radius = "mean";
  EventOptions events;
  SkyOptions sky;
  BudgetOptions budget;
};

void deliver(const std::string& text, const std::string& path) {
  if (path.empty()) {
    write_standard_output(text);
  } else {
    write_file_atomically(path, text);
  }
}

std::string scene_json(const ReportedScene& scene, const std::vector<SceneColumn>& columns) {
  const SkyState& sky = scene.sky;
  nlohmann::ordered_json json;
  json["time"] = to_iso8601(sky.instant);
  if (const std::vector<std::string> remarks = time_remarks(sky.instant); !remarks.empty()) {
    json["note"] = fmt::format("{}", fmt::join(remarks, ". "));
  }
  json["jd_tt"] = sky.instant.tt.value();
  json["jd_ut1"] = sky.instant.ut1.value();
  json["delta_t_s"] = sky.instant.delta_t_s;
  json["delta_t_uncertainty_s"] = delta_t_uncertainty_s(sky.instant.tt);
  json["latitude_deg"] = sky.observer.latitude.to(deg);
  json["longitude_deg"] = sky.observer.longitude.to(deg);
  json["height_m"] = sky.observer.height.to(metre);
  for (const SceneColumn& column : columns) {
    json[std::string(column.name)] = column.value(scene);
  }
  return json.dump(2) + "\n";
}

std::string scene_lines(const ReportedScene& scene, const std::vector<SceneColumn>& columns) {
  std::string text;
  for (const SceneColumn& column : columns) {
    text.append(column.name).append(" = ");
    append_number(text, column.value(scene));
    text += '\n';
  }
  return text;
}

void report_scene(const SceneOptions& scene, const ReportOptions& options) {
  // What a scene is said to be without columns asked for: all that is found without long work.
  std::vector<SceneColumn> columns = select_columns(options.columns);
  if (options.columns.empty()) {
    columns.insert(columns.end(), body_columns().begin(), body_columns().end());
    columns.insert(columns.end(), light_columns().begin(), light_columns().end());
  }
  const SkyState sky = sky_state_of(scene);
  const SceneAir air(scene, path_budget(options.budget, scene));
  const ReportedScene reported{sky, air, {}, {}};
  deliver(options.json ? scene_json(reported, columns)
          : options.columns.empty()
              ? scene_text(sky, default_star_catalogue(), light_of(reported), dark_light_of(reported),
                           select_columns("limiting_magnitude")[0].value(reported))
              : scene_lines(reported, columns),
          options.output);
}

void report_batch(const SceneOptions& scene, const ReportOptions& options) {
  if (options.json) {
    throw Error(ErrorKind::argument, "--json: not with --batch, which writes CSV");
  }
  const std::vector<SceneColumn> columns = select_columns(options.columns);
  const CsvTable input(read_file(options.batch), options.batch);
  PathBudget budget = path_budget(options.budget, scene);
  const unsigned threads = std::exchange(budget.threads, 1); // they share out the rows
  const BatchReport report = batch_report(input, columns, scene, SceneAir(scene, budget), threads);
  if (report.rows_taken_as_ut1 > 0) {
    spdlog::info("{}: {} stamps lie outside the leap seconds known (1972 to 2026), the first in line {}: taken as UT1, "
                 "with TT from Delta-T",
                 options.batch, report.rows_taken_as_ut1, report.first_such_line);
  }
  if (report.farthest_line > 0) {
    for (const std::string& remark : accuracy_remarks(report.farthest)) {
      spdlog::info("{}: line {}, the farthest date: {}", options.batch, report.farthest_line, remark);
    }
  }
  deliver(report.csv, options.output);
}

void report_stars(const SceneOptions& scene, const ReportOptions& options) {
  if (options.ids.empty() == options.catalogue.empty()) {
    throw Error(ErrorKind::argument, "stars: give either --ids LIST or --catalogue FILE");
  }
  const std::vector<RequestedStar> stars =
      options.catalogue.empty() ? stars_by_id(options.ids, default_star_catalogue())
                                : stars_of_table(CsvTable(read_file(options.catalogue), options.catalogue));
  const StarFrame frame = star_frame(scene.instant, scene.observer, scene.tier);
  const std::vector<ReportedPlace> places = reported_places(stars, frame);
  const std::vector<StarSight> sights =
      options.visibility ? star_sights(stars, places, sky_state_of(scene), SceneAir(scene)) : std::vector<StarSight>();
  deliver(options.json ? star_report_json(stars, places, sights) : star_report_csv(stars, places, sights),
          options.output);
}

void report_eclipses(const SceneOptions& scene, const ReportOptions& options) {
  const EclipseRequest request =
      eclipse_request(options.kind, options.shadow, options.lunar_radius, options.from, options.to, scene);
  const EclipseReport report = eclipse_report(request, options.json);
  if (report.any_in_ut1) {
    spdlog::info("eclipses outside the leap seconds known (1972 to 2026) are given in UT1, from TT by Delta-T");
  }
  deliver(report.text, options.output);
}

void report_events(const SceneOptions& scene, const ReportOptions& options) {
  const EventRequest request = event_request(scene, options.events);
  if (scene.instant.note.empty() && !request.note.empty()) {
    spdlog::info("{}", request.note);
  }
  deliver(options.json ? event_report_json(scene, request) : event_report_csv(scene, request), options.output);
}

bool has_extension(const std::string& path, std::string_view wanted) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == wanted;
}

void deliver_sky(const SkyRequest& request, const SkyResults& results, const ReportOptions& options, bool as_picture) {
  if (as_picture) {
    const View& view = request.picture.value();
    write_exr(options.output, view.width, view.height, sky_picture(request, results), describe_picture(request));
  } else {
    deliver(options.json ? sky_report_json(request, results) : sky_report_csv(request, results), options.output);
  }
}

void report_sky(const SceneOptions& scene, const ReportOptions& options, const std::optional<CsvTable>& directions,
                Crew& crew) {
  // vesper-render writes PNG: who asks for one here wants a picture, not a table under its name.
  if (has_extension(options.output, ".png")) {
    refuse_option("--output", options.output, "NAME.exr for a picture, any other name for a table");
  }
  const bool exr = has_extension(options.output, ".exr");
  if (exr && options.json) {
    throw Error(ErrorKind::argument, "--json: not with a picture; give an output that does not end in .exr");
  }
  const SkyRequest request = sky_request(options.sky, options.budget, scene, directions, exr);
  if (request.lights.empty()) {
    spdlog::info("neither Sun nor Moon is near enough to the horizon to light the air");
  }
  if (request.model != SkyModel::reference) {
    if (crew.leads()) {
      deliver_sky(request, sky_results(request, *scene_sky_tables(scene, request.budget.threads)), options, exr);
    }
    return;
  }
  if (constexpr std::size_t many = 10000; request.points.size() >= many) {
    spdlog::info("{} directions, each of which may take a second of a core: --size makes a smaller picture",
                 request.points.size());
  }
  // Beside a pipe or a device nothing can be kept.
  const bool keeps = !options.output.empty() &&
                     (std::filesystem::is_regular_file(options.output) || !std::filesystem::exists(options.output));
  const std::string partial = keeps ? options.output + ".partial" : "";
  const SkyResults results = sky_results(request, partial, crew);
  if (!crew.leads()) {
    return;
  }
  deliver_sky(request, results, options, exr);
  if (!partial.empty()) {
    std::error_code ignored; // the results are safe in the output
    std::filesystem::remove(partial, ignored);
  }
}

} // namespace
} // namespace vesper

// Only a lack of memory while the options are set up can leave this function.
int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape)
  using namespace vesper;
  const std::unique_ptr<Crew> crew = make_crew(argc, argv);
  CLI::App app("What the sky is at a place and time: positions of Sun, Moon and stars", "vesper-report");
  prepare_program(app);
  ReportOptions options;
  app.add_flag("--json", options.json, "Write JSON");
  app.add_option("-o,--output", options.output, "Write to a file instead of standard output")->type_name("FILE");
  const CLI::Option* batch = app.add_option("--batch", options.batch,
                                            "CSV of scenes with the columns utc (or jd_tt, jd_ut1), latitude_deg, "
                                            "longitude_deg, height_m; others pass through")
                                 ->type_name("FILE");
  app.add_option(
         "--columns", options.columns,
         "Comma-separated quantities to report, also venus_magnitude and its like, sun_magnitude, sun_illuminance_lux "
         "and sun_disc_luminance_cd_m2 above the air, the Moon's, moon_danjon of its eclipses, "
         "zenith_extinction_v_mag of the medium, horizontal_illuminance_lux, zenith_luminance_cd_m2, "
         "limiting_magnitude (V "
         "above the air of the faintest star seen in the zenith) and, by source, "
         "sun_direct_illuminance_lux, sun_diffuse_illuminance_lux, sun_zenith_luminance_cd_m2 and the Moon's, "
         "airglow_illuminance_lux, airglow_zenith_luminance_cd_m2 and those of zodiacal, starlight and sky_glow; "
         "default "
         "(the usual ones), planets, discs and light stand for groups; default default, of a scene as JSON discs and "
         "light too")
      ->type_name("LIST");
  const SceneOptionSet scene_options(app);

  CLI::App* stars = app.add_subcommand("stars", "Places of chosen stars, as CSV or JSON");
  stars->add_option("--ids", options.ids, "Comma-separated HR2491, HD48915, designations or names")->type_name("LIST");
  stars
      ->add_option("--catalogue", options.catalogue,
                   "CSV with the columns id, ra_deg, dec_deg, epoch_jyear, pm_ra_cosdec_mas_yr, pm_dec_mas_yr, "
                   "parallax_mas, radial_velocity_km_s")
      ->type_name("FILE");

  stars->add_flag(
      "--visibility", options.visibility,
      "Two columns more: limiting_magnitude, V above the air of the faintest star of its colour that is seen "
      "in its place, and visibility: visible, or what hides it");

  CLI::App* eclipses = app.add_subcommand("eclipses", "Eclipses of a span of years, as CSV or JSON");
  eclipses->add_option("--from", options.from, "Year, date or instant of the first")->type_name("TIME");
  eclipses->add_option("--to", options.to, "Year, date or instant of the last; a year or date is included")
      ->type_name("TIME");
  eclipses->add_option("--kind", options.kind, "lunar or solar; solar ones also as seen from the place")
      ->type_name("KIND");
  eclipses->add_option("--shadow", options.shadow, "The Earth's shadow: danjon (default) or chauvenet")
      ->type_name("MODEL");
  eclipses
      ->add_option("--lunar-radius", options.lunar_radius,
                   "The Moon of second and third contacts of solar eclipses: mean (default, k = 0.2725076) or valleys "
                   "(k = 0.272281, as almanacs time totality: some seconds shorter)")
      ->type_name("NAME");

  const CLI::App* events = add_events_command(app, options.events);
  add_budget_options(app, options.budget);
  const CLI::App* sky = add_sky_command(app, options.sky);
  app.require_subcommand(0, 1);

  return run_program(argc, argv, app, [&] {
    if (!crew->leads() && !sky->parsed()) {
      return; // only the sky is work for several processes
    }
    const bool in_batch = batch->count() > 0 && app.get_subcommands().empty();
    const std::optional<CsvTable> directions = directions_table(options.sky);
    const bool place_matters = !in_batch && !lights_by_hand(options.sky, directions);
    const SceneOptions scene = scene_options.resolve(place_matters ? Assumptions::said : Assumptions::silent);
    if (!options.output.empty()) {
      require_writable(options.output);
    }
    for (const CLI::App* command : app.get_subcommands()) {
      if (batch->count() > 0 || !options.columns.empty()) {
        throw Error(ErrorKind::argument, command->get_name() + ": takes no --batch and no --columns");
      }
    }
    if (stars->parsed()) {
      report_stars(scene, options);
    } else if (eclipses->parsed()) {
      report_eclipses(scene, options);
    } else if (events->parsed()) {
      report_events(scene, options);
    } else if (sky->parsed()) {
      report_sky(scene, options, directions, *crew);
    } else if (in_batch) {
      report_batch(scene, options);
    } else {
      report_scene(scene, options);
    }
  });
}
