#include "vesper/plan/dark_sky_plan.hpp"

#include "vesper/light/night_light.hpp"
#include "vesper/sky/dark_sky_sources.hpp"
#include "vesper/sky/sky_light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr int dark_rows = PlannedDarkSky::rows_below + PlannedDarkSky::rows_above;
constexpr int dark_columns = PlannedDarkSky::columns + 1; ///< the last is the first again
constexpr double earth_radius_km = 6371.0;

/// A row of the map: how low it looks, as it is seen and along straight rays.
struct DarkRow {
  double seen_rad;
  double straight_rad;
};

/// The horizon that is seen falls on that of straight rays, and what is between them and the zenith or nadir is
/// stretched; the limb of the air, seen from outside, is not.
DarkRow dark_row(int index, const DarkSkyPlace& place, double dip_rad, bool outside) {
  const bool below = index < PlannedDarkSky::rows_below;
  const int steps = below ? PlannedDarkSky::rows_below - 1 - index : index - PlannedDarkSky::rows_below;
  const int last = (below ? PlannedDarkSky::rows_below : PlannedDarkSky::rows_above) - 1;
  const double seen = f64::sky_map_altitude_rad(static_cast<double>(steps) / last, below, place.frame);
  const double horizon = std::asin(place.setting.horizon_sin_altitude);
  if (below) {
    return {seen, -dip_rad - std::max(horizon - seen, 1.0e-7) * (0.5 * pi - dip_rad) / (0.5 * pi + horizon)};
  }
  const double above = std::max(seen - horizon, 1.0e-7);
  return {seen, -dip_rad + (outside ? above : above * (0.5 * pi + dip_rad) / (0.5 * pi - horizon))};
}

double dip_of(double height_km, double ground_km) {
  return std::atan2(std::sqrt(height_km * (2.0 * ground_km + height_km)), ground_km);
}

/// Azimuth of a column.
Angle azimuth_of(int column) {
  const Vec2 level = f64::sky_map_level(static_cast<double>(column) / PlannedDarkSky::columns);
  return std::atan2(level.x, level.y) * rad;
}

/// Between the rows of the coarse ones that lie beside it: number of the lower, and the share of the next.
std::pair<std::size_t, double> coarse_place(int index) {
  constexpr int below = PlannedDarkSky::rows_below;
  constexpr int step = PlannedDarkSky::row_step;
  const int first = index < below ? 0 : (below - 1) / step + 1;
  const int from = index < below ? index : index - below;
  const int last = (index < below ? below : PlannedDarkSky::rows_above) - 1;
  const int low = std::min(from / step, last / step - 1);
  return {static_cast<std::size_t>(first + low), static_cast<double>(from - low * step) / step};
}

/// Indices of the coarse rows.
std::vector<int> coarse_rows() {
  std::vector<int> rows;
  for (int index = 0; index < PlannedDarkSky::rows_below; index += PlannedDarkSky::row_step) {
    rows.push_back(index);
  }
  for (int index = PlannedDarkSky::rows_below; index < dark_rows; index += PlannedDarkSky::row_step) {
    rows.push_back(index);
  }
  return rows;
}

/// A height from which the air's limb is seen from outside: above the airglow or, if that is higher, the air.
double highest_light_km(const DarkSkySetting& setting, double ground_km) {
  const double air_km = setting.medium != nullptr ? setting.medium->top_radius.to(kilometre) - ground_km : 0.0;
  return std::max(air_km, f64::airglow_top_km);
}

std::vector<double> glow_pattern(const DarkSkySetting& setting, const std::vector<DarkRow>& rows) {
  const CityGlow& glow = setting.glow;
  const CityGlowPattern pattern(*setting.medium, setting.height, glow.distance);
  std::vector<double> values;
  for (const int index : coarse_rows()) {
    const double sine = std::sin(rows[static_cast<std::size_t>(index)].straight_rad);
    const double around = glow.azimuth ? 0.0 : pattern.around(std::max(sine, 0.0));
    for (int column = 0; column < dark_columns; ++column) {
      const bool below = index < PlannedDarkSky::rows_below;
      values.push_back(below          ? 0.0
                       : glow.azimuth ? pattern.toward(std::max(sine, 0.0), azimuth_of(column) - *glow.azimuth)
                                      : around);
    }
  }
  return values;
}

AirBeforeStars air_before_stars(const DarkSkySetting& setting, const f64::SkyMapFrame& frame) {
  AirBeforeStars air;
  const f64::RefractionFrame refraction = refraction_frame(setting.refraction);
  for (int index = 0; index < AirBeforeStars::rows_below + AirBeforeStars::rows_above; ++index) {
    const bool below = index < AirBeforeStars::rows_below;
    const double row =
        below ? static_cast<double>(AirBeforeStars::rows_below - 1 - index) / (AirBeforeStars::rows_below - 1)
              : static_cast<double>(index - AirBeforeStars::rows_below) / (AirBeforeStars::rows_above - 1);
    const double altitude = f64::sky_map_altitude_rad(row, below, frame);
    const double sine = std::sin(altitude);
    const double bend = f64::refraction_bend(Vec3(std::cos(altitude), 0.0, sine), true, refraction,
                                             refraction_sampler(setting.refraction));
    air.bends.emplace_back(Vec4(bend, 0.0, 0.0, 0.0));
    for (int hue = 0; hue < AirBeforeStars::hues; ++hue) {
      const double z = static_cast<double>(hue) / (AirBeforeStars::hues - 1);
      const Vec4 light(1.0, 1.0 - z, z, 1.0);
      air.shares.emplace_back(
          setting.extinction != nullptr ? glm::log2(star_extinction(*setting.extinction, sine, light)) : Vec4(0.0));
    }
  }
  return air;
}

std::shared_ptr<const DarkSkyPlace> make_place(DarkSkySetting wanted) {
  DarkSkyPlace place;
  place.setting = std::move(wanted);
  const DarkSkySetting& setting = place.setting;
  const double ground_km = setting.medium != nullptr ? setting.medium->ground_radius.to(kilometre) : earth_radius_km;
  const double height_km = setting.height.to(kilometre);
  const double dip = dip_of(height_km, ground_km);
  const double top_km = highest_light_km(setting, ground_km);
  const bool outside = height_km > top_km;
  double sin_highest = 1.0;
  if (outside) {
    const double limb_dip = std::acos((ground_km + top_km) / (ground_km + height_km));
    sin_highest = std::sin(std::asin(setting.horizon_sin_altitude) + dip - limb_dip);
  }
  place.frame = f64::sky_map_frame(setting.horizon_sin_altitude, sin_highest);
  place.air = air_before_stars(setting, place.frame);
  std::vector<DarkRow> rows;
  rows.reserve(dark_rows);
  for (int index = 0; index < dark_rows; ++index) {
    rows.push_back(dark_row(index, place, dip, outside));
  }
  std::optional<RefractedColumns> columns;
  std::optional<LightThroughAir> through;
  if (setting.medium != nullptr) {
    const bool bends = setting.refraction.model != RefractionModel::none;
    columns.emplace(*setting.medium, setting.height,
                    bends ? std::optional(setting.refraction.conditions) : std::nullopt);
    through.emplace(*setting.medium, airglow_spectrum());
  }
  for (const DarkRow& row : rows) {
    const Vec2 paths = f64::airglow_paths(std::sin(row.straight_rad), height_km, ground_km);
    place.airglow_paths.push_back(paths);
    place.airglow_shares.push_back(
        columns && paths.y > 0.0 ? through->share(columns->columns_km(std::sin(row.seen_rad))) : Vec4(1.0));
  }
  if (setting.glow.zenith > Luminance() && setting.medium != nullptr) {
    place.glow_pattern = glow_pattern(setting, rows);
  }
  if (setting.sky_tables != nullptr) {
    const std::vector<int> coarse = coarse_rows();
    std::vector<Angle> altitudes;
    altitudes.reserve(coarse.size());
    for (const int index : coarse) {
      altitudes.push_back(rows[static_cast<std::size_t>(index)].straight_rad * rad);
    }
    place.views.emplace(setting.sky_tables, setting.height, altitudes);
  }
  return std::make_shared<const DarkSkyPlace>(std::move(place));
}

std::vector<SpreadSource> scattered_sources(const PlannedDarkSky& planned, const LayerSet& layers) {
  std::vector<SpreadSource> sources;
  if (!planned.place->views) {
    return sources;
  }
  const Angle lowest = planned.place->views->lowest();
  if (has(layers, Layer::airglow)) {
    sources.push_back(spread_airglow(planned.sources, lowest));
  }
  if (planned.zodiacal) {
    sources.push_back(spread_zodiacal_light(planned.sources, lowest));
  }
  if (planned.starlight) {
    sources.push_back(spread_starlight(planned.sources, lowest));
  }
  return sources;
}

/// Scattered light and sky glow, at the coarse rows.
std::vector<Vec4> smooth_light(const PlannedDarkSky& planned, const LayerSet& layers) {
  const DarkSkyPlace& place = *planned.place;
  const std::vector<SpreadSource> sources = scattered_sources(planned, layers);
  const bool glows = has(layers, Layer::sky_glow) && !place.glow_pattern.empty();
  const Vec4 glow = place.setting.glow.zenith.to(candela_per_m2) * sky_glow_color();
  const std::size_t rows = coarse_rows().size();
  std::vector<Vec4> light;
  for (std::size_t row = 0; row < rows; ++row) {
    for (int column = 0; column < dark_columns; ++column) {
      Vec4 sum(0.0);
      for (const SpreadSource& source : sources) {
        sum += source.scattered(*place.views, row, azimuth_of(column));
      }
      if (glows) {
        sum += place.glow_pattern[light.size()] * glow;
      }
      light.push_back(sum);
    }
  }
  return light;
}

/// Whether both the map of the dark sky and that of the sky that is drawn reach the zenith.
bool reach_the_zenith(const DarkSkyPlace& place) {
  const f32::SkyTableFrame& air = place.setting.sky_tables->frame;
  return place.frame.zenith_to_end == 0.0 &&
         place.setting.height.to(kilometre) <= static_cast<double>(air.top_km - air.ground_km);
}

} // namespace

bool draws_dark_sky(const LayerSet& layers) {
  return has(layers, Layer::milky_way) || has(layers, Layer::airglow) || has(layers, Layer::zodiacal) ||
         has(layers, Layer::sky_glow);
}

bool operator==(const DarkSkySetting& a, const DarkSkySetting& b) {
  return a.medium == b.medium && a.sky_tables == b.sky_tables && a.extinction == b.extinction &&
         a.refraction.model == b.refraction.model && a.refraction.conditions == b.refraction.conditions &&
         a.height == b.height && a.horizon_sin_altitude == b.horizon_sin_altitude && a.glow == b.glow;
}

std::shared_ptr<const PlannedDarkSky> plan_dark_sky(const SkyState& sky, const LayerSet& layers,
                                                    const DarkSkyOptions& options, DarkSkySetting setting,
                                                    bool sky_is_drawn, const PlannedDarkSky* before) {
  if (!draws_dark_sky(layers)) {
    return nullptr;
  }
  PlannedDarkSky planned;
  planned.sources = dark_sky(sky, options);
  // A state put together by hand may have no Sun.
  planned.zodiacal = has(layers, Layer::zodiacal) && sky.sun.distance > Length();
  planned.starlight = has(layers, Layer::milky_way);
  const bool again = before != nullptr && before->place->setting == setting;
  planned.place = again ? before->place : make_place(std::move(setting));
  planned.air_with_sky = sky_is_drawn && reach_the_zenith(*planned.place);

  const std::vector<Vec4> smooth = smooth_light(planned, layers);
  const bool airglow = has(layers, Layer::airglow);
  planned.air.reserve(static_cast<std::size_t>(dark_rows) * dark_columns);
  for (int index = 0; index < dark_rows; ++index) {
    const auto row = static_cast<std::size_t>(index);
    const Vec2 paths = planned.place->airglow_paths[row];
    const Vec4 direct =
        airglow ? (paths.x + paths.y * planned.place->airglow_shares[row]) * planned.sources.airglow : Vec4(0.0);
    const auto [low, share] = coarse_place(index);
    for (std::size_t column = 0; column < dark_columns; ++column) {
      const Vec4 sum =
          direct + glm::mix(smooth[low * dark_columns + column], smooth[(low + 1) * dark_columns + column], share);
      planned.air.emplace_back(sum);
    }
  }
  return std::make_shared<const PlannedDarkSky>(std::move(planned));
}

} // namespace vesper
