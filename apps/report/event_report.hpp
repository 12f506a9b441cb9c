// Rises, sets, transits and twilights of some days, as a table.
#pragma once

#include "common/scene_options.hpp"

#include "vesper/astro/sky_events.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace vesper {

/// The options of `events` as they were given.
struct EventOptions {
  std::string days = "1";
  std::string bodies = "sun,moon";
  std::string refraction = "almanac";
  std::string horizon; ///< that of the sea, if empty
  bool lower_transits = false;
};

/// Adds the subcommand `events` with its options to `app`.
[[nodiscard]] CLI::App* add_events_command(CLI::App& app, EventOptions& options);

/// What `events` is to find, after its options were read.
struct EventRequest {
  struct Body {
    std::string name;
    SkyBody body;
  };
  std::vector<Body> bodies;
  double first_midnight_jd = 0.0; ///< of the date of the scene's time, in UTC or outside its table in UT1
  int days = 1;
  HorizonRule rule;
  bool lower_transits = false;
  std::string note; ///< of the last date's time scale, as in Instant
};

/// Throws Error(argument) naming the option, its value and what is allowed.
[[nodiscard]] EventRequest event_request(const SceneOptions& scene, const EventOptions& options);

/// A row an event, by date and time: "date,body,event,time,azimuth_deg,altitude_deg", airless apparent places. A body
/// that a whole date long does not cross the horizon has a row "does not rise" with its highest place, or "does not
/// set" with its lowest; time is blank there (null in JSON).
[[nodiscard]] std::string event_report_csv(const SceneOptions& scene, const EventRequest& request);
[[nodiscard]] std::string event_report_json(const SceneOptions& scene, const EventRequest& request);

} // namespace vesper
