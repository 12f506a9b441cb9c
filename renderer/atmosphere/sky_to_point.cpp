#include "vesper/atmosphere/sky_to_point.hpp"

#include "vesper/atmosphere/air_view.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vesper {
namespace {

/// The light's direction as it lies to a view: along the view's level direction, aside and up.
f32::vec3 to_light(const AirView& view) {
  const double level = std::cos(view.light_altitude_rad);
  const double aside = std::sqrt(std::max(0.0, 1.0 - view.cos_azimuth * view.cos_azimuth));
  return {static_cast<float>(level * view.cos_azimuth), static_cast<float>(level * aside),
          static_cast<float>(std::sin(view.light_altitude_rad))};
}

} // namespace

SkyWay sky_way(const SkyTables& tables, const SkyQuery& query, Length distance) {
  const double distance_km = distance.to(kilometre);
  if (!(distance_km >= 0.0)) {
    throw Error(ErrorKind::argument, "a distance below zero, or none", {"", "", "Give 0 km or more"});
  }
  if (tables.small) {
    throw Error(ErrorKind::argument, "light on the way to a point from small tables", {"", "", "Give large ones"});
  }
  const f32::SkyTableFrame& frame = tables.frame;
  const std::optional<AirView> seen =
      view_in_air(query, static_cast<double>(frame.ground_km), static_cast<double>(frame.top_km));
  const double in_air_km = seen ? distance_km - seen->distance_km : 0.0;
  if (!(in_air_km > 0.0)) {
    return {{}, {1.0, 1.0, 1.0, 1.0}};
  }
  const f32::SkyRayPlace from{static_cast<float>(seen->height_km), static_cast<float>(seen->altitude_rad),
                              to_light(*seen), seen->meets_ground};
  const float phase = f32::sky_aerosol_phase(line_sampler(tables.phase), static_cast<float>(seen->cos_angle),
                                             static_cast<int>(tables.phase.size()));
  const auto most_km = static_cast<double>(std::numeric_limits<float>::max());
  const f32::SkyWay way = f32::sky_way(
      sampler(tables, tables.other), sampler(tables, tables.aerosol), transmittance_sampler(tables), tables.light, from,
      phase, static_cast<float>(std::min(in_air_km, most_km)), tables.transmittance_frame, frame);
  return {to_xyzs(way.light), to_xyzs(way.transmittance)};
}

} // namespace vesper
