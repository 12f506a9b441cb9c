// The Moon's light at the Earth, above the atmosphere.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

/// V magnitude of the whole Moon at mean distances (384 400 km, 1 au): -12.73 + 0.026 a + 4e-9 a^4 with the phase angle
/// a in degrees (Krisciunas and Schaefer 1991, PASP 103, 1033, eq. 9). Measured to a = 150 degrees or so.
[[nodiscard]] double moon_v_magnitude(Angle phase_angle);

/// Spectral irradiance, W/(m2 nm), 360 to 830 nm: sunlight times the Moon's albedo, which rises toward the red, at the
/// magnitude of the phase and the distances. No eclipse.
/// \param phase_angle 0 to 180 degrees
[[nodiscard]] Spectrum moon_irradiance(Angle phase_angle, Length from_observer, Length from_sun);

} // namespace vesper
