// From the light of one source to that of another, behind the same air.
#pragma once

#include "vesper/base/vector.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

/// Turns X, Y, Z and S of what air or ground make of a light (1 lux of it) into those of what they would make of 1 lux
/// of another light: the matrix that does so best, in the sense of least squares of each in relation to itself, for
/// spectra that rise or fall with powers of the wavelength. How well it does stands in docs/ACCURACY.md, spectral rule.
/// Throws Error(argument) for a light that is dark in one of the four.
[[nodiscard]] Mat4 response_matrix(const Spectrum& from, const Spectrum& to);

} // namespace vesper
