#include "vesper/atmosphere/medium_presets.hpp"

#include "vesper/astro/air_profile.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/embedded_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace vesper {

extern const EmbeddedTable embedded_atmosphere_tables;

namespace {

constexpr double top_km = 120.0;

WavelengthLaw constant(double value) {
  return [value](double) { return value; };
}

/// Samples at the wavelengths of the published models.
Spectrum red_green_blue(double red, double green, double blue) { return {{440.0, 550.0, 680.0}, {blue, green, red}}; }

void hold(const char* what, double value, double lowest, double highest) {
  if (!(value >= lowest && value <= highest)) {
    throw Error(ErrorKind::argument, std::string(what) + " of " + std::to_string(value),
                {"", "", "Give " + std::to_string(lowest) + " to " + std::to_string(highest)});
  }
}

/// Density of the standard atmosphere over that of sea level: refractivity is proportional to it.
HeightProfile standard_density() {
  const AirProfile air(standard_conditions(0.0 * metre));
  const double sea_level = air.at(0.0).refractivity;
  std::vector<double> heights;
  std::vector<double> densities;
  for (int km = 0; km <= static_cast<int>(top_km); ++km) {
    heights.push_back(km);
    densities.push_back(air.at(km).refractivity / sea_level);
  }
  return HeightProfile::table(heights, densities, HeightProfile::Between::logarithmic);
}

/// Molecules of ozone per m3, 1e17, from 2 km in steps of 2 km: US Standard Atmosphere 1976 (NOAA-S/T 76-1562,
/// mid-latitude model, 348 Dobson units). Below 2 km as there.
constexpr std::array<double, 37> ozone_density{
    6.8,   5.8,   5.7,   6.5,    11.3,   20.2,   23.5,   29.5,   40.4,   47.7,   48.6,  45.4,  40.3,
    32.4,  25.2,  20.3,  15.8,   12.2,   8.73,   6.07,   3.98,   2.74,   1.69,   1.03,  0.664, 0.384,
    0.255, 0.161, 0.112, 0.0733, 0.0481, 0.0317, 0.0172, 0.0075, 0.0054, 0.0022, 0.0017};
constexpr double ozone_step_km = 2.0;

/// The column of that table in km at a density of 1 (the trapezoidal rule is what linear interpolation holds).
double ozone_column_km() {
  double sum = 0.5 * (ozone_density.front() - ozone_density.back());
  for (const double density : ozone_density) {
    sum += density;
  }
  return sum * ozone_step_km;
}

HeightProfile ozone_profile() {
  std::vector<double> heights{0.0};
  std::vector<double> densities{ozone_density.front()};
  for (std::size_t i = 0; i < ozone_density.size(); ++i) {
    heights.push_back(ozone_step_km * static_cast<double>(i + 1));
    densities.push_back(ozone_density[i]);
  }
  return HeightProfile::table(heights, densities, HeightProfile::Between::linear);
}

/// Angstrom's law from a coefficient at 550 nm.
WavelengthLaw angstrom(double per_km, const ClearAir& air) {
  return [per_km, exponent = air.angstrom_exponent](double wavelength_nm) {
    return per_km * std::pow(wavelength_nm / 550.0, -exponent);
  };
}

/// The range of the response functions.
std::vector<double> every_10_nm() {
  std::vector<double> wavelengths;
  for (double nm = 360.0; nm <= 830.0; nm += 10.0) {
    wavelengths.push_back(nm);
  }
  return wavelengths;
}

} // namespace

Medium published_medium() {
  const PhaseFunction molecular{PhaseKind::rayleigh, constant(0.0)};
  return {6360.0 * kilometre,
          6460.0 * kilometre,
          constant(0.3),
          {{"molecules", HeightProfile::exponential(8.0), red_green_blue(5.802e-3, 13.558e-3, 33.1e-3), constant(0.0),
            molecular},
           {"aerosol",
            HeightProfile::exponential(1.2),
            red_green_blue(3.996e-3, 3.996e-3, 3.996e-3),
            red_green_blue(0.444e-3, 0.444e-3, 0.444e-3),
            {PhaseKind::cornette_shanks, constant(0.8)}},
           {"ozone", HeightProfile::tent(10.0, 25.0, 40.0), constant(0.0), red_green_blue(0.650e-3, 1.881e-3, 0.085e-3),
            molecular}},
          {440.0, 550.0, 680.0}};
}

double king_factor(double wavelength_nm) {
  const double inverse2 = 1.0e6 / (wavelength_nm * wavelength_nm);
  const double nitrogen = 1.034 + 3.17e-4 * inverse2;
  const double oxygen = 1.096 + 1.385e-3 * inverse2 + 1.448e-4 * inverse2 * inverse2;
  constexpr double argon = 1.0;
  constexpr double carbon_dioxide = 1.15;
  return (78.084 * nitrogen + 20.946 * oxygen + 0.934 * argon + 0.045 * carbon_dioxide) /
         (78.084 + 20.946 + 0.934 + 0.045);
}

double air_depolarization(double wavelength_nm) {
  const double king = king_factor(wavelength_nm);
  return 6.0 * (king - 1.0) / (3.0 + 7.0 * king);
}

double rayleigh_per_km(double wavelength_nm) {
  // 1013.25 hPa over Boltzmann's constant and 288.15 K.
  constexpr double molecules_per_m3 = 2.546899e25;
  const double index = 1.0 + air_refractivity(wavelength_nm, 1013.25, 15.0);
  const double lorentz = (index * index - 1.0) / (index * index + 2.0);
  const double wavelength_m = wavelength_nm * 1.0e-9;
  const double wavelength2 = wavelength_m * wavelength_m;
  constexpr double pi3 = std::numbers::pi * std::numbers::pi * std::numbers::pi;
  return 1.0e3 * 24.0 * pi3 * lorentz * lorentz * king_factor(wavelength_nm) /
         (wavelength2 * wavelength2 * molecules_per_m3);
}

Medium clear_medium(const ClearAir& air) {
  hold("aerosol optical depth", air.aerosol_optical_depth, 0.0, 10.0);
  hold("stratospheric optical depth", air.stratospheric_optical_depth, 0.0, 1.0);
  hold("Angstrom exponent", air.angstrom_exponent, -1.0, 4.0);
  hold("ozone column", air.ozone_dobson, 0.0, 1000.0);
  hold("ground albedo", air.ground_albedo, 0.0, 1.0);

  const double high_depth = std::min(air.stratospheric_optical_depth, air.aerosol_optical_depth);
  constexpr double low_scale_km = 1.5;
  constexpr double low_albedo = 0.95;
  const WavelengthLaw low_per_km = angstrom((air.aerosol_optical_depth - high_depth) / low_scale_km, air);
  constexpr double high_from_km = 12.0;
  constexpr double high_peak_km = 20.0;
  constexpr double high_to_km = 35.0;
  const WavelengthLaw high_per_km = angstrom(high_depth / (0.5 * (high_to_km - high_from_km)), air);
  const PhaseFunction droplets{PhaseKind::henyey_greenstein, constant(0.70)};

  constexpr double dobson_per_m2 = 2.6867e20;
  const double ozone_m2_per_km = air.ozone_dobson * dobson_per_m2 / ozone_column_km();
  const WavelengthLaw ozone_per_km =
      [ozone_m2_per_km, cross_section_m2 = embedded_spectrum(embedded_atmosphere_tables, "ozone_absorption_233k.csv",
                                                             "cross_section_m2")](double wavelength_nm) {
        return ozone_m2_per_km * cross_section_m2(wavelength_nm);
      };
  const PhaseFunction molecular{PhaseKind::rayleigh, air_depolarization};

  constexpr double mean_earth_radius_km = 6371.0;
  return {mean_earth_radius_km * kilometre,
          (mean_earth_radius_km + top_km) * kilometre,
          constant(air.ground_albedo),
          {{"molecules", standard_density(), rayleigh_per_km, constant(0.0), molecular},
           {"tropospheric aerosol", HeightProfile::exponential(low_scale_km),
            [low_per_km](double nm) { return low_albedo * low_per_km(nm); },
            [low_per_km](double nm) { return (1.0 - low_albedo) * low_per_km(nm); }, droplets},
           {"stratospheric aerosol", HeightProfile::tent(high_from_km, high_peak_km, high_to_km), high_per_km,
            constant(0.0), droplets},
           {"ozone", ozone_profile(), constant(0.0), ozone_per_km, molecular}},
          every_10_nm()};
}

} // namespace vesper
