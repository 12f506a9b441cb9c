// The Moon's light at the Earth, above the atmosphere.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

inline constexpr Length moon_mean_distance = 384400.0 * kilometre;

/// V magnitude of the whole Moon at mean distances (moon_mean_distance, 1 au), lit by the Sun alone:
/// -12.73 + 0.026 a + 4e-9 a^4 with the phase angle a in degrees (Allen 1973, Astrophysical Quantities, as in
/// Krisciunas and Schaefer 1991, PASP 103, 1033), brighter by the opposition surge 0.31 exp(-a / 2.5), whose sources
/// stand in shaders/lib/moon_surface.glsl: -13.04 at 0 degrees, where the Earth's shadow lies, and -12.86 at 1.5,
/// beside it. From 7 to 90 degrees it lies within 0.08 mag of the lunar irradiance model of Kieffer and Stone 2005.
/// Beyond 150 degrees, the end of the measurements, a sphere darkens with its surface's law unchanged: +infinity at
/// 180.
/// \param phase_angle 0 to 180 degrees. Throws Error(argument) otherwise.
[[nodiscard]] double moon_v_magnitude(Angle phase_angle);

/// The albedo of the Moon's near side, 350 to 850 nm, to a scale: the mean of Velikodsky et al. 2011 (Icarus 214, 30,
/// table 2) times (wavelength / 550 nm)^s, by which the Moon reddens with its phase: s = 0.20 - 0.15 exp(-a / 42 deg).
/// B-V is 0.91 at full Moon and 0.94 at the quarters. It was measured as 0.92 (Harris 1961, in Allen 1973) and 0.94
/// (Gallouet 1963) for the Moon, 0.85 (Lane and Irvine 1973) and 0.86 (van den Bergh 1962) for places on it near full;
/// the lunar irradiance model of Kieffer and Stone 2005 (AJ 129, 2887) reddens from 0.84 at 0 to 0.93 at 90 degrees.
/// This law keeps to the first at full Moon, and to that model at the quarters.
/// \param phase_angle 0 to 180 degrees. Throws Error(argument) otherwise.
[[nodiscard]] Spectrum moon_albedo(Angle phase_angle);

/// Spectral irradiance, W/(m2 nm), 360 to 830 nm: sunlight times the Moon's albedo, scaled in the V band to the
/// magnitude of the phase and the distances. No eclipse, no earthshine.
/// \param phase_angle 0 to 180 degrees
/// \param from_observer distance of the Moon's centre, positive
/// \param from_sun distance of the Moon's centre, positive
/// Throws Error(argument) for values out of these ranges.
[[nodiscard]] Spectrum moon_irradiance(Angle phase_angle, Length from_observer, Length from_sun);

} // namespace vesper
