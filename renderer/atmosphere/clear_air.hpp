// Extinction of starlight by clear air, until the medium's spectral tables serve it.
#pragma once

#include "vesper/base/vector.hpp"

namespace vesper {

/// Optical depth of one zenith column of clear sea-level air at a wavelength.
///
/// Rayleigh scattering after Hansen and Travis 1974 (Space Sci. Rev. 16, 527, eq. 2.30, 1013.25 hPa), aerosol of
/// optical depth 0.10 at 550 nm with an Angstrom exponent of 1.3, and 300 Dobson units of ozone. Valid from 400 to
/// 700 nm; about 0.23 at 550 nm, which is 0.25 magnitudes.
///
/// \param ozone_cross_section_m2 of one molecule at that wavelength
[[nodiscard]] double clear_air_optical_depth(double wavelength_nm, double ozone_cross_section_m2);

/// The same for the responses X, Y, Z and S, each at the wavelength that stands for it (600, 555, 450, 507 nm).
[[nodiscard]] Vec4 clear_air_optical_depth_xyzs();

} // namespace vesper
