#include "report/planet_columns.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace vesper {
namespace {

struct Quantity {
  std::string_view name;
  double (*value)(const PlanetState& planet);
};

constexpr std::array quantities{
    Quantity{"right_ascension_deg", [](const PlanetState& p) { return p.place.right_ascension.to(deg); }},
    Quantity{"declination_deg", [](const PlanetState& p) { return p.place.declination.to(deg); }},
    Quantity{"azimuth_deg", [](const PlanetState& p) { return p.place.azimuth.to(deg); }},
    Quantity{"altitude_deg", [](const PlanetState& p) { return p.place.altitude.to(deg); }},
    Quantity{"distance_au", [](const PlanetState& p) { return p.place.distance.to(astronomical_unit); }},
    Quantity{"magnitude", [](const PlanetState& p) { return p.appearance.magnitude; }},
    Quantity{"phase_angle_deg", [](const PlanetState& p) { return p.appearance.phase_angle.to(deg); }},
    Quantity{"illuminated_fraction", [](const PlanetState& p) { return p.appearance.illuminated_fraction; }},
    Quantity{"bright_limb_deg", [](const PlanetState& p) { return p.bright_limb.to(deg); }},
    Quantity{"diameter_arcsec", [](const PlanetState& p) { return p.appearance.diameter.to(arcsec); }},
    Quantity{"equatorial_diameter_arcsec",
             [](const PlanetState& p) { return p.appearance.equatorial_diameter.to(arcsec); }},
};
constexpr std::size_t column_count = quantities.size() * planet_count;

template <std::size_t Index> double value_of(const ReportedScene& scene) {
  return quantities[Index % quantities.size()].value(scene.sky.planets[Index / quantities.size()]);
}

template <std::size_t... Indices> auto functions_of(std::index_sequence<Indices...> /*indices*/) {
  return std::array<double (*)(const ReportedScene&), sizeof...(Indices)>{&value_of<Indices>...};
}

} // namespace

std::span<const SceneColumn> planet_columns() {
  static const auto names = [] {
    std::array<std::string, column_count> all;
    for (std::size_t i = 0; i < column_count; ++i) {
      all.at(i)
          .append(name_of(static_cast<Planet>(i / quantities.size())))
          .append("_")
          .append(quantities.at(i % quantities.size()).name);
    }
    return all;
  }();
  static const auto columns = [] {
    const auto functions = functions_of(std::make_index_sequence<column_count>());
    std::array<SceneColumn, column_count> all{};
    for (std::size_t i = 0; i < column_count; ++i) {
      all.at(i) = {names.at(i), functions.at(i)};
    }
    return all;
  }();
  return columns;
}

} // namespace vesper
