// From a few wavelengths to X, Y, Z and S: sums in place of integrals.
#pragma once

#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectrum.hpp"

#include <vector>

namespace vesper {

/// Weights for a quantity r that is known at some wavelengths and linear between them, constant beyond the outermost:
/// sum of x[i] r[i] is the integral over 360 to 830 nm of r times the light times the response of X (683 lm/W and the
/// same grid as integrate_xyzs), and so on. For r a ratio of radiance to irradiance and the light an irradiance in
/// W/(m2 nm) the sums are cd/m2.
struct SpectralWeights {
  std::vector<double> x, y, z, s;

  /// The sums. Throws Error(argument) unless there is one value for each wavelength.
  [[nodiscard]] Xyzs operator()(const std::vector<double>& values) const;
};

/// \param wavelengths_nm ascending, finite, at least one; they may lie outside 360 to 830 nm. Throws Error(argument)
/// otherwise.
[[nodiscard]] SpectralWeights spectral_weights(const Spectrum& light, const std::vector<double>& wavelengths_nm);

} // namespace vesper
