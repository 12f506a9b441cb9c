// The media that need no file.
#pragma once

#include "vesper/atmosphere/medium.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vesper {

/// The coefficients of the published real-time models (Bruneton and Neyret 2008 with the ozone of later renderers), at
/// 680, 550 and 440 nm; linear between these wavelengths, nothing outside them. Radii 6360 and 6460 km, molecules of
/// 8 km and aerosol of 1.2 km scale height with Cornette and Shanks's phase function, g = 0.8, ozone from 10 to 40 km,
/// ground albedo 0.3.
[[nodiscard]] Medium published_medium();

/// What changes from day to day in clear air.
struct ClearAir {
  double aerosol_optical_depth = 0.10; ///< at 550 nm from sea level to space, 0 to 10
  /// The part of it above the weather, 0 to 1 (0.1 and more after great volcanic eruptions), at most all of it.
  double stratospheric_optical_depth = 0.005;
  double angstrom_exponent = 1.3; ///< optical depth goes as wavelength to minus this, -1 to 4
  double ozone_dobson = 348.0;    ///< 0 to 1000; the standard atmosphere's, about the mean of middle latitudes
  double ground_albedo = 0.10;    ///< at all wavelengths, 0 to 1
};

/// Clear air by wavelength, 360 to 830 nm, over a sphere of the Earth's mean radius, to 120 km.
///
/// - Molecules: `rayleigh_per_km`, density by height of the US Standard Atmosphere 1976.
/// - Aerosol of the troposphere: Angstrom's law; density falls with 1.5 km, as the extinction of high observatories
///   tells (Hayes and Latham 1975, ApJ 197, 593). Single-scattering albedo 0.925 and g = 0.703 (Henyey and Greenstein)
///   of OPAC's continental average at 550 nm and 80 % humidity (Hess et al. 1998, Bull. Am. Meteorol. Soc. 79, 831).
///   Its continental clean air (0.972, 0.709) would give 2 % more light with the Sun low, further from what is measured
///   (tests/accuracy/transport_test.cpp).
/// - Aerosol of the stratosphere: optical depth and height (12 to 35 km) as in OPAC, densest at 20 km; droplets of
///   sulphuric acid that absorb nothing; g and Angstrom exponent of the troposphere (OPAC's droplets: 0.72 and 0.95).
/// - Ozone: absorption at 233 K (Gorshelev, Serdyuchenko et al. 2014), the mid-latitude profile and column of the US
///   Standard Atmosphere 1976.
/// - Ground: grey, about as bright to the eye as green plants (0.08 at 450, 0.13 at 550, 0.07 at 650, 0.5 beyond
///   750 nm: the code 6S, Vermote et al. 1997, IEEE Trans. Geosci. Remote Sens. 35, 675).
///
/// Throws Error(argument) for a value out of its range.
[[nodiscard]] Medium clear_medium(const ClearAir& air = {});

/// Throws Error(argument) naming the value that is out of its range.
void validate(const ClearAir& air);

/// Aerosol optical depth at 550 nm that belongs to a turbidity T, 1 or more: the optical depth of molecules and aerosol
/// together is T times that of the molecules (Preetham et al. 1999; Hosek's thesis, eq. 4.1), here at 550 nm and sea
/// level, where the molecules' is 0.097. Clear air by default has T = 2.0.
[[nodiscard]] double aerosol_depth_from_turbidity(double turbidity);

/// Every 10 nm over the range of the response functions, 360 to 830 nm.
[[nodiscard]] std::vector<double> transport_wavelengths_nm();

/// "clear" and "published".
[[nodiscard]] std::span<const std::string_view> medium_names();
/// None for another name.
[[nodiscard]] std::optional<Medium> medium_by_name(std::string_view name);

/// (6 + 3 rho) / (6 - 7 rho) for air with 450 ppm of carbon dioxide: Bodhaine et al. 1999 (J. Atmos. Ocean. Technol.
/// 16, 1854, eq. 5, 6 and 23).
[[nodiscard]] double king_factor(double wavelength_nm);

/// The depolarization rho of natural light that belongs to it, 0.03.
[[nodiscard]] double air_depolarization(double wavelength_nm);

/// Scattering of dry air at 1013.25 hPa and 15 C, per km, wavelength in vacuum, 300 to 1700 nm: Rayleigh's law in the
/// form of Bodhaine et al. 1999, eq. 2, with the refractive index of Ciddor 1996.
[[nodiscard]] double rayleigh_per_km(double wavelength_nm);

} // namespace vesper
