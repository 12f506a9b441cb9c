// The Sun's light above the atmosphere.
#pragma once

#include "vesper/light/spectrum.hpp"

namespace vesper {

/// Spectral irradiance at 1 au, W/(m2 nm), 360 to 830 nm: ASTM E-490-00a (data/README.md).
[[nodiscard]] const Spectrum& solar_irradiance_1au();

} // namespace vesper
