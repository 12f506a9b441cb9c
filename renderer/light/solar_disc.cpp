#include "vesper/light/solar_disc.hpp"

#include "vesper/base/embedded.hpp"
#include "vesper/light/embedded_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace vesper {

extern const EmbeddedTable embedded_light_tables;

namespace {

constexpr std::array neckel_nm{440.0, 550.0, 680.0};
constexpr std::array neckel_power{0.652, 0.503, 0.397};
constexpr LimbPowers neckel_powers{0.26, 0.1};
constexpr LimbPowers polynomial_powers{0.0, 1.0};

/// The coefficients of Neckel and Labs' polynomials, over the brightness at the centre.
LimbSeries measured_polynomial(double wavelength_nm) {
  static const std::vector<Spectrum> columns = [] {
    std::vector<Spectrum> read;
    for (std::size_t k = 0; k < limb_terms; ++k) {
      read.push_back(
          embedded_spectrum(embedded_light_tables, "limb_darkening_neckel_labs_1994.csv", "a" + std::to_string(k)));
    }
    return read;
  }();
  const double nm = std::clamp(wavelength_nm, columns[0].wavelengths_nm().front(), columns[0].wavelengths_nm().back());
  LimbSeries series{};
  double centre = 0.0;
  for (std::size_t k = 0; k < limb_terms; ++k) {
    series[k] = columns[k](nm);
    centre += series[k];
  }
  for (double& term : series) {
    term /= centre; // 1 but for rounding and one row of 0.998
  }
  return series;
}

/// Lagrange's weights of the powers through which mu^power is interpolated.
LimbSeries interpolated_power(double power) {
  LimbSeries series{};
  for (std::size_t k = 0; k < limb_terms; ++k) {
    series[k] = 1.0;
    for (std::size_t j = 0; j < limb_terms; ++j) {
      series[k] *= j == k ? 1.0 : (power - neckel_powers[j]) / (neckel_powers[k] - neckel_powers[j]);
    }
  }
  return series;
}

double mean_of(const LimbSeries& series, const LimbPowers& powers) {
  double mean = 0.0;
  for (std::size_t k = 0; k < limb_terms; ++k) {
    mean += series[k] * powers.disc_mean(k);
  }
  return mean;
}

} // namespace

double limb_darkening_power(double wavelength_nm) {
  const std::size_t i = wavelength_nm < neckel_nm[1] ? 0 : 1;
  const double slope = (neckel_power[i + 1] - neckel_power[i]) / (neckel_nm[i + 1] - neckel_nm[i]);
  return std::max(0.0, neckel_power[i] + slope * (wavelength_nm - neckel_nm[i]));
}

double solar_limb_darkening(double wavelength_nm, double mu, LimbDarkening law) {
  if (law == LimbDarkening::neckel) {
    return std::pow(mu, limb_darkening_power(wavelength_nm));
  }
  const LimbSeries a = measured_polynomial(wavelength_nm);
  double sum = 0.0;
  for (std::size_t k = limb_terms; k-- > 0;) {
    sum = a[k] + mu * sum;
  }
  return sum;
}

double solar_disc_mean(double wavelength_nm, LimbDarkening law) {
  return law == LimbDarkening::neckel ? 2.0 / (limb_darkening_power(wavelength_nm) + 2.0)
                                      : mean_of(measured_polynomial(wavelength_nm), polynomial_powers);
}

LimbPowers limb_powers(LimbDarkening law) { return law == LimbDarkening::neckel ? neckel_powers : polynomial_powers; }

LimbSeries limb_series(double wavelength_nm, LimbDarkening law) {
  LimbSeries series = law == LimbDarkening::neckel ? interpolated_power(limb_darkening_power(wavelength_nm))
                                                   : measured_polynomial(wavelength_nm);
  const double mean = mean_of(series, limb_powers(law));
  for (double& term : series) {
    term /= mean;
  }
  return series;
}

std::array<Xyzs, limb_terms> limb_xyzs(const Spectrum& disc, LimbDarkening law) {
  const std::vector<double>& nm = disc.wavelengths_nm();
  std::array<std::vector<double>, limb_terms> parts;
  for (std::size_t i = 0; i < nm.size(); ++i) {
    const LimbSeries series = limb_series(nm[i], law);
    for (std::size_t k = 0; k < limb_terms; ++k) {
      parts[k].push_back(disc.values()[i] * series[k]);
    }
  }
  std::array<Xyzs, limb_terms> terms;
  for (std::size_t k = 0; k < limb_terms; ++k) {
    terms[k] = integrate_xyzs({nm, std::move(parts[k])});
  }
  return terms;
}

} // namespace vesper
