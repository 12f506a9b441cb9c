// Functions of wavelength: sampled spectra and Planck's law.
#pragma once

#include <vector>

namespace vesper {

/// A function of wavelength, linear between its samples and zero outside them.
class Spectrum {
public:
  /// `wavelengths_nm` strictly increasing, at least two, one value each. Throws Error(argument) otherwise.
  Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values);

  /// The value at a wavelength; 0 outside the samples.
  [[nodiscard]] double operator()(double wavelength_nm) const;

  [[nodiscard]] const std::vector<double>& wavelengths_nm() const { return wavelengths_nm_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

private:
  std::vector<double> wavelengths_nm_;
  std::vector<double> values_;
};

/// Light through a filter, or from a surface with an albedo: their product at the light's wavelengths.
[[nodiscard]] Spectrum filtered(const Spectrum& light, const Spectrum& filter);

/// A spectrum times a number.
[[nodiscard]] Spectrum scaled(const Spectrum& spectrum, double factor);

/// The sum of two spectra at the first one's wavelengths.
[[nodiscard]] Spectrum added(const Spectrum& first, const Spectrum& second);

/// Planck's law: spectral radiance of a black body, W/(m2 sr nm), for a wavelength in nm and a temperature in K, both
/// positive (constants CODATA 2018, exact).
[[nodiscard]] double planck_w_m2_sr_nm(double wavelength_nm, double temperature_k);

/// A black body sampled every nanometre from 360 to 830 nm, the range of the response functions.
/// Throws Error(argument) unless the temperature is positive and finite.
[[nodiscard]] Spectrum planck_spectrum(double temperature_k);

} // namespace vesper
