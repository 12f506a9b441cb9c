// The air as light meets it: components, each with a profile, coefficients by wavelength and a phase function.
#pragma once

#include "vesper/atmosphere/height_profile.hpp"
#include "vesper/base/units.hpp"

#include <functional>
#include <string>
#include <vector>

namespace vesper {

/// A number that depends on the wavelength in nm. A Spectrum is one too (0 outside its samples).
using WavelengthLaw = std::function<double(double wavelength_nm)>;

/// The same at all wavelengths.
[[nodiscard]] inline WavelengthLaw constant_law(double value) {
  return [value](double) { return value; };
}

enum class PhaseKind {
  rayleigh,          ///< its parameter is the depolarization, 0 to 6/7
  henyey_greenstein, ///< for this and the following the parameter is the asymmetry, -0.99 to 0.99
  cornette_shanks,
  schlick,
};

/// Per steradian; the angle is that between the light's old and new direction (shaders/lib/phase.glsl).
[[nodiscard]] double phase_function(PhaseKind kind, double cos_angle, double parameter);

/// Into which directions a component scatters.
struct PhaseFunction {
  PhaseKind kind = PhaseKind::rayleigh;
  WavelengthLaw parameter;

  [[nodiscard]] double operator()(double cos_angle, double wavelength_nm) const {
    return phase_function(kind, cos_angle, parameter(wavelength_nm));
  }
};

/// One kind of matter in the air. Coefficients are those where its profile is 1, per km, >= 0.
struct MediumComponent {
  std::string name;
  HeightProfile profile;
  WavelengthLaw scattering_per_km;
  WavelengthLaw absorption_per_km;
  PhaseFunction phase;

  [[nodiscard]] double extinction_per_km(double wavelength_nm) const {
    return scattering_per_km(wavelength_nm) + absorption_per_km(wavelength_nm);
  }
};

/// A spherical atmosphere over a spherical ground. Components may overlap; what reaches above the top is cut off.
struct Medium {
  Length ground_radius;
  Length top_radius;
  WavelengthLaw ground_albedo; ///< of a Lambertian ground, 0 to 1
  std::vector<MediumComponent> components;
  /// Where light transport is to be solved, ascending: dense enough that what happens between is linear.
  std::vector<double> wavelengths_nm;
};

/// Throws Error(argument) for radii that bound no shell of air.
void validate_radii(const Medium& medium);

/// Checks the radii, and what depends on the wavelength at this one. Throws Error(argument) naming the component, the
/// value and its range.
void validate(const Medium& medium, double wavelength_nm);

} // namespace vesper
