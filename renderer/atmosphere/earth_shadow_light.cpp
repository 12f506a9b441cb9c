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
  EclipseSpectra result{light.frame, light.wavelengths_nm, {}};
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
  LunarEclipseTable table{spectra.frame, {}};
  const std::size_t count = spectra.wavelengths_nm.size();
  std::vector<double> shares(count);
  const Spectrum all = spectra.spectrum(std::vector<double>(count, 1.0));
  const SpectralWeights weights = spectral_weights(moonlight, all.wavelengths_nm());
  const Xyzs full = weights(all.values());
  for (std::size_t i = 0; i < spectra.log_shares.size(); i += count) {
    std::transform(&spectra.log_shares[i], &spectra.log_shares[i] + count, shares.begin(),
                   [](double value) { return std::exp(value); });
    const Xyzs left = weights(spectra.spectrum(shares).values());
    table.texels.emplace_back(std::log(left.x / full.x), std::log(left.y / full.y), std::log(left.z / full.z),
                              std::log(left.s / full.s));
  }
  return table;
}

} // namespace vesper
