#include "report/scene_columns.hpp"

#include "report/body_columns.hpp"
#include "report/light_columns.hpp"
#include "report/planet_columns.hpp"

#include "common/option_text.hpp"

#include "vesper/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vesper {
namespace {

constexpr std::array columns{
    SceneColumn{"sun_right_ascension_deg", [](const ReportedScene& s) { return s.sky.sun.right_ascension.to(deg); }},
    SceneColumn{"sun_declination_deg", [](const ReportedScene& s) { return s.sky.sun.declination.to(deg); }},
    SceneColumn{"sun_azimuth_deg", [](const ReportedScene& s) { return s.sky.sun.azimuth.to(deg); }},
    SceneColumn{"sun_altitude_deg", [](const ReportedScene& s) { return s.sky.sun.altitude.to(deg); }},
    SceneColumn{"sun_distance_au", [](const ReportedScene& s) { return s.sky.sun.distance.to(astronomical_unit); }},
    SceneColumn{"moon_right_ascension_deg",
                [](const ReportedScene& s) { return s.sky.moon.place.right_ascension.to(deg); }},
    SceneColumn{"moon_declination_deg", [](const ReportedScene& s) { return s.sky.moon.place.declination.to(deg); }},
    SceneColumn{"moon_azimuth_deg", [](const ReportedScene& s) { return s.sky.moon.place.azimuth.to(deg); }},
    SceneColumn{"moon_altitude_deg", [](const ReportedScene& s) { return s.sky.moon.place.altitude.to(deg); }},
    SceneColumn{"moon_distance_km", [](const ReportedScene& s) { return s.sky.moon.place.distance.to(kilometre); }},
    SceneColumn{"moon_illuminated_fraction", [](const ReportedScene& s) { return s.sky.moon.illuminated_fraction; }},
    SceneColumn{"moon_phase_angle_deg", [](const ReportedScene& s) { return s.sky.moon.phase_angle.to(deg); }},
    SceneColumn{"moon_bright_limb_deg", [](const ReportedScene& s) { return s.sky.moon.bright_limb.to(deg); }},
    SceneColumn{"moon_axis_deg", [](const ReportedScene& s) { return s.sky.moon.axis.to(deg); }},
    SceneColumn{"moon_libration_longitude_deg",
                [](const ReportedScene& s) { return s.sky.moon.libration.longitude.to(deg); }},
    SceneColumn{"moon_libration_latitude_deg",
                [](const ReportedScene& s) { return s.sky.moon.libration.latitude.to(deg); }},
    SceneColumn{"moon_umbral_magnitude", [](const ReportedScene& s) { return s.sky.lunar_eclipse.umbral_magnitude; }},
    SceneColumn{"moon_penumbral_magnitude",
                [](const ReportedScene& s) { return s.sky.lunar_eclipse.penumbral_magnitude; }},
    SceneColumn{"sun_obscuration", [](const ReportedScene& s) { return s.sky.solar_eclipse.obscuration; }},
};

std::string allowed_names() {
  std::string names = "a comma-separated list of ";
  for (const SceneColumn& column : columns) {
    names.append(column.name).append(", ");
  }
  names += "default for all of these, planets for those of all planets (venus_magnitude, ...), discs for";
  for (const SceneColumn& column : body_columns()) {
    names.append(" ").append(column.name).append(",");
  }
  names += " light for";
  for (const SceneColumn& column : light_columns()) {
    names.append(" ").append(column.name).append(",");
  }
  names.pop_back();
  return names;
}

/// The columns that a name stands for: one, or a group.
std::span<const SceneColumn> columns_named(std::string_view name) {
  if (name == "default") {
    return columns;
  }
  if (name == "planets") {
    return planet_columns();
  }
  if (name == "discs") {
    return body_columns();
  }
  if (name == "light") {
    return light_columns();
  }
  for (const std::span<const SceneColumn> group :
       {std::span<const SceneColumn>(columns), planet_columns(), body_columns(), light_columns()}) {
    const auto found =
        std::find_if(group.begin(), group.end(), [&](const SceneColumn& column) { return column.name == name; });
    if (found != group.end()) {
      return {found, 1};
    }
  }
  refuse_option("--columns", name, allowed_names());
}

} // namespace

std::span<const SceneColumn> scene_columns() { return columns; }

std::vector<SceneColumn> select_columns(std::string_view list) {
  if (list.empty()) {
    return {columns.begin(), columns.end()};
  }
  std::vector<SceneColumn> selected;
  for (const std::string_view name : list_items(list)) {
    for (const SceneColumn& column : columns_named(name)) {
      if (std::any_of(selected.begin(), selected.end(), [&](const auto& other) { return other.name == column.name; })) {
        throw Error(ErrorKind::argument, fmt::format("--columns: '{}' stands twice", column.name));
      }
      selected.push_back(column);
    }
  }
  return selected;
}

} // namespace vesper
