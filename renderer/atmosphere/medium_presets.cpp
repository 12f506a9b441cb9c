#include "vesper/atmosphere/medium_presets.hpp"

#include "vesper/astro/air_profile.hpp"
#include "vesper/atmosphere/standard_profiles.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {

namespace {

constexpr Length ground_radius = 6371.0 * kilometre; // the Earth's mean
constexpr Length top_radius = ground_radius + 120.0 * kilometre;

/// Samples at the wavelengths of the published models.
Spectrum red_green_blue(double red, double green, double blue) { return {{440.0, 550.0, 680.0}, {blue, green, red}}; }

void hold(const char* what, double value, double lowest, double highest) {
  if (!(value >= lowest && value <= highest)) {
    throw Error(ErrorKind::argument, std::string(what) + " of " + std::to_string(value),
                {"", "", "Give " + std::to_string(lowest) + " to " + std::to_string(highest)});
  }
}

/// Angstrom's law from a coefficient at 550 nm.
WavelengthLaw angstrom(double per_km, const ClearAir& air) {
  return [per_km, exponent = air.angstrom_exponent](double wavelength_nm) {
    return per_km * std::pow(wavelength_nm / 550.0, -exponent);
  };
}

} // namespace

std::vector<double> transport_wavelengths_nm() {
  std::vector<double> wavelengths;
  for (int nm = 360; nm <= 830; nm += 10) {
    wavelengths.push_back(nm);
  }
  return wavelengths;
}

Medium published_medium() {
  const PhaseFunction molecular{PhaseKind::rayleigh, constant_law(0.0)};
  return {6360.0 * kilometre,
          6460.0 * kilometre,
          constant_law(0.3),
          {{"molecules", HeightProfile::exponential(8.0), red_green_blue(5.802e-3, 13.558e-3, 33.1e-3),
            constant_law(0.0), molecular},
           {"aerosol",
            HeightProfile::exponential(1.2),
            red_green_blue(3.996e-3, 3.996e-3, 3.996e-3),
            red_green_blue(0.444e-3, 0.444e-3, 0.444e-3),
            {PhaseKind::cornette_shanks, constant_law(0.8)}},
           {"ozone", HeightProfile::tent(10.0, 25.0, 40.0), constant_law(0.0),
            red_green_blue(0.650e-3, 1.881e-3, 0.085e-3), molecular}},
          {440.0, 550.0, 680.0}};
}

std::span<const std::string_view> medium_names() {
  static constexpr std::array<std::string_view, 2> names{"clear", "published"};
  return names;
}

std::optional<Medium> medium_by_name(std::string_view name) {
  if (name == "clear") {
    return clear_medium();
  }
  if (name == "published") {
    return published_medium();
  }
  return std::nullopt;
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

void validate(const ClearAir& air) {
  hold("aerosol optical depth", air.aerosol_optical_depth, 0.0, 10.0);
  hold("stratospheric optical depth", air.stratospheric_optical_depth, 0.0, 1.0);
  hold("Angstrom exponent", air.angstrom_exponent, -1.0, 4.0);
  hold("ozone column", air.ozone_dobson, 0.0, 1000.0);
  hold("ground albedo", air.ground_albedo, 0.0, 1.0);
}

double aerosol_depth_from_turbidity(double turbidity) {
  constexpr double wavelength_nm = 550.0;
  return (turbidity - 1.0) * rayleigh_per_km(wavelength_nm) *
         zenith_column_km(standard_air_profile(), ground_radius, top_radius);
}

Medium clear_medium(const ClearAir& air) {
  validate(air);
  const double high_depth = std::min(air.stratospheric_optical_depth, air.aerosol_optical_depth);
  constexpr double low_scale_km = 1.5;
  constexpr double low_albedo = 0.925;
  const WavelengthLaw low_per_km = angstrom((air.aerosol_optical_depth - high_depth) / low_scale_km, air);
  constexpr double high_from_km = 12.0;
  constexpr double high_peak_km = 20.0;
  constexpr double high_to_km = 35.0;
  const WavelengthLaw high_per_km = angstrom(high_depth / (0.5 * (high_to_km - high_from_km)), air);
  const PhaseFunction droplets{PhaseKind::henyey_greenstein, constant_law(0.703)};

  const HeightProfile ozone = standard_ozone_profile();
  const PhaseFunction molecular{PhaseKind::rayleigh, air_depolarization};

  return {ground_radius,
          top_radius,
          constant_law(air.ground_albedo),
          {{"molecules", standard_air_profile(), rayleigh_per_km, constant_law(0.0), molecular},
           {"tropospheric aerosol", HeightProfile::exponential(low_scale_km),
            [low_per_km](double nm) { return low_albedo * low_per_km(nm); },
            [low_per_km](double nm) { return (1.0 - low_albedo) * low_per_km(nm); }, droplets},
           {"stratospheric aerosol", HeightProfile::tent(high_from_km, high_peak_km, high_to_km), high_per_km,
            constant_law(0.0), droplets},
           {"ozone", ozone, constant_law(0.0),
            ozone_absorption_per_km(air.ozone_dobson, zenith_column_km(ozone, ground_radius, top_radius)), molecular}},
          transport_wavelengths_nm()};
}

} // namespace vesper
