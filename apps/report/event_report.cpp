#include "report/event_report.hpp"

#include "report/star_report.hpp"

#include "common/option_text.hpp"

#include "vesper/assets/default_stars.hpp"
#include "vesper/astro/constants.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

namespace vesper {
namespace {

constexpr int most_days = 36525;
constexpr double end_of_dates_jd = 5373484.5; // 10000-01-01

std::string planet_names() {
  std::string names;
  for (int i = 0; i < planet_count; ++i) {
    names.append(i == 0 ? "" : ", ").append(name_of(static_cast<Planet>(i)));
  }
  return names;
}

/// The last midnight that has come at `instant`.
double midnight_jd_before(const Instant& instant) {
  double jd = std::floor(instant.ut1.value() - 0.5) + 1.5; // UT1 may be a second off UTC
  while (instant.tt.days_since(instant_from_utc({jd, 0.0}).tt) < 0.0) {
    jd -= 1.0;
  }
  return jd;
}

EventRequest::Body body_of(const std::string& given) {
  std::string name = given; // of the solar system's bodies; stars keep their spelling
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name == "sun" || name == "moon") {
    return {name, name == "sun" ? Luminary::sun : Luminary::moon};
  }
  for (int i = 0; i < planet_count; ++i) {
    if (name == name_of(static_cast<Planet>(i))) {
      return {name, static_cast<Planet>(i)};
    }
  }
  try {
    const RequestedStar star = stars_by_id(given, default_star_catalogue()).at(0);
    return {given, DatedStar{star.star, star.epoch_jyear}};
  } catch (const Error&) {
    refuse_option("--bodies", given,
                  fmt::format("a comma-separated list of sun, moon, {} and of stars by HR or HD number as in HR2491, "
                              "designation or name",
                              planet_names()));
  }
}

std::vector<EventRequest::Body> bodies_of(const std::string& list) {
  std::vector<EventRequest::Body> bodies;
  for (const std::string_view item : list_items(list)) {
    EventRequest::Body body = body_of(std::string(item));
    if (std::any_of(bodies.begin(), bodies.end(), [&](const auto& other) { return other.name == body.name; })) {
      refuse_option("--bodies", list, fmt::format("each body once, but '{}' stands there twice", body.name));
    }
    bodies.push_back(std::move(body));
  }
  return bodies;
}

HorizonRule horizon_rule(const SceneOptions& scene, const EventOptions& options) {
  const auto horizon = number_within(options.horizon, -10.0, 80.0);
  if (!horizon && !options.horizon.empty()) {
    refuse_option("--horizon", options.horizon, "-10 to 80 degrees");
  }
  if (options.refraction == "model") {
    const Refraction air = with_table(refraction_of(scene, scene.observer.height));
    return HorizonRule::seen(air, horizon ? *horizon * deg : horizon_altitude(air, scene.observer.height));
  }
  if (options.refraction != "almanac") {
    refuse_option("--refraction", options.refraction, "almanac, model");
  }
  HorizonRule rule = HorizonRule::almanac();
  rule.limb_altitude = rule.limb_altitude + horizon.value_or(0.0) * deg;
  return rule;
}

struct Row {
  std::string_view body;
  std::string_view event;
  std::optional<Instant> instant;
  Horizontal place;
};

struct Day {
  std::string date;
  std::vector<Row> rows;
};

/// What the Sun's altitudes of a day leave out, beyond whether it rises and sets: the first twilight that does not end
/// in night, or the last that does not begin.
std::optional<Row> twilight_row(const BodyEvents& sun) {
  struct Level {
    Angle altitude;
    std::string_view not_below, not_above;
  };
  constexpr std::array levels{Level{civil_twilight_end, "does not sink below -6", "does not climb above -6"},
                              Level{nautical_twilight_end, "does not sink below -12", "does not climb above -12"},
                              Level{astronomical_twilight_end, "does not sink below -18", "does not climb above -18"}};
  if (sun.conduct == HorizonConduct::stays_above) {
    return std::nullopt;
  }
  const auto* const bright = std::find_if(
      levels.begin(), levels.end(), [&](const Level& level) { return sun.lowest.place.altitude > level.altitude; });
  if (bright != levels.end()) {
    return Row{"sun", bright->not_below, std::nullopt, sun.lowest.place};
  }
  const auto dark = std::find_if(levels.rbegin(), levels.rend(),
                                 [&](const Level& level) { return sun.highest.place.altitude < level.altitude; });
  return dark == levels.rend() ? std::nullopt
                               : std::optional(Row{"sun", dark->not_above, std::nullopt, sun.highest.place});
}

Day day_of(const SceneOptions& scene, const EventRequest& request, double midnight_jd) {
  const Instant begin = instant_from_utc({midnight_jd, 0.0});
  const Instant end = instant_from_utc({midnight_jd + 1.0, 0.0});
  std::vector<SkyBody> bodies;
  for (const EventRequest::Body& body : request.bodies) {
    bodies.push_back(body.body);
  }
  const auto found = sky_events(begin, end, scene.observer, bodies, request.rule, scene.tier);

  Day day;
  const std::string noon = to_iso8601(instant_from_utc({midnight_jd, 0.5}));
  day.date = noon.substr(0, noon.find('T'));
  for (std::size_t i = 0; i < found.size(); ++i) {
    const BodyEvents& body = found[i];
    const std::string_view name = request.bodies[i].name;
    if (body.conduct == HorizonConduct::stays_below) {
      day.rows.push_back({name, "does not rise", std::nullopt, body.highest.place});
    } else if (body.conduct == HorizonConduct::stays_above) {
      day.rows.push_back({name, "does not set", std::nullopt, body.lowest.place});
    }
    const auto* const luminary = std::get_if<Luminary>(&request.bodies[i].body);
    if (luminary != nullptr && *luminary == Luminary::sun) {
      if (const auto row = twilight_row(body)) {
        day.rows.push_back(*row);
      }
    }
    for (const SkyEvent& event : body.events) {
      if (event.kind != SkyEventKind::lower_transit || request.lower_transits) {
        day.rows.push_back({name, name_of(event.kind), event.instant, event.place});
      }
    }
  }
  // What holds all day stands first.
  std::stable_sort(day.rows.begin(), day.rows.end(), [](const Row& a, const Row& b) {
    return b.instant && (!a.instant || a.instant->tt.days_since(b.instant->tt) < 0.0);
  });
  return day;
}

std::vector<Day> days_of(const SceneOptions& scene, const EventRequest& request) {
  constexpr std::size_t days_per_chunk = 16;
  std::vector<Day> days(static_cast<std::size_t>(request.days));
  parallel_for(days.size(), days_per_chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      days[i] = day_of(scene, request, request.first_midnight_jd + static_cast<double>(i));
    }
  });
  return days;
}

} // namespace

CLI::App* add_events_command(CLI::App& app, EventOptions& options) {
  CLI::App* events = app.add_subcommand(
      "events",
      "Rise, set, transit and twilights from 00:00 to 24:00 of the date of --time (UTC; UT1 outside its table), as CSV "
      "or JSON. By almanac convention the Sun rises and sets with its centre at -50', the Moon with its upper limb and "
      "planets and stars with their centre at -34', airless; the dip of the horizon from a height is ignored. "
      "Twilights: the Sun's centre at -6, -12, -18 degrees. Azimuth and altitude are those of the centre, airless; at "
      "'does not rise' and 'does not climb above' the highest of the day, at 'does not set' and 'does not sink below' "
      "the "
      "lowest");
  events->add_option("--days", options.days, fmt::format("How many dates, 1 to {}; default 1", most_days))
      ->type_name("N");
  events
      ->add_option("--bodies", options.bodies,
                   fmt::format("Comma-separated sun, moon, {}, and stars as HR2491, HD48915, designations or names; "
                               "default sun,moon",
                               planet_names()))
      ->type_name("LIST");
  events
      ->add_option("--refraction", options.refraction,
                   "almanac: the convention; model: as seen from --height through air of --pressure and --temperature, "
                   "by the model of --tier: the upper limb of Sun and Moon in their true size, or a planet or star, on "
                   "the horizon; default almanac")
      ->type_name("NAME");
  events
      ->add_option(
          "--horizon", options.horizon,
          "Altitude of the horizon, -10 to 80: as seen with --refraction model, there by default the sea's with "
          "its dip; else added to the convention's, default 0. Twilights do not depend on it")
      ->type_name("DEG");
  events->add_flag("--lower-transits", options.lower_transits, "Lower transits too");
  return events;
}

EventRequest event_request(const SceneOptions& scene, const EventOptions& options) {
  EventRequest request;
  request.first_midnight_jd = midnight_jd_before(scene.instant);
  const int dates_left = static_cast<int>(std::min<double>(most_days, end_of_dates_jd - request.first_midnight_jd));
  const auto days = number_within(options.days, 1, dates_left);
  if (!days) {
    refuse_option(
        "--days", options.days,
        fmt::format("1 to {}{}", dates_left, dates_left < most_days ? ", for dates end with 9999-12-31" : ""));
  }
  request.days = *days;
  request.note = instant_from_utc({request.first_midnight_jd + *days - 1.0, 0.5}).note;
  request.bodies = bodies_of(options.bodies);
  request.rule = horizon_rule(scene, options);
  request.lower_transits = options.lower_transits;
  return request;
}

std::string event_report_csv(const SceneOptions& scene, const EventRequest& request) {
  std::string csv = "date,body,event,time,azimuth_deg,altitude_deg\n";
  for (const Day& day : days_of(scene, request)) {
    for (const Row& row : day.rows) {
      csv.append(day.date).append(",");
      append_csv_field(csv, row.body);
      csv.append(",").append(row.event).append(",");
      csv.append(row.instant ? to_iso8601(*row.instant) : "").append(",");
      append_number(csv, row.place.azimuth.to(deg));
      csv += ',';
      append_number(csv, row.place.altitude.to(deg));
      csv += '\n';
    }
  }
  return csv;
}

std::string event_report_json(const SceneOptions& scene, const EventRequest& request) {
  auto json = nlohmann::ordered_json::array();
  for (const Day& day : days_of(scene, request)) {
    for (const Row& row : day.rows) {
      nlohmann::ordered_json entry;
      entry["date"] = day.date;
      entry["body"] = row.body;
      entry["event"] = row.event;
      entry["time"] = row.instant ? nlohmann::ordered_json(to_iso8601(*row.instant)) : nlohmann::ordered_json();
      entry["azimuth_deg"] = row.place.azimuth.to(deg);
      entry["altitude_deg"] = row.place.altitude.to(deg);
      json.push_back(std::move(entry));
    }
  }
  return json.dump(2) + "\n";
}

} // namespace vesper
