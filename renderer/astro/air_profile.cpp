#include "vesper/astro/air_profile.hpp"

#include "vesper/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace vesper {
namespace {

constexpr double kelvin = 273.15; // of 0 C

// US Standard Atmosphere 1976, in geopotential kilometres.
constexpr double standard_temperature_k = 288.15;
constexpr double geopotential_radius_km = 6356.766;
constexpr double hydrostatic_k_per_km = 34.163195; // g M / R
constexpr double lowest_lapse_k_per_km = -6.5;
struct Corner {
  double height_km;
  double change_k_per_km; ///< of the temperature's gradient
};
constexpr std::array<Corner, 7> corners{
    {{11.0, 6.5}, {20.0, 1.0}, {32.0, 1.8}, {47.0, -2.8}, {51.0, -2.8}, {71.0, 0.8}, {84.852, 2.0}}};
constexpr double rounding_km = 1.0;

constexpr double lowest_km = -1.0; // geopotential
constexpr double step_km = 0.25;

double geopotential_km(double height_km) {
  return geopotential_radius_km * height_km / (geopotential_radius_km + height_km);
}
double geometric_km(double height_km) {
  return geopotential_radius_km * height_km / (geopotential_radius_km - height_km);
}

struct Temperature {
  double k;
  double gradient_k_per_km;
};

Temperature standard_temperature(double geopotential) {
  Temperature t{standard_temperature_k + lowest_lapse_k_per_km * geopotential, lowest_lapse_k_per_km};
  for (const Corner& corner : corners) {
    const double above = geopotential - corner.height_km;
    if (above <= -rounding_km) {
      break;
    }
    const double share = std::min((above + rounding_km) / (2.0 * rounding_km), 1.0);
    t.gradient_k_per_km += corner.change_k_per_km * share;
    t.k += corner.change_k_per_km * (share < 1.0 ? rounding_km * share * share : above);
  }
  return t;
}

/// Compressibility of dry air (Ciddor 1996, eq. 12).
double compressibility(double pressure_pa, double temperature_c) {
  const double p_t = pressure_pa / (temperature_c + kelvin);
  return 1.0 - p_t * (1.58123e-6 - 2.9331e-8 * temperature_c + 1.1043e-10 * temperature_c * temperature_c) +
         p_t * p_t * 1.83e-11;
}

void require(bool holds, std::string_view what, double value, std::string_view range) {
  if (!holds) {
    throw Error(ErrorKind::argument, fmt::format("{} {} is outside the range of refraction", what, value),
                {"", "", fmt::format("Give {}", range)});
  }
}

/// A profile without an observer's conditions of its own, for what only needs the standard.
const AirProfile& standard_profile() {
  static const AirProfile profile{RefractionConditions{}};
  return profile;
}

} // namespace

RefractionConditions standard_conditions(Length height) {
  RefractionConditions conditions;
  conditions.height = height;
  conditions.pressure_hpa = standard_profile().pressure_hpa(height.to(kilometre));
  conditions.temperature_c = standard_profile().temperature_k(height.to(kilometre)) - kelvin;
  return conditions;
}

void validate(const RefractionConditions& c) {
  const double height_m = c.height.to(metre);
  require(height_m >= -500.0 && height_m <= 100000.0, "height", height_m, "-500 to 100000 metres");
  require(c.pressure_hpa >= 0.0 && c.pressure_hpa <= 1100.0, "pressure", c.pressure_hpa, "0 to 1100 hPa");
  require(c.temperature_c >= -90.0 && c.temperature_c <= 60.0, "temperature", c.temperature_c,
          "-90 to 60 degrees Celsius");
  require(c.wavelength_nm >= 300.0 && c.wavelength_nm <= 1700.0, "wavelength", c.wavelength_nm, "300 to 1700 nm");
}

double air_refractivity(double wavelength_nm, double pressure_hpa, double temperature_c) {
  const double micrometres = wavelength_nm * 1.0e-3;
  const double wavenumber2 = 1.0 / (micrometres * micrometres);
  const double standard = 1.0e-8 * (5792105.0 / (238.0185 - wavenumber2) + 167917.0 / (57.362 - wavenumber2));
  constexpr double standard_pa = 101325.0;
  constexpr double standard_c = 15.0;
  const double pa = 100.0 * pressure_hpa;
  const double density = pa / (compressibility(pa, temperature_c) * (temperature_c + kelvin));
  const double standard_density = standard_pa / (compressibility(standard_pa, standard_c) * (standard_c + kelvin));
  return standard * density / standard_density;
}

AirProfile::AirProfile(const RefractionConditions& conditions) : observer_km_(conditions.height.to(kilometre)) {
  validate(conditions);
  const double observer_k = conditions.temperature_c + kelvin;
  const double observer_geopotential = geopotential_km(observer_km_);
  warmer_k_ = observer_k - standard_temperature(observer_geopotential).k;
  // The density's unit cancels: hectopascals over kelvin, of an ideal gas.
  refractivity_per_density_ =
      conditions.pressure_hpa > 0.0
          ? air_refractivity(conditions.wavelength_nm, conditions.pressure_hpa, conditions.temperature_c) * observer_k /
                conditions.pressure_hpa
          : 0.0;

  const auto slope = [&](double h) { return -hydrostatic_k_per_km / (standard_temperature(h).k + warmer_k_); };
  const auto steps = static_cast<std::size_t>(std::ceil((geopotential_km(top_of_air_km) - lowest_km) / step_km));
  nodes_.reserve(steps + 1);
  nodes_.push_back({0.0, step_km * slope(lowest_km)});
  for (std::size_t i = 0; i < steps; ++i) {
    const double from = lowest_km + step_km * static_cast<double>(i);
    const Node below = nodes_.back();
    const double above = step_km * slope(from + step_km);
    // Simpson's rule.
    nodes_.push_back(
        {below.ln_pressure + (below.slope + 4.0 * step_km * slope(from + 0.5 * step_km) + above) / 6.0, above});
  }
  const double wanted = std::log(std::max(conditions.pressure_hpa, 1.0e-30));
  const double shift = wanted - ln_pressure(observer_geopotential);
  for (Node& node : nodes_) {
    node.ln_pressure += shift;
  }
}

double AirProfile::ln_pressure(double geopotential) const {
  const double at = std::clamp((geopotential - lowest_km) / step_km, 0.0, static_cast<double>(nodes_.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(at), nodes_.size() - 2);
  const Node& a = nodes_[i];
  const Node& b = nodes_[i + 1];
  const double f = at - static_cast<double>(i);
  const double g = 1.0 - f;
  // Hermite's cubic: the slopes are those of hydrostatic equilibrium.
  return g * g * ((1.0 + 2.0 * f) * a.ln_pressure + f * a.slope) +
         f * f * ((1.0 + 2.0 * g) * b.ln_pressure - g * b.slope);
}

double AirProfile::temperature_k(double height_km) const {
  return standard_temperature(geopotential_km(std::min(height_km, top_of_air_km))).k + warmer_k_;
}

double AirProfile::pressure_hpa(double height_km) const {
  const double height = std::min(height_km, top_of_air_km);
  return std::exp(ln_pressure(geopotential_km(height)));
}

AirProfile::Air AirProfile::at(double height_km) const {
  const double height = std::min(height_km, top_of_air_km);
  const double geopotential = geopotential_km(height);
  Temperature t = standard_temperature(geopotential);
  t.k += warmer_k_;
  const double refractivity = refractivity_per_density_ * std::exp(ln_pressure(geopotential)) / t.k;
  const double ratio = geopotential_radius_km / (geopotential_radius_km + height);
  return {refractivity, -refractivity * (hydrostatic_k_per_km + t.gradient_k_per_km) / t.k * ratio * ratio};
}

const std::vector<double>& air_profile_corners_km() {
  static const std::vector<double> heights = [] {
    std::vector<double> result{lowest_km, 5.0};
    for (const Corner& corner : corners) {
      for (const double side : {-rounding_km, rounding_km}) {
        result.push_back(geometric_km(corner.height_km + side));
      }
    }
    result.push_back(top_of_air_km);
    return result;
  }();
  return heights;
}

} // namespace vesper
