#include "vesper/atmosphere/small_sky_tables.hpp"

#include "vesper/atmosphere/level_illuminance.hpp"
#include "vesper/atmosphere/sky_table_parts.hpp"
#include "vesper/base/vector.hpp"

#include <cmath>
#include <cstddef>
#include <memory>

namespace vesper {
namespace {

constexpr int air_levels = 256;
constexpr int multiple_nodes = 32;
constexpr int view_steps = 32;

/// Of a medium with less than four wavelengths the last stay dark.
template <class Value> f32::vec4 by_wavelength(const SpectralAir& optics, const Value& value) {
  f32::vec4 result(0.0F);
  for (std::size_t l = 0; l < optics.size(); ++l) {
    result[static_cast<int>(l)] = static_cast<float>(value(l));
  }
  return result;
}

std::vector<f32::vec4> air_table(const SampledAir& air, const SpectralAir& optics) {
  std::vector<f32::vec4> table(std::size_t{3} * air_levels, f32::vec4(0.0F));
  for (std::size_t i = 0; i < air_levels; ++i) {
    const double place = static_cast<double>(i) / (air_levels - 1);
    const SampledAir::PerComponent density =
        air.density(air.ground_km() + (air.top_km() - air.ground_km()) * place * place);
    table[i] = by_wavelength(optics, [&](std::size_t l) { return optics.optical_depth(density, l); });
    for (std::size_t c = 0; c < air.component_count(); ++c) {
      const std::size_t row = optics.phase_kind(c) == PhaseKind::rayleigh ? 1 : 2;
      table[row * air_levels + i] +=
          by_wavelength(optics, [&](std::size_t l) { return density[c] * optics.scattering_per_km(c, l); });
    }
  }
  return table;
}

/// Of the molecules that scatter most; others of another depolarization are taken for the same.
double depolarization_of(const SampledAir& air, const SpectralAir& optics) {
  const SampledAir::PerComponent density = air.density(air.ground_km());
  double most = 0.0;
  double depolarization = 0.0;
  for (std::size_t c = 0; c < air.component_count(); ++c) {
    const double scattering = density[c] * optics.mean_scattering_per_km(c);
    if (optics.phase_kind(c) == PhaseKind::rayleigh && scattering > most) {
      most = scattering;
      depolarization = optics.phase_parameter(c, optics.size() / 2);
    }
  }
  return depolarization;
}

f32::sampler2D plane(const std::vector<f32::vec4>& texels, int width) {
  return {texels.data(), width, static_cast<int>(texels.size()) / width};
}

SmallSkyTables small_tables(const SunlitAir& sunlit) {
  const SampledAir& air = sunlit.air();
  const SpectralAir& optics = sunlit.optics();
  SmallSkyTables tables;
  tables.frame = {static_cast<float>(air.ground_km()),
                  static_cast<float>(air.top_km()),
                  static_cast<float>(mean_light_radius.to(rad)),
                  static_cast<float>(depolarization_of(air, optics)),
                  air_levels,
                  multiple_nodes,
                  view_steps};
  tables.transmittance_frame = sky_transmittance_nodes;
  tables.wavelengths_nm = optics.wavelengths_nm();
  for (std::size_t l = 0; l < optics.size(); ++l) {
    tables.responses[static_cast<int>(l)] = f32::vec4(sunlit.response(l));
  }
  const f32::vec4 albedo = by_wavelength(optics, [&](std::size_t l) { return optics.albedo(l); });
  tables.air = air_table(air, optics);
  tables.transmittance = transmittance_table(
      air,
      [&](const SampledAir::PerComponent& columns) {
        return log2_of(
            by_wavelength(optics, [&](std::size_t l) { return std::exp(-optics.optical_depth(columns, l)); }),
            sky_darkest_log2);
      },
      1);
  for (int row = 0; row < multiple_nodes; ++row) {
    for (int column = 0; column < multiple_nodes; ++column) {
      tables.multiple.push_back(f32::small_sky_multiple_texel(
          column, row, albedo, plane(tables.air, air_levels),
          plane(tables.transmittance, tables.transmittance_frame.altitudes), tables.transmittance_frame, tables.frame));
    }
  }
  return tables;
}

} // namespace

SkyTables make_small_sky_tables(const Medium& medium) {
  const SunlitAir sunlit(medium, 4);
  SkyTables tables = tables_without_light(sunlit, {}, 1);
  tables.small = std::make_shared<const SmallSkyTables>(small_tables(sunlit));
  for (int i = 0; i < tables.frame.lights; ++i) {
    const Angle light = static_cast<double>(f32::sky_node_light_rad(i, tables.frame)) * rad;
    const Xyzs level = diffuse_illuminance(tables, 0.0 * metre, light);
    tables.ground.push_back(log2_of(f32::vec4(vector_of(level)), sky_darkest_log2));
  }
  return tables;
}

f32::SmallSkyLight small_sky_light(const SmallSkyTables& tables, float height_km, float altitude_rad, bool meets_ground,
                                   float light_altitude_rad, float azimuth_cos) {
  const f32::SmallSkyRay ray = f32::small_sky_ray(height_km, std::sin(altitude_rad), meets_ground, tables.frame);
  const float sin_light = std::sin(light_altitude_rad);
  const float cos_angle =
      ray.sin_altitude * sin_light + std::cos(altitude_rad) * std::cos(light_altitude_rad) * azimuth_cos;
  const f32::SmallSkyLight light =
      f32::small_sky_radiance(ray, sin_light, cos_angle, plane(tables.air, air_levels),
                              plane(tables.transmittance, tables.transmittance_frame.altitudes),
                              plane(tables.multiple, multiple_nodes), tables.transmittance_frame, tables.frame);
  return {tables.responses * light.aerosol, tables.responses * light.other};
}

} // namespace vesper
