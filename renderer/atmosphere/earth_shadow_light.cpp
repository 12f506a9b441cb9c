#include "vesper/atmosphere/earth_shadow_light.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectral_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vesper {
namespace {

/// Where a number lies between others: the one below it, and the share of the way to the next.
struct Between {
  std::size_t low;
  double share;
};

Between between(double place, std::size_t count) {
  const double inside = std::clamp(place, 0.0, static_cast<double>(count - 1));
  const std::size_t low = std::min(static_cast<std::size_t>(inside), count - 2);
  return {low, inside - static_cast<double>(low)};
}

/// Weights of values at 0, 1, 2 .. in the polynomial through them (Lagrange); between the first and the last.
std::array<double, EarthShadowLight::rows> polynomial_weights(double place) {
  std::array<double, EarthShadowLight::rows> weights{};
  const double x = std::clamp(place, 0.0, static_cast<double>(weights.size() - 1));
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights.at(i) = 1.0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      if (k != i) {
        weights.at(i) *= (x - static_cast<double>(k)) / (static_cast<double>(i) - static_cast<double>(k));
      }
    }
  }
  return weights;
}

constexpr int step_nm = 10;

/// Logarithms of the shares of X, Y, Z, S that the places of the map leave of a light.
std::vector<Vec4> log_light(const EclipseSpectra& spectra, const Spectrum& light) {
  const std::size_t count = spectra.wavelengths_nm.size();
  std::vector<double> shares(count);
  const Spectrum all = spectra.spectrum(std::vector<double>(count, 1.0));
  const SpectralWeights weights = spectral_weights(light, all.wavelengths_nm());
  const Xyzs full = weights(all.values());
  std::vector<Vec4> logs;
  for (std::size_t i = 0; i < spectra.log_shares.size(); i += count) {
    std::transform(&spectra.log_shares[i], &spectra.log_shares[i] + count, shares.begin(),
                   [](double value) { return std::exp(value); });
    const Xyzs left = weights(spectra.spectrum(shares).values());
    logs.emplace_back(std::log(left.x / full.x), std::log(left.y / full.y), std::log(left.z / full.z),
                      std::log(left.s / full.s));
  }
  return logs;
}

/// From the axis to full light in all rows, in steps of 4 to 5 km: 2 arcsec.
f64::LunarEclipseFrame picture_frame(const f64::LunarEclipseMap& map, const f64::EarthShadow& shadow) {
  constexpr int columns = 2048;
  const double length_km = (map.rows - 1) / map.rows_per_km;
  const f64::vec2 near_km = f64::lunar_eclipse_radii_km(map.first_km, shadow, map);
  const f64::vec2 far_km = f64::lunar_eclipse_radii_km(map.first_km + length_km, shadow, map);
  const double edge_per_km = (far_km.x - near_km.x) / length_km;
  const double inside_km = std::max(near_km.x, far_km.x);
  const double outside_km = std::max(near_km.y - near_km.x, far_km.y - far_km.x);
  return {f64::lunar_eclipse_table,
          columns,
          map.rows,
          map.first_km,
          map.rows_per_km,
          near_km.x - edge_per_km * map.first_km,
          edge_per_km,
          inside_km,
          (columns - 1) / (inside_km + outside_km)};
}

} // namespace

EclipseSpectra eclipse_spectra(const EarthShadowLight& light, Length moon_along, Length sun_distance, double danjon) {
  if (!(danjon >= least_danjon && danjon <= most_danjon)) {
    throw Error(ErrorKind::argument, fmt::format("a luminosity L of {} on Danjon's scale", danjon),
                {"", "", "Give 0 (very dark) to 4 (very bright)"});
  }
  constexpr std::size_t rows = EarthShadowLight::rows;
  constexpr std::size_t suns = EarthShadowLight::suns;
  const Between load = between(danjon - least_danjon, earth_shadow_loads.size());
  const Between sun = between(
      (sun_distance / astronomical_unit - light.nearest_sun_au) / (light.farthest_sun_au - light.nearest_sun_au), suns);
  EclipseSpectra result{light.frame, sun_distance, light.wavelengths_nm, {}};
  const double moon_km = moon_mean_radius.to(kilometre);
  result.frame.rows = 2;
  result.frame.first_km = moon_along.to(kilometre) - moon_km;
  result.frame.rows_per_km = 0.5 / moon_km;

  const std::size_t size = light.columns() * light.wavelengths_nm.size();
  result.log_shares.resize(2 * size);
  for (std::size_t end = 0; end < 2; ++end) {
    const double along_km = result.frame.first_km + 2.0 * moon_km * static_cast<double>(end);
    const std::array<double, rows> polynomial =
        polynomial_weights((along_km - light.frame.first_km) * light.frame.rows_per_km);
    for (std::size_t part = 0; part < 4 * rows; ++part) {
      const std::size_t brighter = part / (2 * rows);
      const std::size_t farther = part / rows % 2;
      const std::size_t row = part % rows;
      const double weight = (brighter != 0 ? load.share : 1.0 - load.share) *
                            (farther != 0 ? sun.share : 1.0 - sun.share) * polynomial.at(row);
      const std::uint16_t* logs =
          &light.log_shares[(((load.low + brighter) * suns + sun.low + farther) * rows + row) * size];
      for (std::size_t i = 0; i < size; ++i) {
        result.log_shares[end * size + i] -= weight / EarthShadowLight::logs_per_unit * logs[i];
      }
    }
  }
  return result;
}

void EclipseSpectra::add(const Vec2& place_km, const f64::EarthShadow& shadow, double weight,
                         std::span<double> shares) const {
  const std::size_t count = wavelengths_nm.size();
  const auto columns = static_cast<std::size_t>(frame.inner + frame.outer) + 1;
  const f64::vec2 texel = f64::lunar_eclipse_texel(place_km, shadow, frame);
  const Between column = between(texel.x, columns);
  const Between row = between(texel.y, static_cast<std::size_t>(frame.rows));
  if (place_km.y <= 0.0 || texel.x >= static_cast<double>(columns - 1)) {
    for (double& share : shares) {
      share += weight;
    }
    return;
  }
  const double* low = &log_shares[(row.low * columns + column.low) * count];
  const double* high = low + columns * count;
  for (std::size_t i = 0; i < count; ++i) {
    const double nearer = low[i] + column.share * (low[i + count] - low[i]);
    const double farther = high[i] + column.share * (high[i + count] - high[i]);
    shares[i] += weight * std::exp(nearer + row.share * (farther - nearer));
  }
}

Spectrum EclipseSpectra::spectrum(std::span<const double> shares) const {
  if (wavelengths_nm.size() == 1) {
    return {{response_first_nm - step_nm, response_last_nm + step_nm}, {shares[0], shares[0]}};
  }
  // Along deep paths molecules make the steepest slopes.
  const auto molecules = [](double nm) { return std::pow(nm, -4.0); };
  std::vector<double> wavelengths;
  std::vector<double> values;
  std::size_t i = 0;
  for (int nm = response_first_nm - step_nm; nm <= response_last_nm + step_nm; nm += step_nm) {
    while (i + 2 < wavelengths_nm.size() && wavelengths_nm[i + 1] < nm) {
      ++i;
    }
    const double low = molecules(wavelengths_nm[i]);
    const double t = std::clamp((molecules(nm) - low) / (molecules(wavelengths_nm[i + 1]) - low), 0.0, 1.0);
    wavelengths.push_back(nm);
    values.push_back(std::pow(shares[i], 1.0 - t) * std::pow(shares[i + 1], t));
  }
  return {std::move(wavelengths), std::move(values)};
}

LunarEclipseTable lunar_eclipse_table(const EclipseSpectra& spectra, const Spectrum& moonlight) {
  const std::vector<Vec4> logs = log_light(spectra, moonlight);
  const std::size_t columns = logs.size() / static_cast<std::size_t>(spectra.frame.rows);
  const f64::EarthShadow shadow{Vec3(0.0, 0.0, 1.0), spectra.sun_distance.to(kilometre), sun_radius.to(kilometre), 0.0};
  LunarEclipseTable table{picture_frame(spectra.frame, shadow), {}};
  const f64::LunarEclipseFrame& frame = table.frame;
  table.texels.reserve(static_cast<std::size_t>(frame.rows) * static_cast<std::size_t>(frame.columns));
  for (int row = 0; row < frame.rows; ++row) {
    const double along_km = frame.first_km + row / frame.rows_per_km;
    const double first_km = frame.edge_km + frame.edge_per_km * along_km - frame.inside_km;
    const Vec4* of_row = &logs[static_cast<std::size_t>(row) * columns];
    for (int column = 0; column < frame.columns; ++column) {
      const Vec2 place_km(std::abs(first_km + column / frame.columns_per_km), along_km);
      const Between at = between(f64::lunar_eclipse_texel(place_km, shadow, spectra.frame).x, columns);
      table.texels.push_back(glm::exp(glm::mix(of_row[at.low], of_row[at.low + 1], at.share)));
    }
    table.texels.back() = Vec4(1.0);
  }
  return table;
}

} // namespace vesper
