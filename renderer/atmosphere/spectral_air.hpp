// The medium's coefficients at the wavelengths that light is followed at.
#pragma once

#include "vesper/atmosphere/sampled_air.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace vesper {

/// Tables of a medium by component and wavelength. All spans are as long as the wavelengths.
class SpectralAir {
public:
  /// Throws Error(argument) where the medium is not valid at a wavelength (validate in medium.hpp).
  SpectralAir(const Medium& medium, std::vector<double> wavelengths_nm);

  [[nodiscard]] std::size_t size() const { return wavelengths_nm_.size(); }
  [[nodiscard]] const std::vector<double>& wavelengths_nm() const { return wavelengths_nm_; }
  [[nodiscard]] double albedo(std::size_t wavelength) const { return albedo_[wavelength]; }
  [[nodiscard]] double scattering_per_km(std::size_t component, std::size_t wavelength) const {
    return components_[component].scattering_per_km[wavelength];
  }
  [[nodiscard]] double extinction_per_km(std::size_t component, std::size_t wavelength) const {
    return components_[component].extinction_per_km[wavelength];
  }
  /// Over all wavelengths, so that nothing which scatters at one of them is ever overlooked.
  [[nodiscard]] double mean_scattering_per_km(std::size_t component) const {
    return components_[component].mean_scattering_per_km;
  }
  [[nodiscard]] double mean_albedo() const { return mean_albedo_; }
  [[nodiscard]] PhaseKind phase_kind(std::size_t component) const { return components_[component].kind; }
  [[nodiscard]] double phase_parameter(std::size_t component, std::size_t wavelength) const {
    return components_[component].parameter[wavelength];
  }
  /// Per steradian.
  [[nodiscard]] double phase(std::size_t component, std::size_t wavelength, double cos_angle) const;

  [[nodiscard]] double optical_depth(const SampledAir::PerComponent& columns_km, std::size_t wavelength) const {
    double depth = 0.0;
    for (std::size_t c = 0; c < components_.size(); ++c) {
      depth += components_[c].extinction_per_km[wavelength] * columns_km[c];
    }
    return depth;
  }
  /// Whether the columns let less than 1e-26 through at every wavelength: no sky shows it, so nothing behind them is
  /// followed.
  [[nodiscard]] bool opaque(const SampledAir::PerComponent& columns_km) const {
    constexpr double deepest = 60.0;
    double depth = 0.0;
    for (std::size_t c = 0; c < components_.size(); ++c) {
      depth += components_[c].least_extinction_per_km * columns_km[c];
    }
    return depth >= deepest;
  }
  /// Largest by any wavelength of what a kilometre takes away.
  [[nodiscard]] double most_extinction_per_km(const SampledAir::PerComponent& density) const {
    double sum = 0.0;
    for (std::size_t c = 0; c < components_.size(); ++c) {
      sum += components_[c].most_extinction_per_km * density[c];
    }
    return sum;
  }

  /// Multiplies each value by the transmittance of the columns.
  void attenuate(const SampledAir::PerComponent& columns_km, std::span<double> values) const;
  /// Scattering per km and steradian through an angle.
  void scattering(const SampledAir::PerComponent& density, double cos_angle, std::span<double> per_km_sr) const;

private:
  struct Component {
    PhaseKind kind;
    bool same_parameter; ///< at all wavelengths
    double mean_scattering_per_km;
    double least_extinction_per_km;
    double most_extinction_per_km;
    std::vector<double> scattering_per_km;
    std::vector<double> extinction_per_km;
    std::vector<double> parameter;
  };
  std::vector<double> wavelengths_nm_;
  std::vector<double> albedo_;
  double mean_albedo_ = 0.0;
  std::vector<Component> components_;
};

} // namespace vesper
