// Sunlight that a body has reflected.
#pragma once

#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

struct ReflectedLight {
  Xyzs color;             ///< for an illuminance of 1 lux (y = 1)
  double lux_ratio = 1.0; ///< lux per V-band flux over that of an A0 star, as star_lux_ratio
};

/// The Sun's light (solar_irradiance_1au) times an albedo, which may lack a scale.
/// Throws Error(argument) for an albedo that is dark in the V band.
[[nodiscard]] ReflectedLight reflected_sunlight(const Spectrum& albedo);

} // namespace vesper
