#include "vesper/light/spectral_weights.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace vesper {
namespace {

/// Of the functions that are linear between the wavelengths and constant beyond them, the one that is 1 at number i and
/// 0 at the others.
double hat(const std::vector<double>& wavelengths_nm, std::size_t i, double nm) {
  const double peak = wavelengths_nm[i];
  if (nm < peak) {
    return i == 0 ? 1.0 : std::max(0.0, (nm - wavelengths_nm[i - 1]) / (peak - wavelengths_nm[i - 1]));
  }
  if (nm > peak) {
    const bool last = i + 1 == wavelengths_nm.size();
    return last ? 1.0 : std::max(0.0, (wavelengths_nm[i + 1] - nm) / (wavelengths_nm[i + 1] - peak));
  }
  return 1.0;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

} // namespace

Xyzs SpectralWeights::operator()(const std::vector<double>& values) const {
  if (values.size() != y.size()) {
    throw Error(ErrorKind::argument,
                std::to_string(values.size()) + " values for weights of " + std::to_string(y.size()) + " wavelengths",
                {"", "", "Give one value for each wavelength"});
  }
  return {dot(x, values), dot(y, values), dot(z, values), dot(s, values)};
}

SpectralWeights spectral_weights(const Spectrum& light, const std::vector<double>& wavelengths_nm) {
  if (wavelengths_nm.empty() || !std::isfinite(wavelengths_nm.front()) || !std::isfinite(wavelengths_nm.back()) ||
      std::adjacent_find(wavelengths_nm.begin(), wavelengths_nm.end(), std::not_fn(std::less<>())) !=
          wavelengths_nm.end()) {
    throw Error(ErrorKind::argument, "wavelengths for spectral weights that are none, not finite or do not increase",
                {"", "", "Give at least one, sorted and without repetitions"});
  }
  std::vector<double> grid;
  std::vector<double> irradiance;
  for (int nm = response_first_nm; nm <= response_last_nm; ++nm) {
    grid.push_back(nm);
    irradiance.push_back(light(nm));
  }
  SpectralWeights weights;
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
    std::vector<double> part = irradiance;
    for (std::size_t k = 0; k < grid.size(); ++k) {
      part[k] *= hat(wavelengths_nm, i, grid[k]);
    }
    const Xyzs weight = integrate_xyzs({grid, std::move(part)});
    weights.x.push_back(weight.x);
    weights.y.push_back(weight.y);
    weights.z.push_back(weight.z);
    weights.s.push_back(weight.s);
  }
  return weights;
}

} // namespace vesper
