#include "vesper/atmosphere/sky_table_parts.hpp"

#include "vesper/base/worker_pool.hpp"
#include "vesper/light/sunlight.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace vesper {

namespace {

/// The phase function near 550 nm for sky_aerosol_phase: the mean over what is no molecule, weighted by what each
/// component scatters from the ground to space.
std::vector<f32::vec4> aerosol_phase_table(const SampledAir& air, const SpectralAir& optics) {
  const std::vector<double>& wavelengths = optics.wavelengths_nm();
  const auto green = static_cast<std::size_t>(
      std::min_element(wavelengths.begin(), wavelengths.end(),
                       [](double a, double b) { return std::abs(a - 550.0) < std::abs(b - 550.0); }) -
      wavelengths.begin());
  const SampledAir::PerComponent columns =
      air.columns_to_space(air.ray(air.ground_km(), 1.0), [](const auto&) { return false; });
  std::vector<f32::vec4> table;
  for (int i = 0; i < sky_phase_nodes; ++i) {
    const double place = static_cast<double>(i) / (sky_phase_nodes - 1);
    double sum = 0.0;
    double all = 0.0;
    for (std::size_t c = 0; c < air.component_count(); ++c) {
      if (optics.phase_kind(c) != PhaseKind::rayleigh) {
        const double scattering = columns[c] * optics.scattering_per_km(c, green);
        sum += scattering * optics.phase(c, green, std::cos(std::numbers::pi * place * place));
        all += scattering;
      }
    }
    // Without aerosol any will do.
    const double phase = all > 0.0 ? sum / all : 0.25 / std::numbers::pi;
    table.emplace_back(static_cast<float>(std::log2(phase)), 0.0F, 0.0F, 0.0F);
  }
  return table;
}

/// A table by height and direction. \param texel from the height in km and the column, called from several threads
std::vector<f32::vec4> table_by_height(const SampledAir& air, unsigned threads,
                                       const std::function<f32::vec4(double, int)>& texel) {
  constexpr auto columns = static_cast<std::size_t>(sky_transmittance_nodes.altitudes);
  constexpr auto rows = static_cast<std::size_t>(sky_transmittance_nodes.heights);
  std::vector<f32::vec4> table(columns * rows);
  parallel_for(
      rows, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
          const double share = static_cast<double>(row) / static_cast<double>(rows - 1);
          for (std::size_t column = 0; column < columns; ++column) {
            table[row * columns + column] =
                texel((air.top_km() - air.ground_km()) * share * share, static_cast<int>(column));
          }
        }
      },
      threads);
  return table;
}

double dip_rad(double height_km, double ground_km) {
  return std::atan2(std::sqrt(height_km * (2.0 * ground_km + height_km)), ground_km);
}

/// The table of sky_ground_view_log2: the same texels of the air between an observer and the ground, over the way in
/// km.
std::vector<f32::vec4> ground_view_table(const SampledAir& air,
                                         const std::function<f32::vec4(const SampledAir::PerComponent&)>& texel,
                                         unsigned threads) {
  return table_by_height(air, threads, [&](double height, int column) {
    // At the ground itself the way has no length.
    constexpr double least_km = 1.0e-3;
    const double height_km = std::max(height, least_km);
    const double dip = dip_rad(height_km, air.ground_km());
    const auto altitude =
        static_cast<double>(f32::sky_ground_view_node_rad(column, static_cast<float>(dip), sky_transmittance_nodes));
    // The horizon itself counts as ground.
    constexpr double aside_rad = 2.0e-6;
    const AirRay ray = air.ray(air.ground_km() + height_km, std::sin(std::min(altitude, -dip - aside_rad)));
    SampledAir::PerComponent sum{};
    air.for_each_cell(ray, SampledAir::longest_cell_km, [&](double from, double to) {
      air.add_columns(ray, from, to, sum);
      return true;
    });
    return texel(sum) / static_cast<float>(ray.end_km - ray.begin_km);
  });
}

} // namespace

SunlitAir::SunlitAir(const Medium& medium, std::size_t most_wavelengths)
    : rule_(spectral_rule(medium, solar_irradiance_1au(), most_wavelengths)), air_(medium),
      optics_(medium, rule_.wavelengths_nm) {
  const SpectralWeights& weights = rule_.weights;
  const double all = std::accumulate(weights.y.begin(), weights.y.end(), 0.0);
  for (std::size_t l = 0; l < optics_.size(); ++l) {
    weights_.push_back(Vec4(weights.x[l], weights.y[l], weights.z[l], weights.s[l]) / all);
  }
}

std::vector<f32::vec4> transmittance_table(const SampledAir& air,
                                           const std::function<f32::vec4(const SampledAir::PerComponent&)>& texel,
                                           unsigned threads) {
  return table_by_height(air, threads, [&](double height_km, int column) {
    const double radius_km = air.ground_km() + height_km;
    const auto dip = static_cast<float>(dip_rad(height_km, air.ground_km()));
    const auto altitude = static_cast<double>(f32::sky_transmittance_node_rad(column, dip, sky_transmittance_nodes));
    // The horizon itself counts as free of the ground.
    constexpr double aside_rad = 2.0e-5;
    AirRay ray = air.ray(radius_km, std::sin(altitude));
    if (ray.meets_ground) {
      ray = air.ray(radius_km, std::sin(altitude + aside_rad));
    }
    return texel(air.columns_to_space(ray, [](const auto&) { return false; }));
  });
}

SkyTables tables_without_light(const SunlitAir& sunlit, const SkyTableSize& size, unsigned threads) {
  const SampledAir& air = sunlit.air();
  const SpectralAir& optics = sunlit.optics();
  std::vector<double> ones(optics.size(), 1.0);
  std::vector<double> albedo;
  for (std::size_t l = 0; l < optics.size(); ++l) {
    albedo.push_back(optics.albedo(l));
  }
  SkyTables tables;
  tables.frame = {static_cast<float>(air.ground_km()),
                  static_cast<float>(air.top_km()),
                  size.heights,
                  size.views_below,
                  size.views_above,
                  size.lights};
  tables.light = sunlit.responses(ones);
  tables.albedo = sunlit.responses(albedo) / tables.light;
  tables.phase = aerosol_phase_table(air, optics);
  const auto texel = [&](const SampledAir::PerComponent& columns) {
    std::vector<double> left(optics.size());
    for (std::size_t l = 0; l < optics.size(); ++l) {
      left[l] = std::exp(-optics.optical_depth(columns, l));
    }
    return log2_of(sunlit.responses(left) / tables.light, sky_darkest_log2);
  };
  tables.transmittance_frame = sky_transmittance_nodes;
  tables.transmittance = transmittance_table(air, texel, threads);
  const std::vector<f32::vec4> from_ground = ground_view_table(air, texel, threads);
  tables.transmittance.insert(tables.transmittance.end(), from_ground.begin(), from_ground.end());
  return tables;
}

f32::vec4 log2_of(const f32::vec4& light, float least_log2) {
  f32::vec4 result;
  for (int i = 0; i < 4; ++i) {
    result[i] = light[i] > 0.0F ? std::max(std::log2(light[i]), least_log2) : least_log2;
  }
  return result;
}

} // namespace vesper
