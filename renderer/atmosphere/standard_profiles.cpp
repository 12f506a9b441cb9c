#include "vesper/atmosphere/standard_profiles.hpp"

#include "vesper/astro/air_profile.hpp"
#include "vesper/light/embedded_spectrum.hpp"

#include <array>
#include <vector>

namespace vesper {

extern const EmbeddedTable embedded_atmosphere_tables;

HeightProfile standard_air_profile() {
  // Refractivity is proportional to density.
  const AirProfile air(standard_conditions(0.0 * metre));
  const double sea_level = air.at(0.0).refractivity;
  constexpr int top_km = 120;
  std::vector<double> heights;
  std::vector<double> densities;
  for (int km = 0; km <= top_km; ++km) {
    heights.push_back(km);
    densities.push_back(air.at(km).refractivity / sea_level);
  }
  return HeightProfile::table(heights, densities, HeightProfile::Between::logarithmic);
}

HeightProfile standard_ozone_profile() {
  // From 2 km in steps of 2 km. Below 2 km as there.
  constexpr std::array density{6.8,    5.8,    5.7,    6.5,    11.3,   20.2,   23.5,  29.5,  40.4,  47.7,
                               48.6,   45.4,   40.3,   32.4,   25.2,   20.3,   15.8,  12.2,  8.73,  6.07,
                               3.98,   2.74,   1.69,   1.03,   0.664,  0.384,  0.255, 0.161, 0.112, 0.0733,
                               0.0481, 0.0317, 0.0172, 0.0075, 0.0054, 0.0022, 0.0017};
  constexpr double step_km = 2.0;
  std::vector<double> heights{0.0};
  std::vector<double> densities{density.front()};
  for (const double value : density) {
    heights.push_back(heights.back() + step_km);
    densities.push_back(value);
  }
  return HeightProfile::table(heights, densities, HeightProfile::Between::linear);
}

WavelengthLaw ozone_absorption_per_km(double dobson, double column_km) {
  constexpr double dobson_per_m2 = 2.6867e20;
  return [m2_per_km = dobson * dobson_per_m2 / column_km,
          cross_section_m2 =
              embedded_spectrum(embedded_atmosphere_tables, "ozone_absorption_233k.csv", "cross_section_m2")](
             double wavelength_nm) { return m2_per_km * cross_section_m2(wavelength_nm); };
}

} // namespace vesper
