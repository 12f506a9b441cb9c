#include "report/scene_columns.hpp"

#include "common/option_text.hpp"

#include "vesper/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vesper {
namespace {

constexpr std::array columns{
    SceneColumn{"sun_right_ascension_deg", [](const SkyState& s) { return s.sun.right_ascension.to(deg); }},
    SceneColumn{"sun_declination_deg", [](const SkyState& s) { return s.sun.declination.to(deg); }},
    SceneColumn{"sun_azimuth_deg", [](const SkyState& s) { return s.sun.azimuth.to(deg); }},
    SceneColumn{"sun_altitude_deg", [](const SkyState& s) { return s.sun.altitude.to(deg); }},
    SceneColumn{"sun_distance_au", [](const SkyState& s) { return s.sun.distance.to(astronomical_unit); }},
    SceneColumn{"moon_right_ascension_deg", [](const SkyState& s) { return s.moon.place.right_ascension.to(deg); }},
    SceneColumn{"moon_declination_deg", [](const SkyState& s) { return s.moon.place.declination.to(deg); }},
    SceneColumn{"moon_azimuth_deg", [](const SkyState& s) { return s.moon.place.azimuth.to(deg); }},
    SceneColumn{"moon_altitude_deg", [](const SkyState& s) { return s.moon.place.altitude.to(deg); }},
    SceneColumn{"moon_distance_km", [](const SkyState& s) { return s.moon.place.distance.to(kilometre); }},
    SceneColumn{"moon_illuminated_fraction", [](const SkyState& s) { return s.moon.illuminated_fraction; }},
    SceneColumn{"moon_phase_angle_deg", [](const SkyState& s) { return s.moon.phase_angle.to(deg); }},
    SceneColumn{"moon_bright_limb_deg", [](const SkyState& s) { return s.moon.bright_limb.to(deg); }},
    SceneColumn{"moon_axis_deg", [](const SkyState& s) { return s.moon.axis.to(deg); }},
    SceneColumn{"moon_libration_longitude_deg", [](const SkyState& s) { return s.moon.libration.longitude.to(deg); }},
    SceneColumn{"moon_libration_latitude_deg", [](const SkyState& s) { return s.moon.libration.latitude.to(deg); }},
    SceneColumn{"moon_umbral_magnitude", [](const SkyState& s) { return s.lunar_eclipse.umbral_magnitude; }},
    SceneColumn{"moon_penumbral_magnitude", [](const SkyState& s) { return s.lunar_eclipse.penumbral_magnitude; }},
    SceneColumn{"sun_obscuration", [](const SkyState& s) { return s.solar_eclipse.obscuration; }},
};

std::string all_names() {
  std::string names;
  for (const SceneColumn& column : columns) {
    names.append(names.empty() ? "" : ", ").append(column.name);
  }
  return names;
}

} // namespace

std::span<const SceneColumn> scene_columns() { return columns; }

std::vector<SceneColumn> select_columns(std::string_view list) {
  if (list.empty()) {
    return {columns.begin(), columns.end()};
  }
  std::vector<SceneColumn> selected;
  for (const std::string_view name : list_items(list)) {
    const auto same_name = [&](const SceneColumn& column) { return column.name == name; };
    const auto* const found = std::find_if(columns.begin(), columns.end(), same_name);
    if (found == columns.end()) {
      refuse_option("--columns", name, "a comma-separated list of " + all_names());
    }
    if (std::any_of(selected.begin(), selected.end(), same_name)) {
      throw Error(ErrorKind::argument, fmt::format("--columns: '{}' stands twice", name));
    }
    selected.push_back(*found);
  }
  return selected;
}

} // namespace vesper
