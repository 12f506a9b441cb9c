// The Sun's light above the atmosphere.
#pragma once

#include "vesper/light/spectrum.hpp"

namespace vesper {

/// Spectral irradiance at 1 au, W/(m2 nm), 360 to 830 nm (the first sample lies at 359.5): ASTM E-490-00a
/// (data/README.md), 133.3 klx. The whole of it holds 1366.1 W/m2; the solar constant is known as 1361 W/m2 today
/// (Kopp and Lean 2011, GRL 38, L01706).
[[nodiscard]] const Spectrum& solar_irradiance_1au();

} // namespace vesper
