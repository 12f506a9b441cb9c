#include "vesper/atmosphere/spectral_air.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace vesper {
SpectralAir::SpectralAir(const Medium& medium, std::vector<double> wavelengths_nm)
    : wavelengths_nm_(std::move(wavelengths_nm)) {
  if (wavelengths_nm_.empty() || std::adjacent_find(wavelengths_nm_.begin(), wavelengths_nm_.end(),
                                                    std::greater_equal<>()) != wavelengths_nm_.end()) {
    throw Error(ErrorKind::argument, "wavelengths that are none or do not rise",
                {"", "", "Give at least one, in ascending order"});
  }
  for (const MediumComponent& part : medium.components) {
    components_.push_back({part.phase.kind, true, 0.0, 0.0, 0.0, {}, {}, {}});
  }
  for (const double nm : wavelengths_nm_) {
    validate(medium, nm);
    albedo_.push_back(medium.ground_albedo(nm));
    for (std::size_t c = 0; c < components_.size(); ++c) {
      components_[c].scattering_per_km.push_back(medium.components[c].scattering_per_km(nm));
      components_[c].extinction_per_km.push_back(medium.components[c].extinction_per_km(nm));
      components_[c].parameter.push_back(medium.components[c].phase.parameter(nm));
    }
  }
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  mean_albedo_ = mean(albedo_);
  for (Component& component : components_) {
    component.mean_scattering_per_km = mean(component.scattering_per_km);
    const auto [least, most] =
        std::minmax_element(component.extinction_per_km.begin(), component.extinction_per_km.end());
    component.least_extinction_per_km = *least;
    component.most_extinction_per_km = *most;
    component.same_parameter = std::adjacent_find(component.parameter.begin(), component.parameter.end(),
                                                  std::not_equal_to<>()) == component.parameter.end();
  }
}

double SpectralAir::phase(std::size_t component, std::size_t wavelength, double cos_angle) const {
  return phase_function(components_[component].kind, cos_angle, components_[component].parameter[wavelength]);
}

void SpectralAir::attenuate(const SampledAir::PerComponent& columns_km, std::span<double> values) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] *= std::exp(-optical_depth(columns_km, i));
  }
}

void SpectralAir::scattering(const SampledAir::PerComponent& density, double cos_angle,
                             std::span<double> per_km_sr) const {
  std::fill(per_km_sr.begin(), per_km_sr.end(), 0.0);
  for (std::size_t c = 0; c < components_.size(); ++c) {
    const Component& part = components_[c];
    if (density[c] == 0.0) {
      continue;
    }
    const double first =
        part.same_parameter ? density[c] * phase_function(part.kind, cos_angle, part.parameter[0]) : 0.0;
    for (std::size_t i = 0; i < per_km_sr.size(); ++i) {
      const double phase =
          part.same_parameter ? first : density[c] * phase_function(part.kind, cos_angle, part.parameter[i]);
      per_km_sr[i] += part.scattering_per_km[i] * phase;
    }
  }
}

} // namespace vesper
