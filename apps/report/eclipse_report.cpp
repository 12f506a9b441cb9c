#include "report/eclipse_report.hpp"

#include "report/body_columns.hpp"

#include "common/option_text.hpp"

#include "vesper/astro/local_solar_eclipse.hpp"
#include "vesper/astro/solar_eclipse.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/sky/moon_illumination.hpp"
#include "vesper/sky/sky_state.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace vesper {
namespace {

using Value = nlohmann::ordered_json; ///< text, a number or null

template <class Row> struct Column {
  const char* name;
  Value (*value)(const Row& row);
};

struct LunarRow {
  LunarEclipse eclipse;
  SkyState greatest; ///< for the observer
  MoonIllumination moon;
};

Value stamp(const std::optional<Instant>& instant) { return instant ? Value(to_iso8601(*instant)) : Value(); }

template <LunarContact contact> Value contact_of(const LunarRow& row) { return stamp(row.eclipse.contact(contact)); }

constexpr std::array lunar_columns{
    Column<LunarRow>{"greatest", [](const LunarRow& r) { return Value(to_iso8601(r.eclipse.greatest)); }},
    Column<LunarRow>{"type", [](const LunarRow& r) { return Value(name_of(r.eclipse.type)); }},
    Column<LunarRow>{"gamma", [](const LunarRow& r) { return Value(r.eclipse.gamma); }},
    Column<LunarRow>{"umbral_magnitude", [](const LunarRow& r) { return Value(r.eclipse.umbral_magnitude); }},
    Column<LunarRow>{"penumbral_magnitude", [](const LunarRow& r) { return Value(r.eclipse.penumbral_magnitude); }},
    Column<LunarRow>{"P1", contact_of<LunarContact::p1>},
    Column<LunarRow>{"U1", contact_of<LunarContact::u1>},
    Column<LunarRow>{"U2", contact_of<LunarContact::u2>},
    Column<LunarRow>{"U3", contact_of<LunarContact::u3>},
    Column<LunarRow>{"U4", contact_of<LunarContact::u4>},
    Column<LunarRow>{"P4", contact_of<LunarContact::p4>},
    Column<LunarRow>{"moon_altitude_deg",
                     [](const LunarRow& r) { return Value(r.greatest.moon.place.altitude.to(deg)); }},
    Column<LunarRow>{"moon_magnitude", [](const LunarRow& r) { return Value(v_magnitude(moonlight_of(r.moon))); }},
    Column<LunarRow>{"moon_danjon", [](const LunarRow& r) { return Value(seen_danjon_of(r.greatest, r.moon)); }},
};

struct SolarRow {
  SolarEclipse eclipse;
  LocalSolarEclipse local;
  [[nodiscard]] bool seen() const { return local.type != SolarEclipseType::none && local.sun_up; }
};

template <SolarContact contact> Value contact_of(const SolarRow& row) {
  const std::optional<SolarMoment>& moment = row.local.contact(contact);
  return row.seen() && moment ? stamp(moment->instant) : Value();
}

/// A figure of what is seen at the observer's place.
template <class Figure> Value local(const SolarRow& row, Figure figure) {
  return row.seen() ? Value(figure(row.local)) : Value();
}

constexpr std::array solar_columns{
    Column<SolarRow>{"greatest", [](const SolarRow& r) { return Value(to_iso8601(r.eclipse.greatest)); }},
    Column<SolarRow>{"type", [](const SolarRow& r) { return Value(name_of(r.eclipse.type)); }},
    Column<SolarRow>{"gamma", [](const SolarRow& r) { return Value(r.eclipse.gamma); }},
    Column<SolarRow>{"greatest_latitude_deg",
                     [](const SolarRow& r) { return Value(r.eclipse.place.latitude.to(deg)); }},
    Column<SolarRow>{"greatest_longitude_deg",
                     [](const SolarRow& r) { return Value(r.eclipse.place.longitude.to(deg)); }},
    Column<SolarRow>{
        "local_type",
        [](const SolarRow& r) { return Value(name_of(r.seen() ? r.local.type : SolarEclipseType::none)); }},
    Column<SolarRow>{"C1", contact_of<SolarContact::c1>},
    Column<SolarRow>{"C2", contact_of<SolarContact::c2>},
    Column<SolarRow>{"max",
                     [](const SolarRow& r) {
                       return local(r, [](const LocalSolarEclipse& l) { return to_iso8601(l.maximum.instant); });
                     }},
    Column<SolarRow>{"C3", contact_of<SolarContact::c3>},
    Column<SolarRow>{"C4", contact_of<SolarContact::c4>},
    Column<SolarRow>{
        "magnitude",
        [](const SolarRow& r) { return local(r, [](const LocalSolarEclipse& l) { return l.state.magnitude; }); }},
    Column<SolarRow>{
        "obscuration",
        [](const SolarRow& r) { return local(r, [](const LocalSolarEclipse& l) { return l.state.obscuration; }); }},
    Column<SolarRow>{"sun_altitude_deg",
                     [](const SolarRow& r) {
                       return local(r, [](const LocalSolarEclipse& l) { return l.maximum.sun_altitude.to(deg); });
                     }},
};

template <class Row> std::string csv_of(std::span<const Row> rows, std::span<const Column<Row>> columns) {
  std::string csv;
  for (const Column<Row>& column : columns) {
    csv.append(csv.empty() ? "" : ",").append(column.name);
  }
  csv += '\n';
  for (const Row& row : rows) {
    for (const Column<Row>& column : columns) {
      const Value value = column.value(row);
      if (value.is_number()) {
        append_number(csv, value.template get<double>());
      } else if (value.is_string()) {
        append_csv_field(csv, value.template get<std::string>());
      }
      csv += ',';
    }
    csv.back() = '\n';
  }
  return csv;
}

template <class Row> std::string json_of(std::span<const Row> rows, std::span<const Column<Row>> columns) {
  Value array = Value::array();
  for (const Row& row : rows) {
    Value object = Value::object();
    for (const Column<Row>& column : columns) {
      object[column.name] = column.value(row);
    }
    array.push_back(std::move(object));
  }
  return array.dump(2) + "\n";
}

template <class Row, std::size_t N>
EclipseReport table_of(const std::vector<Row>& rows, const std::array<Column<Row>, N>& columns, bool json) {
  EclipseReport report;
  report.text = json ? json_of<Row>(rows, columns) : csv_of<Row>(rows, columns);
  report.any_in_ut1 = std::any_of(rows.begin(), rows.end(),
                                  [](const Row& row) { return to_iso8601(row.eclipse.greatest).ends_with("UT1"); });
  return report;
}

/// An instant, or a year or a date of which the beginning or the end is meant.
Instant border(const char* option, std::string_view text, bool end, const SceneOptions& scene) {
  constexpr const char* allowed =
      "a year (2026), a date (2026-08-12) or an instant (2026-08-12T12:00:00Z), years -4712 "
      "to 9999";
  if (text.empty()) {
    throw Error(ErrorKind::argument, fmt::format("eclipses: {} is missing; allowed: {}", option, allowed));
  }
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  const bool is_year = digits.size() == 4 && digits.find_first_not_of("0123456789") == std::string_view::npos;
  const bool is_date = digits.size() == 10 && digits[4] == '-';
  const std::string date = std::string(text) + (!is_year ? "" : end ? "-12-31" : "-01-01");
  try {
    Instant instant = parse_instant(date, scene.time_scale, scene.calendar);
    return end && (is_year || is_date) ? later(instant, seconds_per_day) : instant;
  } catch (const Error& e) {
    throw Error(ErrorKind::argument,
                fmt::format("{}: '{}' is not allowed: {}; allowed: {}", option, text, e.message(), allowed));
  }
}

} // namespace

EclipseRequest eclipse_request(std::string_view kind, std::string_view shadow, std::string_view lunar_radius,
                               std::string_view from, std::string_view to, const SceneOptions& scene) {
  EclipseRequest request;
  if (kind != "lunar" && kind != "solar") {
    if (kind.empty()) {
      throw Error(ErrorKind::argument, "eclipses: --kind is missing; allowed: lunar, solar");
    }
    refuse_option("--kind", kind, "lunar, solar");
  }
  request.kind = kind == "lunar" ? EclipseKind::lunar : EclipseKind::solar;
  if (shadow != "danjon" && shadow != "chauvenet") {
    refuse_option("--shadow", shadow, "danjon, chauvenet");
  }
  request.shadow = shadow == "danjon" ? ShadowModel::danjon : ShadowModel::chauvenet;
  if (lunar_radius != "mean" && lunar_radius != "valleys") {
    refuse_option("--lunar-radius", lunar_radius, "mean, valleys");
  }
  request.umbral_radius_ratio = lunar_radius == "mean" ? moon_radius_ratio : moon_valley_radius_ratio;
  request.from = border("--from", from, false, scene);
  request.to = border("--to", to, true, scene);
  if (request.to.tt.days_since(request.from.tt) <= 0.0) {
    refuse_option("--to", to, fmt::format("later than --from, {}", from));
  }
  request.scene = scene;
  return request;
}

EclipseReport eclipse_report(const EclipseRequest& request, bool json) {
  if (request.kind == EclipseKind::lunar) {
    std::vector<LunarRow> rows;
    for (LunarEclipse& eclipse : lunar_eclipses(request.from, request.to, request.shadow)) {
      SkyState greatest = sky_state_of(request.scene, eclipse.greatest, request.scene.observer);
      MoonIllumination moon = moon_illumination(greatest);
      rows.push_back({std::move(eclipse), std::move(greatest), std::move(moon)});
    }
    return table_of(rows, lunar_columns, json);
  }
  std::vector<SolarRow> rows;
  for (SolarEclipse& eclipse : solar_eclipses(request.from, request.to)) {
    LocalSolarEclipse local =
        local_solar_eclipse(eclipse.greatest, request.scene.observer, request.umbral_radius_ratio);
    rows.push_back({std::move(eclipse), std::move(local)});
  }
  return table_of(rows, solar_columns, json);
}

} // namespace vesper
