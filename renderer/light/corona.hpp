// The light of the Sun's corona.
#pragma once

namespace vesper {

/// Baumbach's law (shaders/lib/sun.glsl) counts in this brightness, over the mean of the Sun's disc: 1e-6 of that at
/// its centre, at 550 nm.
[[nodiscard]] double corona_unit();

/// The spectrum of the light that the corona's dust (F) scatters, over the Sun's, 1 at 500 nm: 1 + s log10(wavelength /
/// 500 nm), s = 0.8 below 500 nm and 1.2 above, as found of the zodiacal light nearest to the Sun (Leinert et al. 1998,
/// A&AS 127, 1, eq. 22). That of its free electrons (K) has the Sun's own.
[[nodiscard]] double dust_reddening(double wavelength_nm);

/// Light of the corona, over that of the whole disc: by electrons, and by dust at 500 nm.
struct CoronaLight {
  double electrons = 0.0;
  double dust = 0.0;
};

/// What is seen of it past another disc, from the Sun's limb to f64::corona_edge; 1.14e-6 and 0.23e-6 without one.
/// The angles may be in any one unit.
/// \param sun, other radii, positive
/// \param separation of the centres, >= 0
[[nodiscard]] CoronaLight corona_seen(double sun, double other, double separation);

} // namespace vesper
