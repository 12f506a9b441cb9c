// The few wavelengths that tell what the eye makes of a medium's light.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/spectrum.hpp"

#include <cstddef>
#include <vector>

namespace vesper {

/// Wavelengths, and the weights by which a ratio of radiance to irradiance at them adds up to X, Y, Z and S.
struct SpectralRule {
  std::vector<double> wavelengths_nm; ///< ascending, some of the medium's own
  SpectralWeights weights;            ///< none negative
};

/// The rule for a light above a medium. A medium with no more wavelengths than asked for keeps its own, with
/// `spectral_weights`. Otherwise wavelengths and weights are those that best give X, Y, Z and S, each in relation to
/// itself, of the spectra that such air can make: products of what scatters and the exponentials of what molecules,
/// other matter and absorbers take along paths of 0 to 40 zenith columns. Real skies are sums of these, with positive
/// parts. How well it does stands in docs/SKY_TABLES.md.
/// \param most wavelengths, at least 1
/// Throws Error(argument) for a medium that is not valid at its wavelengths, and for no wavelengths.
[[nodiscard]] SpectralRule spectral_rule(const Medium& medium, const Spectrum& light, std::size_t most);

} // namespace vesper
