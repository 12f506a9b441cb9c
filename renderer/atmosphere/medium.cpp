#include "vesper/atmosphere/medium.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/shader_math.hpp"

#include <cmath>
#include <limits>

namespace vesper {
namespace {

void hold(const std::string& what, double value, double lowest, double highest, double wavelength_nm) {
  if (!(value >= lowest && value <= highest)) {
    throw Error(
        ErrorKind::argument, what + " is " + std::to_string(value),
        {"", std::to_string(wavelength_nm) + " nm",
         "Give " + std::to_string(lowest) + (std::isfinite(highest) ? " to " + std::to_string(highest) : " or more")});
  }
}

} // namespace

double phase_function(PhaseKind kind, double cos_angle, double parameter) {
  switch (kind) {
  case PhaseKind::rayleigh:
    return f64::rayleigh_phase(cos_angle, parameter);
  case PhaseKind::henyey_greenstein:
    return f64::henyey_greenstein_phase(cos_angle, parameter);
  case PhaseKind::cornette_shanks:
    return f64::cornette_shanks_phase(cos_angle, parameter);
  case PhaseKind::schlick:
    return f64::schlick_phase(cos_angle, parameter);
  }
  return 0.0;
}

void validate_radii(const Medium& medium) {
  const double ground_km = medium.ground_radius.to(kilometre);
  const double top_km = medium.top_radius.to(kilometre);
  if (!(ground_km > 0.0 && top_km > ground_km) || !std::isfinite(top_km)) {
    throw Error(ErrorKind::argument,
                "an atmosphere from " + std::to_string(ground_km) + " to " + std::to_string(top_km) + " km",
                {"", "", "Give a positive radius of the ground and a larger one of the top"});
  }
}

void validate(const Medium& medium, double wavelength_nm) {
  validate_radii(medium);
  constexpr double largest = std::numeric_limits<double>::max();
  hold("the ground's albedo", medium.ground_albedo(wavelength_nm), 0.0, 1.0, wavelength_nm);
  for (const MediumComponent& part : medium.components) {
    hold("scattering of " + part.name, part.scattering_per_km(wavelength_nm), 0.0, largest, wavelength_nm);
    hold("absorption of " + part.name, part.absorption_per_km(wavelength_nm), 0.0, largest, wavelength_nm);
    const double parameter = part.phase.parameter(wavelength_nm);
    if (part.phase.kind == PhaseKind::rayleigh) {
      hold("depolarization of " + part.name, parameter, 0.0, 6.0 / 7.0, wavelength_nm);
    } else {
      hold("asymmetry of " + part.name, parameter, -0.99, 0.99, wavelength_nm);
    }
  }
}

} // namespace vesper
