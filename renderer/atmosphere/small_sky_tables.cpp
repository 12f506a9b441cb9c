#include "vesper/atmosphere/small_sky_tables.hpp"

#include "vesper/atmosphere/air_view.hpp"
#include "vesper/atmosphere/sky_table_parts.hpp"
#include "vesper/atmosphere/spectral_rule.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/light/sunlight.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

namespace vesper {
namespace {

constexpr int air_levels = 256;
constexpr int multiple_nodes = 32;
constexpr int view_steps = 32;
constexpr float darkest_log2 = -100.0F;

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

f32::mat4 responses_of(const SpectralWeights& weights) {
  const double lux = std::accumulate(weights.y.begin(), weights.y.end(), 0.0);
  f32::mat4 responses(0.0F);
  for (std::size_t l = 0; l < weights.y.size(); ++l) {
    const Vec4 column = Vec4(weights.x[l], weights.y[l], weights.z[l], weights.s[l]) / lux;
    responses[static_cast<int>(l)] = f32::vec4(column);
  }
  return responses;
}

f32::sampler2D plane(const std::vector<f32::vec4>& texels, int width) {
  return {texels.data(), width, static_cast<int>(texels.size()) / width};
}

} // namespace

SmallSkyTables make_small_sky_tables(const Medium& medium) {
  const SampledAir air(medium);
  const SpectralRule rule = spectral_rule(medium, solar_irradiance_1au(), 4);
  const SpectralAir optics(medium, rule.wavelengths_nm);
  SmallSkyTables tables;
  tables.wavelengths_nm = rule.wavelengths_nm;
  tables.frame = {static_cast<float>(air.ground_km()),
                  static_cast<float>(air.top_km()),
                  static_cast<float>(mean_light_radius.to(rad)),
                  static_cast<float>(depolarization_of(air, optics)),
                  air_levels,
                  multiple_nodes,
                  sky_phase_nodes,
                  view_steps};
  tables.transmittance_frame = sky_transmittance_nodes;
  tables.responses = responses_of(rule.weights);
  tables.albedo = by_wavelength(optics, [&](std::size_t l) { return optics.albedo(l); });
  tables.air = air_table(air, optics);
  tables.phase = aerosol_phase_table(air, optics);
  tables.transmittance = transmittance_table(
      air,
      [&](const SampledAir::PerComponent& columns) {
        return log2_of(
            by_wavelength(optics, [&](std::size_t l) { return std::exp(-optics.optical_depth(columns, l)); }),
            darkest_log2);
      },
      1);
  for (int row = 0; row < multiple_nodes; ++row) {
    for (int column = 0; column < multiple_nodes; ++column) {
      tables.multiple.push_back(f32::small_sky_multiple_texel(
          column, row, tables.albedo, plane(tables.air, air_levels),
          plane(tables.transmittance, tables.transmittance_frame.altitudes), tables.transmittance_frame, tables.frame));
    }
  }
  return tables;
}

Xyzs sky_luminance(const SmallSkyTables& tables, const SkyQuery& query) {
  const std::optional<AirView> seen =
      view_in_air(query, static_cast<double>(tables.frame.ground_km), static_cast<double>(tables.frame.top_km));
  if (!seen) {
    return {};
  }
  const f32::SmallSkyRay ray =
      f32::small_sky_ray(static_cast<float>(seen->height_km), static_cast<float>(std::sin(seen->altitude_rad)),
                         seen->meets_ground, tables.frame);
  const auto cos_angle = static_cast<float>(seen->cos_angle);
  const f32::SmallSkyLight light = f32::small_sky_radiance(
      ray, static_cast<float>(std::sin(seen->light_altitude_rad)), cos_angle, plane(tables.air, air_levels),
      plane(tables.transmittance, tables.transmittance_frame.altitudes), plane(tables.multiple, multiple_nodes),
      tables.transmittance_frame, tables.frame);
  const float phase = f32::sky_aerosol_phase({tables.phase.data(), sky_phase_nodes}, cos_angle, sky_phase_nodes);
  const f32::vec4 sum = tables.responses * (light.other + phase * light.aerosol);
  return {static_cast<double>(sum.x), static_cast<double>(sum.y), static_cast<double>(sum.z),
          static_cast<double>(sum.w)};
}

} // namespace vesper
