// Sunlight at a point of the Earth's shadow, by quadrature.
#pragma once

#include "vesper/atmosphere/earth_shadow_load.hpp"
#include "vesper/atmosphere/grazing_rays.hpp"
#include "vesper/atmosphere/limb_glow.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/light/solar_disc.hpp"

#include <vector>

namespace vesper {

/// The Sun past the Earth's limb, seen through its air.
///
/// Seen from a point at the distance d behind the Earth, a ray with the impact parameter b comes from the angle
/// b (1/d + 1/D) - omega(b) off the line through the Earth's centre; D is the Sun's distance and omega the bending.
/// The air does not change a ray's radiance but by what it takes: so the light is the integral of the Sun's brightness
/// there (LimbDarkening::hestroffer_magnan), times the transmittance, over b db and the angle around the limb.
/// That holds focusing and defocusing, on the axis and at the edge, without any derivative of omega. Added is the
/// limb's own glow (LimbGlow).
class EarthShadowSolver {
public:
  /// \param wavelengths_nm ascending; the medium is valid at each
  EarthShadowSolver(const Medium& medium, std::vector<double> wavelengths_nm, std::vector<EarthShadowLoad> loads);

  [[nodiscard]] const std::vector<double>& wavelengths_nm() const { return wavelengths_nm_; }

  /// Shares of the sunlight without the Earth, by load and wavelength.
  /// \param place_km distance from the shadow's axis, and along it behind the Earth's centre: 1e5 km and more
  [[nodiscard]] std::vector<double> shares(const Vec2& place_km, Length sun_distance) const;

private:
  void add_direct(double ring, double off, double weight, const double* transmittance, std::vector<double>& sums) const;

  std::vector<double> wavelengths_nm_;
  std::vector<EarthShadowLoad> loads_;
  std::vector<GrazingRay> rays_;
  std::vector<double> transmittance_; ///< by ray, load and wavelength
  std::vector<LimbSeries> darkening_; ///< by wavelength
  LimbGlow glow_;
};

} // namespace vesper
