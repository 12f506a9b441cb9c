#include "vesper/light/night_light.hpp"

#include "vesper/base/error.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace vesper {
namespace {

constexpr double square_arcsec_sr = arcsec.to(rad) * arcsec.to(rad);

/// Radiance of one rayleigh at a wavelength, W/(m2 sr).
double rayleigh_w_m2_sr(double wavelength_nm) {
  constexpr double planck_times_c = 6.62607015e-34 * 299792458.0;
  return 1.0e10 / (4.0 * std::numbers::pi) * planck_times_c / (wavelength_nm * 1.0e-9);
}

double airglow_continuum_r_nm(double nm) { return nm < 650.0 ? 3.0 : 3.0 + (nm - 650.0) / 150.0 * 17.0; }

Spectrum make_airglow_spectrum() {
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (int nm = response_first_nm; nm <= response_last_nm; ++nm) {
    wavelengths.push_back(nm);
    values.push_back(airglow_continuum_r_nm(nm) * rayleigh_w_m2_sr(nm));
  }
  for (const auto& [line_nm, rayleighs] :
       {std::pair(557.7, 250.0), std::pair(589.3, 50.0), std::pair(630.0, 112.5), std::pair(636.4, 37.5)}) {
    // Shared by the samples beside it: the rules that integrate spectra have steps of 1 nm.
    const auto before = static_cast<std::size_t>(line_nm) - response_first_nm;
    const double across = line_nm - std::floor(line_nm);
    values[before] += (1.0 - across) * rayleighs * rayleigh_w_m2_sr(line_nm);
    values[before + 1] += across * rayleighs * rayleigh_w_m2_sr(line_nm);
  }
  return {std::move(wavelengths), std::move(values)};
}

double lux_ratio_of(const Spectrum& spectrum) {
  static const double of_a0 = lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  return lux_per_v_flux(spectrum) / of_a0;
}

/// The Sun's irradiance about 500 nm without its lines.
double sunlight_at_500nm() {
  double sum = 0.0;
  for (int nm = 490; nm <= 510; ++nm) {
    sum += solar_irradiance_1au()(nm);
  }
  return sum / 21.0;
}

} // namespace

Luminance luminance_of_v_per_arcsec2(double v, double lux_ratio) {
  return illuminance_of_v(v, lux_ratio).to(lux) / square_arcsec_sr * candela_per_m2;
}

double v_per_arcsec2(Luminance luminance, double lux_ratio) {
  return v_of_illuminance(luminance.to(candela_per_m2) * square_arcsec_sr * lux, lux_ratio);
}

Vec4 xyzs_of_s10(const Spectrum& spectrum) {
  const Xyzs light = integrate_xyzs(spectrum);
  const double y = luminance_of_v_per_arcsec2(s10_v_per_arcsec2, lux_ratio_of(spectrum)).to(candela_per_m2);
  return y / light.y * vector_of(light);
}

const Spectrum& airglow_spectrum() {
  static const Spectrum spectrum = make_airglow_spectrum();
  return spectrum;
}

double airglow_s10(double solar_flux_sfu) {
  if (!(solar_flux_sfu > 0.0) || !std::isfinite(solar_flux_sfu)) {
    throw Error(ErrorKind::argument, "a solar flux of " + std::to_string(solar_flux_sfu) + " sfu",
                {"", "", "Give 60 to 400"});
  }
  return 145.0 + 130.0 * (solar_flux_sfu - 80.0) / 120.0;
}

Spectrum zodiacal_spectrum(double far) {
  const Spectrum& sunlight = solar_irradiance_1au();
  const double above = 1.2 + far * (0.9 - 1.2);
  const double below = 0.8 + far * (0.6 - 0.8);
  const double scale = 1.0e-11 / sunlight_at_500nm();
  std::vector<double> values = sunlight.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double nm = sunlight.wavelengths_nm()[i];
    values[i] *= scale * (1.0 + (nm < 500.0 ? below : above) * std::log10(nm / 500.0));
  }
  return {sunlight.wavelengths_nm(), std::move(values)};
}

const Spectrum& faint_starlight_spectrum() {
  static const Spectrum spectrum = planck_spectrum(star_temperature_k(0.7));
  return spectrum;
}

const Spectrum& lamp_spectrum() {
  static const Spectrum spectrum = planck_spectrum(3000.0);
  return spectrum;
}

} // namespace vesper
