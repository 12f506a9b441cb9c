#include "report/star_report.hpp"

#include "report/sky_figures.hpp"

#include "common/option_text.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/atmosphere/star_extinction_table.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/sky/moon_shadow.hpp"
#include "vesper/sky/sky_light.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace vesper {
namespace {

/// Lower case without blanks: how names are compared.
std::string folded(std::string_view text) {
  std::string key;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isspace(byte) == 0) {
      key += static_cast<char>(std::tolower(byte));
    }
  }
  return key;
}

/// The number of "hr2491" after its prefix; 0 when it is something else.
std::uint32_t number_after(std::string_view key, std::string_view prefix) {
  if (!key.starts_with(prefix)) {
    return 0;
  }
  key.remove_prefix(prefix.size());
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  return error == std::errc() && end == key.data() + key.size() ? number : 0;
}

std::size_t find_star(std::string_view id, const StarCatalogue& catalogue) {
  const std::string key = folded(id);
  std::uint32_t hr = number_after(key, "hr");
  const std::uint32_t hd = number_after(key, "hd");
  for (const NamedStar& named : named_stars()) {
    hr = folded(named.name) == key ? named.hr : hr;
  }
  const auto matches = [&](const StarIdentity& star) {
    return (hr != 0 && star.hr == hr) || (hd != 0 && star.hd == hd) ||
           (!key.empty() && !star.name.empty() && folded(star.name) == key);
  };
  const auto found = std::find_if(catalogue.identities.begin(), catalogue.identities.end(), matches);
  if (found == catalogue.identities.end()) {
    throw Error(ErrorKind::argument,
                fmt::format("--ids: '{}' is not in the catalogue; allowed: HR or HD numbers as in HR2491, "
                            "designations and names of its stars",
                            id));
  }
  return static_cast<std::size_t>(found - catalogue.identities.begin());
}

/// Whether it is seen, or what hides it; nothing of a star of unknown magnitude that stands above the horizon.
std::string_view visibility_text(const RequestedStar& star, const StarSight& sight) {
  return star.magnitude || sight.hidden == Hidden::below_horizon ? name_of(sight.hidden) : "";
}

Vec3 direction_of(const Horizontal& place) {
  return unit_vector((90.0 * deg - place.azimuth).to(rad), place.altitude.to(rad));
}

bool blank(std::string_view text) { return text.find_first_not_of(" \t") == std::string_view::npos; }

} // namespace

CatalogueStar catalogue_star(const StarRecord& record) {
  const auto vec3 = [](const std::array<float, 3>& v) { return Vec3(v[0], v[1], v[2]); };
  return {glm::normalize(vec3(record.position)), vec3(record.proper_motion), static_cast<double>(record.parallax),
          static_cast<double>(record.radial_velocity)};
}

std::vector<RequestedStar> stars_by_id(std::string_view ids, const StarCatalogue& catalogue) {
  std::vector<RequestedStar> stars;
  for (const std::string_view id : list_items(ids)) {
    const std::size_t index = find_star(id, catalogue);
    // The shortest decimal form of the float, not its binary neighbour in double precision.
    const std::string magnitude = fmt::format("{}", catalogue.identities[index].magnitude);
    const StarRecord& record = catalogue.stars[index];
    const auto& color = record.color;
    const double v = std::stod(magnitude);
    stars.push_back({std::string(id), catalogue_star(record), catalogue.provenance.epoch_jyear, v,
                     Vec4(color[0], color[1], color[2], color[3]),
                     static_cast<double>(record.illuminance) * lux / illuminance_of_v(v, 1.0)});
  }
  return stars;
}

std::vector<RequestedStar> stars_of_table(const CsvTable& table) {
  const std::size_t id = table.column("id");
  const std::size_t ra = table.column("ra_deg");
  const std::size_t dec = table.column("dec_deg");
  const std::size_t epoch = table.column("epoch_jyear");
  // What may stand blank, with the most that a star could have: ten times the fastest known, a hundred times the
  // nearest's parallax, the speed of light. Measured parallaxes of far stars scatter below zero.
  struct Optional {
    std::size_t column;
    double lowest, highest;
  };
  const std::array optional{Optional{table.column("pm_ra_cosdec_mas_yr"), -1e5, 1e5},
                            Optional{table.column("pm_dec_mas_yr"), -1e5, 1e5},
                            Optional{table.column("parallax_mas"), -1e5, 1e5},
                            Optional{table.column("radial_velocity_km_s"), -299792.0, 299792.0}};
  const auto magnitude = table.find_column("magnitude");
  std::vector<RequestedStar> stars;
  stars.reserve(table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < optional.size(); ++i) {
      const auto& [column, lowest, highest] = optional.at(i);
      values.at(i) = blank(table.cell(row, column)) ? 0.0 : table.number(row, column, lowest, highest);
    }
    RequestedStar star;
    star.id = table.cell(row, id);
    star.star = catalogue_star(table.number(row, ra, -180.0, 360.0) * deg, table.number(row, dec, -90.0, 90.0) * deg,
                               values[0] * milliarcsec, values[1] * milliarcsec, std::max(values[2], 0.0) * milliarcsec,
                               values[3]);
    star.epoch_jyear = table.number(row, epoch, -4712.0, 9999.0);
    if (magnitude && !blank(table.cell(row, *magnitude))) {
      star.magnitude = table.number(row, *magnitude);
    }
    stars.push_back(std::move(star));
  }
  return stars;
}

std::vector<ReportedPlace> reported_places(const std::vector<RequestedStar>& stars, const StarFrame& frame) {
  constexpr std::size_t stars_per_chunk = 1024;
  std::vector<ReportedPlace> places(stars.size());
  parallel_for(stars.size(), stars_per_chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 icrs = star_place_icrs(stars[i].star, place_frame(frame, stars[i].epoch_jyear));
      places[i] = {equatorial_of(frame.equator_of_date_from_icrs * icrs),
                   horizontal_of(frame.horizon_from_icrs * icrs)};
    }
  });
  return places;
}

std::vector<StarSight> star_sights(const std::vector<RequestedStar>& stars, const std::vector<ReportedPlace>& places,
                                   const SkyState& sky, const SceneAir& air) {
  const Refraction refraction = with_table(sky.refraction);
  const Length height = height_in_air(sky.observer);
  const StarExtinction extinction = make_star_extinction(
      air.medium(), height,
      refraction.model == RefractionModel::none ? std::nullopt : std::optional(refraction.conditions));
  const Angle horizon = horizon_altitude(refraction, sky.observer.height);
  std::vector<Horizontal> directions;
  directions.reserve(places.size());
  for (const ReportedPlace& place : places) {
    directions.push_back(place.horizontal);
  }
  std::optional<EclipsedSky> eclipse;
  if (moon_shadow(sky, {})) {
    eclipse.emplace(air.eclipsed(), moon_shadow(sky, air.eclipsed()->wavelengths_nm()).value(), height, 1);
  }
  const std::vector<SkyBackground> backgrounds = sky_backgrounds(sky, air.medium(), air.shared_tables(), air.dark_sky(),
                                                                 directions, eclipse ? &*eclipse : nullptr);
  std::vector<StarSight> sights;
  sights.reserve(stars.size());
  for (std::size_t i = 0; i < stars.size(); ++i) {
    const RequestedStar& star = stars[i];
    const Vec3 seen = apparent_direction(direction_of(directions[i]), refraction);
    const auto through_air = [&](double sine) {
      return StarLight{star.light * star_extinction(extinction, sine, star.light), star.lux_ratio};
    };
    sights.push_back(
        star_sight({star.magnitude.value_or(-100.0), latitude_of(seen), through_air(seen.z), through_air(1.0)},
                   backgrounds[i], sky.sun.altitude, horizon, air.field_factor()));
  }
  return sights;
}

std::string star_report_csv(const std::vector<RequestedStar>& stars, const std::vector<ReportedPlace>& places,
                            const std::vector<StarSight>& sights) {
  std::string csv = "id,right_ascension_deg,declination_deg,azimuth_deg,altitude_deg,magnitude";
  csv += sights.empty() ? "\n" : ",limiting_magnitude,visibility\n";
  for (std::size_t i = 0; i < stars.size(); ++i) {
    const ReportedPlace& place = places[i];
    append_csv_field(csv, stars[i].id);
    for (const Angle angle : {place.equatorial.right_ascension, place.equatorial.declination, place.horizontal.azimuth,
                              place.horizontal.altitude}) {
      csv += ',';
      append_number(csv, angle.to(deg));
    }
    csv += ',';
    if (stars[i].magnitude) {
      append_number(csv, *stars[i].magnitude);
    }
    if (!sights.empty()) {
      csv += ',';
      append_number(csv, sights[i].limiting_magnitude);
      csv += ',';
      csv += visibility_text(stars[i], sights[i]);
    }
    csv += '\n';
  }
  return csv;
}

std::string star_report_json(const std::vector<RequestedStar>& stars, const std::vector<ReportedPlace>& places,
                             const std::vector<StarSight>& sights) {
  auto json = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < stars.size(); ++i) {
    nlohmann::ordered_json row;
    row["id"] = stars[i].id;
    row["right_ascension_deg"] = places[i].equatorial.right_ascension.to(deg);
    row["declination_deg"] = places[i].equatorial.declination.to(deg);
    row["azimuth_deg"] = places[i].horizontal.azimuth.to(deg);
    row["altitude_deg"] = places[i].horizontal.altitude.to(deg);
    row["magnitude"] = stars[i].magnitude ? nlohmann::ordered_json(*stars[i].magnitude) : nlohmann::ordered_json();
    if (!sights.empty()) {
      row["limiting_magnitude"] = sights[i].limiting_magnitude;
      row["visibility"] = visibility_text(stars[i], sights[i]);
    }
    json.push_back(std::move(row));
  }
  return json.dump(2) + "\n";
}

} // namespace vesper
