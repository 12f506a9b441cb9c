// Air over an observer: temperature, pressure and refractivity by height.
#pragma once

#include "vesper/base/units.hpp"

#include <vector>

namespace vesper {

/// What bends the light: the air at the observer and the light's wavelength.
struct RefractionConditions {
  Length height;                 ///< above the ellipsoid, -500 m to 100 km
  double pressure_hpa = 1013.25; ///< at the observer, 0 (no air) to 1100
  double temperature_c = 15.0;   ///< at the observer, -90 to 60
  double wavelength_nm = 555.0;  ///< in vacuum, 300 to 1700; by default where the eye sees best

  [[nodiscard]] friend bool operator==(const RefractionConditions&, const RefractionConditions&) = default;
};

/// Pressure and temperature of the US Standard Atmosphere 1976 at a height; 555 nm.
[[nodiscard]] RefractionConditions standard_conditions(Length height);

/// Throws Error(argument) naming the member, its value and its range.
void validate(const RefractionConditions& conditions);

/// n - 1 of dry air with 450 ppm of carbon dioxide: Ciddor 1996 (Appl. Opt. 35, 1566, eq. 1, 5 and 12), good to 1e-8 in
/// the range he gives (-40 to 100 C, 800 to 1200 hPa). Moist air bends light less, by 0.1 % at most at 15 C.
[[nodiscard]] double air_refractivity(double wavelength_nm, double pressure_hpa, double temperature_c);

/// Temperature profile of the US Standard Atmosphere 1976 (NOAA-S/T 76-1562, table 4), as a whole warmed or cooled so
/// that it meets the observer's temperature, isothermal above 86 km; pressure in hydrostatic equilibrium from the
/// observer's; dry air. Below the observer the lapse rate goes on.
///
/// The corners of the temperature are rounded within 1 km (1.6 K at the tropopause): across a sharp corner the
/// refraction of grazing rays has an infinite slope, which no air has.
class AirProfile {
public:
  explicit AirProfile(const RefractionConditions& conditions);

  struct Air {
    double refractivity;    ///< n - 1
    double gradient_per_km; ///< its derivative by height
  };
  /// \param height_km -1 to 120; held at the ends
  [[nodiscard]] Air at(double height_km) const;
  [[nodiscard]] double pressure_hpa(double height_km) const;
  [[nodiscard]] double temperature_k(double height_km) const;

  /// Where the observer stands.
  [[nodiscard]] double observer_km() const { return observer_km_; }

private:
  struct Node {
    double ln_pressure;
    double slope; ///< a step
  };
  [[nodiscard]] double ln_pressure(double geopotential_km) const;

  double observer_km_;
  double warmer_k_;                 ///< than the standard atmosphere
  double refractivity_per_density_; ///< (n - 1) T / p, K/hPa
  std::vector<Node> nodes_;         ///< at equal steps of geopotential height
};

inline constexpr double top_of_air_km = 120.0;

/// Heights in km between which the temperature profile is smooth, from below the ground to the top of the air.
[[nodiscard]] const std::vector<double>& air_profile_corners_km();

} // namespace vesper
