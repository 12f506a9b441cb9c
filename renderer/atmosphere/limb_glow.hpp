// The Earth's limb seen against the Sun: light that the air scatters, forward, into the Earth's shadow.
#pragma once

#include "vesper/atmosphere/earth_shadow_load.hpp"
#include "vesper/atmosphere/medium.hpp"

#include <span>
#include <vector>

namespace vesper {

/// Light scattered once along straight lines past the Earth, by the angle between the line of sight and the Sun in the
/// plane through the Earth's centre. What is scattered more often, or comes from the ground, is left out: in the blue,
/// where little else comes, some tens of per cent.
class LimbGlow {
public:
  /// \param medium with_stratospheric_dust
  LimbGlow(const Medium& medium, const std::vector<double>& wavelengths_nm, std::span<const EarthShadowLoad> loads);

  /// Adds weight times the integral of the radiance over the irradiance, 1/sr, times the distance from the Earth's
  /// centre in km, over that distance.
  /// \param above_sun_rad how far the lowest line of sight passes above the Sun
  void add(std::size_t load, double above_sun_rad, double weight, std::span<double> sums) const;

private:
  std::size_t wavelengths_;
  std::vector<double> log_sums_; ///< by load, angle and wavelength
};

} // namespace vesper
