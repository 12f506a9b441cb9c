#include "vesper/light/earthshine.hpp"

#include "vesper/light/checked_geometry.hpp"
#include "vesper/light/sunlight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace vesper {
namespace {

Spectrum make_earth_albedo() {
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (int nm = 300; nm <= 900; nm += 5) {
    wavelengths.push_back(nm);
    values.push_back(earth_geometric_albedo * (0.86 + 0.14 * std::pow(550.0 / nm, 4)));
  }
  return {std::move(wavelengths), std::move(values)};
}

/// Mueller's tint for 440, 550 and 680 nm, against that at 550.
const Spectrum& polynomial_tint() {
  static const Spectrum tint({300.0, 440.0, 550.0, 680.0, 900.0},
                             {1.0 / 0.96, 1.0 / 0.96, 1.0, 0.88 / 0.96, 0.88 / 0.96});
  return tint;
}

/// Mueller's eq. 4 over the Moon's own phase angle. He gives half of what the full Earth sends; only its course is
/// used.
double polynomial(double moon_phase_rad) {
  return moon_phase_rad * moon_phase_rad * (0.0289 - 0.0061 * moon_phase_rad) - 0.0105 * std::sin(moon_phase_rad);
}

} // namespace

const Spectrum& earth_albedo() {
  static const Spectrum albedo = make_earth_albedo();
  return albedo;
}

double earth_phase_light(Angle earth_phase, EarthPhaseLaw law) {
  const double degrees = checked_phase_degrees("the Earth's", earth_phase);
  if (law == EarthPhaseLaw::measured) {
    return std::pow(10.0, -0.4 * degrees * (-1.060e-3 + 2.054e-4 * degrees));
  }
  return std::max(0.0, polynomial(std::numbers::pi - earth_phase.to(rad)) / polynomial(std::numbers::pi));
}

Spectrum earthlight_share(Angle earth_phase, Length distance, EarthPhaseLaw law) {
  hold_positive_distance("a distance of the Moon from the Earth", distance);
  const double share = earth_phase_light(earth_phase, law) * std::pow(earth_mean_radius / distance, 2);
  return law == EarthPhaseLaw::measured ? scaled(earth_albedo(), share)
                                        : scaled(polynomial_tint(), earth_geometric_albedo * share);
}

Spectrum earth_irradiance(Angle earth_phase, Length distance, Length from_sun, EarthPhaseLaw law) {
  hold_positive_distance("a distance of the Earth from the Sun", from_sun);
  return filtered(scaled(solar_irradiance_1au(), std::pow(astronomical_unit / from_sun, 2)),
                  earthlight_share(earth_phase, distance, law));
}

Angle earthlight_phase(Angle from_centre, Angle radius) {
  return std::hypot(from_centre.to(rad), 2.0 / 3.0 * radius.to(rad)) * rad;
}

} // namespace vesper
