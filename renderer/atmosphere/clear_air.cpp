#include "vesper/atmosphere/clear_air.hpp"

#include <cmath>

namespace vesper {
namespace {

constexpr double aerosol_optical_depth_550 = 0.10;
constexpr double angstrom_exponent = 1.3;
/// 300 Dobson units of 2.6867e20 molecules per m2.
constexpr double ozone_column_per_m2 = 300.0 * 2.6867e20;

} // namespace

double clear_air_optical_depth(double wavelength_nm, double ozone_cross_section_m2) {
  const double micrometres = wavelength_nm * 1.0e-3;
  const double inverse2 = 1.0 / (micrometres * micrometres);
  const double rayleigh = 0.008569 * inverse2 * inverse2 * (1.0 + 0.0113 * inverse2 + 0.00013 * inverse2 * inverse2);
  const double aerosol = aerosol_optical_depth_550 * std::pow(micrometres / 0.550, -angstrom_exponent);
  return rayleigh + aerosol + ozone_column_per_m2 * ozone_cross_section_m2;
}

Vec4 clear_air_optical_depth_xyzs() {
  // Ozone cross-sections at 233 K: Gorshelev, Serdyuchenko et al. 2014 (Atmos. Meas. Tech. 7, 609 and 625).
  return {clear_air_optical_depth(600.0, 5.085e-25), clear_air_optical_depth(555.0, 3.482e-25),
          clear_air_optical_depth(450.0, 1.758e-26), clear_air_optical_depth(507.0, 1.54e-25)};
}

} // namespace vesper
