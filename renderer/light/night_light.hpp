// Spectra and units of the light of a dark night.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

/// Luminance of a surface of which every square arcsecond gives as much V as a star of magnitude `v`, and back.
/// \param lux_ratio of its light, as in photometry.hpp: 1 for an A0 star's, with which V = 22 is 1.71e-4 cd/m2
[[nodiscard]] Luminance luminance_of_v_per_arcsec2(double v, double lux_ratio = 1.0);
[[nodiscard]] double v_per_arcsec2(Luminance luminance, double lux_ratio = 1.0);

/// The unit that tables of the night sky count in, S10(V): a star of V = 10 in a square degree, 27.78 mag/arcsec2.
inline constexpr double s10_v_per_arcsec2 = 27.7815;

/// X, Y, Z and S of 1 S10(V) of light with this spectrum, cd/m2. Throws Error(argument) for light without any in V.
[[nodiscard]] Vec4 xyzs_of_s10(const Spectrum& spectrum);

/// Airglow at the zenith, W/(m2 sr nm), on a scale of its own: the typical lines and continuum of Leinert et al. 1998
/// (A&AS 127, 1, sec. 6) and of spectra from dark observatories. O I 557.7 nm 250 R, Na 589.3 nm 50 R, O I 630.0 and
/// 636.4 nm 150 R in the ratio 3 : 1, a continuum of 3 R/nm, and the bands of OH as a rise from that at 650 nm to
/// 20 R/nm at 800 nm (1 R is 1e10/(4 pi) photons/(m2 s sr)). In this scale it shines at V = 22.3 mag/arcsec2.
[[nodiscard]] const Spectrum& airglow_spectrum();

/// Airglow at the zenith in S10(V), by the flux of the Sun at 10.7 cm: 145 at 80 solar flux units and 275 at 200,
/// linear (Benn and Ellison 1998, New Astronomy Reviews 42, 503, from years of measurements at La Palma). All lines are
/// taken to rise alike, which the red ones do not. From hour to hour it varies by tens of percent besides.
/// \param solar_flux_sfu 1e-22 W/(m2 Hz), > 0: about 70 at solar minimum, 200 at maximum. Throws Error(argument)
/// otherwise.
[[nodiscard]] double airglow_s10(double solar_flux_sfu);
/// The range in which it holds for what may be seen: solar fluxes, daily values since 1947.
inline constexpr double lowest_solar_flux_sfu = 60.0;
inline constexpr double highest_solar_flux_sfu = 400.0;

/// Zodiacal light with 1e-8 W/(m2 sr um) at 500 nm: sunlight times 1 + s log10(wavelength / 500 nm), s above and below
/// 500 nm as Leinert et al. 1998, eq. 22. W/(m2 sr nm).
/// \param far 0 for an elongation of at most 30 degrees (s = 1.2 and 0.8), 1 for 90 and more (0.9 and 0.6), linear
/// between
[[nodiscard]] Spectrum zodiacal_spectrum(double far);

/// The light of all faint stars together, to a scale: B-V = 0.7.
[[nodiscard]] const Spectrum& faint_starlight_spectrum();

/// Street lighting, to a scale: a black body of 3000 K stands for its mixture of sodium lamps and white diodes.
[[nodiscard]] const Spectrum& lamp_spectrum();

} // namespace vesper
