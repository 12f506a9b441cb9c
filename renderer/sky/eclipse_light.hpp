// What eclipses leave of the light of Sun and Moon.
#pragma once

#include "vesper/astro/lunar_eclipse.hpp"
#include "vesper/astro/solar_eclipse.hpp"
#include "vesper/light/solar_disc.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

/// Share, 0 to 1, of the Sun's light that passes another disc. The angles may be in any one unit.
/// \param sun, other radii, positive \param separation of the centres, >= 0
/// \param power of the limb darkening, 0 (a uniform disc) to 1
[[nodiscard]] double sunlight_seen(double sun, double other, double separation, double power);

/// The Sun's light past the Moon, by wavelength, over that of the Sun's disc: 1 without an eclipse, and redder the
/// thinner the crescent. The corona's, 1.4e-6 at most, is in it, so that it never ends; light from outside the shadow
/// is not.
[[nodiscard]] Spectrum sunlight_past_moon(const SolarEclipseState& eclipse,
                                          LimbDarkening law = LimbDarkening::hestroffer_magnan);

/// The Sun's light on the Moon's disc past the Earth, by wavelength: the mean over the disc. In the umbra 2e-5 of it is
/// left at 550 nm, as measured of the Moon in mid-eclipse (5e4 times fainter than full on 28 September 2015; years with
/// much volcanic dust are darker, others brighter by two magnitudes), reddened by the fourth power of the wavelength.
[[nodiscard]] Spectrum sunlight_on_moon(const LunarEclipseState& eclipse);

} // namespace vesper
