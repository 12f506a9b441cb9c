#include "vesper/plan/dark_sky_plan.hpp"

#include "vesper/light/night_light.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"
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
  const double horizon = std::asin(place.horizon_sin_altitude);
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
double highest_light_km(const DarkSkyPlace& place, double ground_km) {
  const double air_km = place.medium != nullptr ? place.medium->top_radius.to(kilometre) - ground_km : 0.0;
  return std::max(air_km, f64::airglow_top_km);
}

std::vector<double> glow_pattern(const DarkSkyPlace& place, const std::vector<DarkRow>& rows) {
  const CityGlowPattern pattern(*place.medium, place.height, place.glow.distance);
  std::vector<double> values;
  for (const int index : coarse_rows()) {
    const double sine = std::sin(rows[static_cast<std::size_t>(index)].straight_rad);
    const double around = place.glow.azimuth ? 0.0 : pattern.around(std::max(sine, 0.0));
    for (int column = 0; column < dark_columns; ++column) {
      const bool below = index < PlannedDarkSky::rows_below;
      values.push_back(below ? 0.0
                       : place.glow.azimuth
                           ? pattern.toward(std::max(sine, 0.0), azimuth_of(column) - *place.glow.azimuth)
                           : around);
    }
  }
  return values;
}

void fill(DarkSkyPlace& place) {
  const double ground_km = place.medium != nullptr ? place.medium->ground_radius.to(kilometre) : earth_radius_km;
  const double height_km = place.height.to(kilometre);
  const double dip = dip_of(height_km, ground_km);
  const double top_km = highest_light_km(place, ground_km);
  const bool outside = height_km > top_km;
  double sin_highest = 1.0;
  if (outside) {
    const double limb_dip = std::acos((ground_km + top_km) / (ground_km + height_km));
    sin_highest = std::sin(std::asin(place.horizon_sin_altitude) + dip - limb_dip);
  }
  place.frame = f64::sky_map_frame(place.horizon_sin_altitude, sin_highest);
  std::vector<DarkRow> rows;
  rows.reserve(dark_rows);
  for (int index = 0; index < dark_rows; ++index) {
    rows.push_back(dark_row(index, place, dip, outside));
  }
  std::optional<RefractedColumns> columns;
  std::optional<LightThroughAir> through;
  if (place.medium != nullptr) {
    columns.emplace(*place.medium, place.height, place.bending);
    through.emplace(*place.medium, airglow_spectrum());
  }
  for (const DarkRow& row : rows) {
    const Vec2 paths = f64::airglow_paths(std::sin(row.straight_rad), height_km, ground_km);
    place.airglow_paths.push_back(paths);
    place.airglow_shares.push_back(
        columns && paths.y > 0.0 ? through->share(columns->columns_km(std::sin(row.seen_rad))) : Vec4(1.0));
  }
  if (place.glow.zenith > Luminance() && place.medium != nullptr) {
    place.glow_pattern = glow_pattern(place, rows);
  }
  if (place.sky_tables != nullptr) {
    const std::vector<int> coarse = coarse_rows();
    std::vector<Angle> altitudes;
    altitudes.reserve(coarse.size());
    for (const int index : coarse) {
      altitudes.push_back(rows[static_cast<std::size_t>(index)].straight_rad * rad);
    }
    place.views.emplace(place.sky_tables, place.height, altitudes);
  }
}

bool same(const CityGlow& a, const CityGlow& b) {
  return a.zenith == b.zenith && a.azimuth == b.azimuth && a.distance == b.distance;
}

std::shared_ptr<const DarkSkyPlace> place_of(DarkSkyPlace wanted, const PlannedDarkSky* before) {
  if (before != nullptr) {
    const DarkSkyPlace& known = *before->place;
    if (known.medium == wanted.medium && known.sky_tables == wanted.sky_tables && known.height == wanted.height &&
        known.bending == wanted.bending && known.horizon_sin_altitude == wanted.horizon_sin_altitude &&
        same(known.glow, wanted.glow)) {
      return before->place;
    }
  }
  fill(wanted);
  return std::make_shared<const DarkSkyPlace>(std::move(wanted));
}

/// A source, and what turns scattered sunlight into its own.
struct ScatteredSource {
  SpreadLight light;
  Mat4 from_sunlight;
};

std::vector<ScatteredSource> scattered_sources(const PlannedDarkSky& planned, const LayerSet& layers) {
  std::vector<ScatteredSource> sources;
  if (!planned.place->views) {
    return sources;
  }
  const Angle lowest = planned.place->views->lowest();
  const DarkSky& dark = planned.sources;
  const Spectrum& sunlight = solar_irradiance_1au();
  if (has(layers, Layer::airglow)) {
    static const Mat4 matrix = response_matrix(sunlight, airglow_spectrum());
    sources.push_back({spread_light(lowest, [&](const Vec3& at) { return airglow_above(dark, at.z).y; }), matrix});
  }
  if (planned.zodiacal) {
    static const Mat4 matrix = response_matrix(sunlight, zodiacal_spectrum(0.5));
    sources.push_back({spread_light(lowest, [&](const Vec3& at) { return zodiacal_light(dark, at).y; }), matrix});
  }
  if (planned.starlight) {
    static const Mat4 matrix = response_matrix(sunlight, faint_starlight_spectrum());
    sources.push_back(
        {spread_light(lowest, [&](const Vec3& at) { return faint_starlight(dark, at, spread_light_width).y; }),
         matrix});
  }
  return sources;
}

/// Scattered light and sky glow, at the coarse rows.
std::vector<Vec4> smooth_light(const PlannedDarkSky& planned, const LayerSet& layers) {
  const DarkSkyPlace& place = *planned.place;
  const std::vector<ScatteredSource> sources = scattered_sources(planned, layers);
  static const Vec4 lamp = [] {
    const Xyzs light = integrate_xyzs(lamp_spectrum());
    return vector_of(light) / light.y;
  }();
  const bool glows = has(layers, Layer::sky_glow) && !place.glow_pattern.empty();
  const Vec4 glow = place.glow.zenith.to(candela_per_m2) * lamp;
  const std::size_t rows = coarse_rows().size();
  std::vector<Vec4> light;
  for (std::size_t row = 0; row < rows; ++row) {
    for (int column = 0; column < dark_columns; ++column) {
      Vec4 sum(0.0);
      for (const ScatteredSource& source : sources) {
        sum += source.from_sunlight * place.views->luminance(row, azimuth_of(column), source.light);
      }
      if (glows) {
        sum += place.glow_pattern[light.size()] * glow;
      }
      light.push_back(sum);
    }
  }
  return light;
}

} // namespace

bool draws_dark_sky(const LayerSet& layers) {
  return has(layers, Layer::milky_way) || has(layers, Layer::airglow) || has(layers, Layer::zodiacal) ||
         has(layers, Layer::sky_glow);
}

std::shared_ptr<const PlannedDarkSky> plan_dark_sky(const SkyState& sky, const LayerSet& layers,
                                                    const DarkSkyOptions& options,
                                                    const std::shared_ptr<const Medium>& medium,
                                                    const std::shared_ptr<const SkyTables>& sky_tables,
                                                    const std::optional<RefractionConditions>& bending,
                                                    double horizon_sin_altitude, const PlannedDarkSky* before) {
  if (!draws_dark_sky(layers)) {
    return nullptr;
  }
  PlannedDarkSky planned;
  planned.sources = dark_sky(sky, options);
  planned.zodiacal = has(layers, Layer::zodiacal);
  planned.starlight = has(layers, Layer::milky_way);
  DarkSkyPlace place;
  place.medium = medium;
  place.sky_tables = sky_tables;
  place.height = height_in_air(sky.observer);
  place.bending = bending;
  place.horizon_sin_altitude = horizon_sin_altitude;
  place.glow = options.glow;
  planned.place = place_of(std::move(place), before);

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
