// V magnitudes and lux.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

/// Illuminance above the atmosphere of an A0 star (B-V = 0) of V = 0; the source stands beside the constant.
inline constexpr Illuminance v0_a0_illuminance = f64::zero_magnitude_lux * lux;

/// Lux per unit of V-band flux: the photopic integral of the spectrum over its integral through the V band, lm/W. The
/// eye and the V band are not the same, so stars of one V magnitude differ in lux with their colour.
/// Throws Error(argument) for a spectrum that is dark in the V band.
[[nodiscard]] double lux_per_v_flux(const Spectrum& spectrum);

/// Illuminance of a source of magnitude V, and back. `lux_ratio` is its lux_per_v_flux over that of an A0 star:
/// star_lux_ratio(b_v) for stars. The magnitude of a source without light is +infinity.
[[nodiscard]] Illuminance illuminance_of_v(double v_magnitude, double lux_ratio);
[[nodiscard]] double v_of_illuminance(Illuminance illuminance, double lux_ratio);

/// The V magnitude of a spectral irradiance in W/(m2 nm), through the V band; +infinity without light.
[[nodiscard]] double v_magnitude(const Spectrum& irradiance);

} // namespace vesper
