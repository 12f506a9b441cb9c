// What eclipses leave of the light of Sun and Moon.
#pragma once

#include "vesper/astro/lunar_eclipse.hpp"
#include "vesper/astro/solar_eclipse.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

/// The Sun's disc darkens toward its limb as (cosine of the angle to the surface's normal)^a: 0.652 at 440 nm, 0.503 at
/// 550 and 0.397 at 680 (Neckel 1996, Solar Physics 167, 9), linear between them and beyond.
[[nodiscard]] double limb_darkening_power(double wavelength_nm);

/// Share, 0 to 1, of the Sun's light that passes another disc. The angles may be in any one unit.
/// \param sun, other radii, positive \param separation of the centres, >= 0
/// \param power of the limb darkening, 0 (a uniform disc) to 1
[[nodiscard]] double sunlight_seen(double sun, double other, double separation, double power);

/// The Sun's light past the Moon, by wavelength: 1 without an eclipse, 0 in totality, where corona and the light from
/// outside the shadow are left out.
[[nodiscard]] Spectrum sunlight_past_moon(const SolarEclipseState& eclipse);

/// The Sun's light on the Moon's disc past the Earth, by wavelength: the mean over the disc. In the umbra 2e-5 of it is
/// left at 550 nm, as measured of the Moon in mid-eclipse (5e4 times fainter than full on 28 September 2015; years with
/// much volcanic dust are darker, others brighter by two magnitudes), reddened by the fourth power of the wavelength.
[[nodiscard]] Spectrum sunlight_on_moon(const LunarEclipseState& eclipse);

} // namespace vesper
