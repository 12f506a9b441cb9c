#include "vesper/light/spectrum.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace vesper {

Spectrum::Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values)
    : wavelengths_nm_(std::move(wavelengths_nm)), values_(std::move(values)) {
  if (wavelengths_nm_.size() < 2 || wavelengths_nm_.size() != values_.size()) {
    throw Error(ErrorKind::argument,
                "a spectrum of " + std::to_string(wavelengths_nm_.size()) + " wavelengths and " +
                    std::to_string(values_.size()) + " values",
                {"", "", "Give at least two wavelengths and one value for each"});
  }
  if (std::adjacent_find(wavelengths_nm_.begin(), wavelengths_nm_.end(), std::not_fn(std::less<>())) !=
      wavelengths_nm_.end()) {
    throw Error(ErrorKind::argument, "the wavelengths of a spectrum do not increase",
                {"", "", "Sort them and remove repetitions"});
  }
}

double Spectrum::operator()(double wavelength_nm) const {
  if (!(wavelength_nm >= wavelengths_nm_.front() && wavelength_nm <= wavelengths_nm_.back())) {
    return 0.0;
  }
  const auto after = std::upper_bound(wavelengths_nm_.begin() + 1, wavelengths_nm_.end() - 1, wavelength_nm);
  const auto i = static_cast<std::size_t>(after - wavelengths_nm_.begin());
  const double t = (wavelength_nm - wavelengths_nm_[i - 1]) / (wavelengths_nm_[i] - wavelengths_nm_[i - 1]);
  return values_[i - 1] + t * (values_[i] - values_[i - 1]);
}

Spectrum filtered(const Spectrum& light, const Spectrum& filter) {
  std::vector<double> values = light.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] *= filter(light.wavelengths_nm()[i]);
  }
  return {light.wavelengths_nm(), std::move(values)};
}

Spectrum scaled(const Spectrum& spectrum, double factor) {
  std::vector<double> values = spectrum.values();
  for (double& value : values) {
    value *= factor;
  }
  return {spectrum.wavelengths_nm(), std::move(values)};
}

Spectrum added(const Spectrum& first, const Spectrum& second) {
  std::vector<double> values = first.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] += second(first.wavelengths_nm()[i]);
  }
  return {first.wavelengths_nm(), std::move(values)};
}

double planck_w_m2_sr_nm(double wavelength_nm, double temperature_k) {
  constexpr double h = 6.62607015e-34;
  constexpr double c = 299792458.0;
  constexpr double k = 1.380649e-23;
  const double wavelength_m = wavelength_nm * 1e-9;
  const double square = wavelength_m * wavelength_m;
  return 2e-9 * h * c * c / (square * square * wavelength_m) / std::expm1(h * c / (wavelength_m * k * temperature_k));
}

Spectrum planck_spectrum(double temperature_k) {
  if (!(temperature_k > 0.0) || !std::isfinite(temperature_k)) {
    throw Error(ErrorKind::argument, "a black body of " + std::to_string(temperature_k) + " K",
                {"", "", "Give a positive temperature"});
  }
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (int nm = 360; nm <= 830; ++nm) {
    wavelengths.push_back(nm);
    values.push_back(planck_w_m2_sr_nm(nm, temperature_k));
  }
  return {std::move(wavelengths), std::move(values)};
}

} // namespace vesper
