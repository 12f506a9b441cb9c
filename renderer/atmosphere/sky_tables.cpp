#include "vesper/atmosphere/sky_tables.hpp"

#include "vesper/atmosphere/air_view.hpp"
#include "vesper/atmosphere/small_sky_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vesper {

f32::sampler3D sampler(const SkyTables& tables, const std::vector<f32::vec4>& scattering) {
  const f32::SkyTableFrame& frame = tables.frame;
  return {scattering.data(), frame.lights * f32::sky_azimuths, frame.views_below + frame.views_above, frame.heights};
}

f32::sampler2D transmittance_sampler(const SkyTables& tables) {
  return {tables.transmittance.data(), tables.transmittance_frame.altitudes, 2 * tables.transmittance_frame.heights};
}

f32::sampler1D line_sampler(const std::vector<f32::vec4>& texels) {
  return {texels.data(), static_cast<int>(texels.size())};
}

float log2_phase_without_peak(const SkyTables& tables, float cos_angle) {
  const auto log2_phase = [&](float cosine) {
    return std::log2(f32::sky_aerosol_phase(line_sampler(tables.phase), cosine, static_cast<int>(tables.phase.size())));
  };
  if (cos_angle < f32::sky_peak_cos) {
    return log2_phase(cos_angle);
  }
  constexpr float step = 0.01F;
  const float slope = (log2_phase(f32::sky_peak_cos + step) - log2_phase(f32::sky_peak_cos - step)) / (2.0F * step);
  return log2_phase(f32::sky_peak_cos) + slope * (cos_angle - f32::sky_peak_cos);
}

Xyzs to_xyzs(const f32::vec4& light) {
  return {static_cast<double>(light.x), static_cast<double>(light.y), static_cast<double>(light.z),
          static_cast<double>(light.w)};
}

SkySources sky_sources(const SkyTables& tables, float height_km, float altitude_rad, bool meets_ground,
                       float light_altitude_rad, float azimuth_cos) {
  const f32::SkyTableFrame& frame = tables.frame;
  if (tables.small) {
    const f32::SmallSkyLight light =
        small_sky_light(*tables.small, height_km, altitude_rad, meets_ground, light_altitude_rad, azimuth_cos);
    const float share = std::max(f32::sky_path_share(height_km, altitude_rad, meets_ground, frame), 1.0e-20F);
    return {light.aerosol / share, light.other / share};
  }
  const f32::SkyViewPlace row = f32::sky_view_place(altitude_rad, f32::sky_dip(height_km, frame), meets_ground, frame);
  const auto source = [&](const std::vector<f32::vec4>& table) {
    return glm::exp2(
        f32::sky_table_log2(sampler(tables, table), height_km, row, light_altitude_rad, azimuth_cos, frame));
  };
  return {source(tables.aerosol), source(tables.other)};
}

Xyzs sky_luminance(const SkyTables& tables, const SkyQuery& query) {
  const f32::SkyTableFrame& frame = tables.frame;
  const std::optional<AirView> seen =
      view_in_air(query, static_cast<double>(frame.ground_km), static_cast<double>(frame.top_km));
  if (!seen) {
    return {};
  }
  const auto height_km = static_cast<float>(seen->height_km);
  const auto altitude = static_cast<float>(seen->altitude_rad);
  const float share = f32::sky_path_share(height_km, altitude, seen->meets_ground, frame);
  const SkySources sources =
      sky_sources(tables, height_km, altitude, seen->meets_ground, static_cast<float>(seen->light_altitude_rad),
                  static_cast<float>(seen->cos_azimuth));
  const float phase = f32::sky_aerosol_phase(line_sampler(tables.phase), static_cast<float>(seen->cos_angle),
                                             static_cast<int>(tables.phase.size()));
  f32::vec4 sum = share * (sources.other + phase * sources.aerosol);
  if (seen->meets_ground) {
    const f32::vec4 illuminance = f32::sky_ground_illuminance(
        line_sampler(tables.ground), transmittance_sampler(tables), tables.light,
        static_cast<float>(seen->ground_light_rad), static_cast<float>(query.light_angular_radius.to(rad)),
        tables.transmittance_frame, frame);
    const f32::vec4 passed = glm::exp2(f32::sky_ground_view_log2(transmittance_sampler(tables), height_km, altitude,
                                                                 tables.transmittance_frame, frame));
    sum += tables.albedo * illuminance * passed / std::numbers::pi_v<float>;
  }
  return to_xyzs(sum);
}

} // namespace vesper
