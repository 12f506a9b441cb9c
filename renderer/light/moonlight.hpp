// The Moon's light at the Earth, above the atmosphere.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

inline constexpr Length moon_mean_distance = 384400.0 * kilometre;

/// V magnitude of the whole Moon at mean distances (moon_mean_distance, 1 au): -12.73 + 0.026 a + 4e-9 a^4 with the
/// phase angle a in degrees (Allen 1973, Astrophysical Quantities, as in Krisciunas and Schaefer 1991, PASP 103, 1033).
/// Measured to a = 150 degrees or so; at 180, where the Moon is dark, it still gives -3.9. The opposition surge is not
/// in it. From 7 to 90 degrees it lies within 0.08 mag of the lunar irradiance model of Kieffer and Stone 2005. \param
/// phase_angle 0 to 180 degrees. Throws Error(argument) otherwise.
[[nodiscard]] double moon_v_magnitude(Angle phase_angle);

/// The albedo of the Moon's near side, 350 to 850 nm, to a scale: the mean of Velikodsky et al. 2011 (Icarus 214, 30,
/// table 2) times (wavelength / 550 nm)^s, by which the Moon reddens with its phase: s = 0.25 - 0.42 exp(-a / 42 deg),
/// fitted to the lunar irradiance model of Kieffer and Stone 2005 (AJ 129, 2887) from 2 to 110 degrees. B-V is 0.86 at
/// full Moon and 0.94 at the quarters, and measured as 0.85 to 0.94.
/// \param phase_angle 0 to 180 degrees. Throws Error(argument) otherwise.
[[nodiscard]] Spectrum moon_albedo(Angle phase_angle);

/// Spectral irradiance, W/(m2 nm), 360 to 830 nm: sunlight times the Moon's albedo, scaled in the V band to the
/// magnitude of the phase and the distances. No eclipse.
/// \param phase_angle 0 to 180 degrees
/// \param from_observer distance of the Moon's centre, positive
/// \param from_sun distance of the Moon's centre, positive
/// Throws Error(argument) for values out of these ranges.
[[nodiscard]] Spectrum moon_irradiance(Angle phase_angle, Length from_observer, Length from_sun);

} // namespace vesper
