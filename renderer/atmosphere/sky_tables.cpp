#include "vesper/atmosphere/sky_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesper {

f32::sampler3D sampler(const SkyTables& tables, const std::vector<f32::vec4>& scattering) {
  const f32::SkyTableFrame& frame = tables.frame;
  return {scattering.data(), frame.lights * f32::sky_azimuths, frame.views_below + frame.views_above, frame.heights};
}

f32::sampler2D transmittance_sampler(const SkyTables& tables) {
  return {tables.transmittance.data(), tables.transmittance_frame.altitudes, tables.transmittance_frame.heights};
}

f32::sampler1D line_sampler(const std::vector<f32::vec4>& texels) {
  return {texels.data(), static_cast<int>(texels.size())};
}

namespace {

/// Where a ray from outside enters the air; false if it passes by.
bool enter(Vec3& place_km, const Vec3& view, double top_km) {
  const double along = glm::dot(place_km, view);
  const double outside = (glm::length(place_km) - top_km) * (glm::length(place_km) + top_km);
  const double under_root = along * along - outside;
  if (along >= 0.0 || under_root <= 0.0) {
    return false;
  }
  place_km += view * (outside / (-along + std::sqrt(under_root)));
  return true;
}

} // namespace

Xyzs sky_luminance(const SkyTables& tables, const SkyQuery& query) {
  validate(query);
  const f32::SkyTableFrame& frame = tables.frame;
  const auto ground_km = static_cast<double>(frame.ground_km);
  const double top_km = static_cast<double>(frame.top_km);
  Vec3 place{0.0, 0.0, ground_km + query.height.to(kilometre)};
  const Vec3& view = query.view_direction;
  if (place.z > top_km && !enter(place, view, top_km)) {
    return {};
  }
  const Vec3 up = glm::normalize(place);
  const double view_z = glm::dot(view, up);
  const double light_z = glm::dot(query.light_direction, up);
  const Vec3 view_level = view - view_z * up;
  const Vec3 light_level = query.light_direction - light_z * up;
  const double level = glm::length(view_level) * glm::length(light_level);
  const auto cos_azimuth =
      static_cast<float>(level > 1.0e-9 ? std::clamp(glm::dot(view_level, light_level) / level, -1.0, 1.0) : 1.0);
  const auto altitude = static_cast<float>(std::atan2(view_z, glm::length(view_level)));
  const auto light_altitude = static_cast<float>(std::atan2(light_z, glm::length(light_level)));
  const double height = std::clamp(glm::length(place) - ground_km, 0.0, top_km - ground_km);
  const auto height_km = static_cast<float>(height);
  const float dip = f32::sky_dip(height_km, frame);
  const bool meets_ground = altitude < -dip;

  const f32::SkyViewPlace row = f32::sky_view_place(altitude, dip, meets_ground, frame);
  const float share = f32::sky_path_share(height_km, altitude, meets_ground, frame);
  const f32::vec4 other =
      glm::exp2(f32::sky_table_log2(sampler(tables, tables.other), height_km, row, light_altitude, cos_azimuth, frame));
  const f32::vec4 aerosol = glm::exp2(
      f32::sky_table_log2(sampler(tables, tables.aerosol), height_km, row, light_altitude, cos_azimuth, frame));
  const float phase =
      f32::sky_aerosol_phase(line_sampler(tables.phase), static_cast<float>(glm::dot(view, query.light_direction)),
                             static_cast<int>(tables.phase.size()));
  f32::vec4 sum = share * (other + phase * aerosol);
  if (meets_ground) {
    const double rise = glm::dot(place, view);
    const double root = std::sqrt(std::max(0.0, rise * rise - height * (2.0 * ground_km + height)));
    const Vec3 ground_up = glm::normalize(place + view * (height * (2.0 * ground_km + height) / (root - rise)));
    const double ground_light = std::asin(std::clamp(glm::dot(ground_up, query.light_direction), -1.0, 1.0));
    const f32::vec4 illuminance = f32::sky_ground_illuminance(
        line_sampler(tables.ground), transmittance_sampler(tables), tables.light, static_cast<float>(ground_light),
        static_cast<float>(query.light_angular_radius.to(rad)), tables.transmittance_frame, frame);
    const f32::vec4 passed = glm::exp2(f32::sky_ground_view_log2(transmittance_sampler(tables), height_km, altitude,
                                                                 tables.transmittance_frame, frame));
    sum += tables.albedo * illuminance * passed / std::numbers::pi_v<float>;
  }
  return {static_cast<double>(sum.x), static_cast<double>(sum.y), static_cast<double>(sum.z),
          static_cast<double>(sum.w)};
}

} // namespace vesper
