// The Earth's light on the Moon.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

inline constexpr Length earth_mean_radius = 6371.0 * kilometre;
inline constexpr double earth_geometric_albedo = 0.434; ///< in V (Mallama and Hilton 2018)

enum class EarthPhaseLaw {
  measured,   ///< of the Earth seen from space
  polynomial, ///< the fit to van de Hulst's sphere in Mueller, Engel and Doellner 2012, eq. 4, with its tint
};

/// The Earth's geometric albedo by wavelength, 300 to 900 nm: 0.434 (0.86 + 0.14 (550 nm / wavelength)^4), clouds with
/// the blue of the air. Sunlight from it has a B-V of 0.45; earthlight was measured as 0.44 +- 0.02 (Thejll et al.
/// 2014, A&A 563, A38). The Earth turns, and its clouds change by some 10 %: this is their mean.
[[nodiscard]] const Spectrum& earth_albedo();

/// Light of the whole Earth at a phase, against that at full phase. Measured: 10^(-0.4 (-1.060e-3 a + 2.054e-4 a^2)), a
/// in degrees (Mallama and Hilton 2018, Astronomy and Computing 25, 10, eq. 5), observed to 170 degrees; at 180, where
/// the air's rim is left, 0.003. Polynomial: within 2 % of it to 30 degrees, 1.6 times as much at 90, 2.2 times at 130,
/// and 0 from 158 degrees, where it turns negative.
/// \param earth_phase Sun-Earth-Moon, 0 to 180 degrees. Throws Error(argument) otherwise.
[[nodiscard]] double earth_phase_light(Angle earth_phase, EarthPhaseLaw law = EarthPhaseLaw::measured);

/// The Earth's spectral irradiance on the Moon as a share of the Sun's on the Earth, by wavelength: 1.19e-4 in V from
/// the full Earth at the mean distance.
/// \param earth_phase Sun-Earth-Moon, 0 to 180 degrees
/// \param distance between the centres, positive
/// Throws Error(argument) for values out of these ranges.
[[nodiscard]] Spectrum earthlight_share(Angle earth_phase, Length distance,
                                        EarthPhaseLaw law = EarthPhaseLaw::measured);

/// The Earth's spectral irradiance on the Moon, W/(m2 nm), 360 to 830 nm.
/// \param from_sun distance of the Earth from the Sun, positive; for the others see earthlight_share
[[nodiscard]] Spectrum earth_irradiance(Angle earth_phase, Length distance, Length from_sun,
                                        EarthPhaseLaw law = EarthPhaseLaw::measured);

/// The phase angle that earthlight has for an observer on the Earth: the Earth is as wide as a lamp of its disc, so it
/// is nowhere 0. For an even disc of that radius the root of mean squares of what is seen at `from_centre` and of 2/3
/// of the radius, within 7 % of the mean angle.
/// \param from_centre angle at the Moon between the observer and the Earth's centre
/// \param radius of the Earth as seen from the Moon
[[nodiscard]] Angle earthlight_phase(Angle from_centre, Angle radius);

} // namespace vesper
