// How much of the light comes through the air: columns along straight rays by quadrature with a known error.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/light/spectrum.hpp"

#include <vector>

namespace vesper {

/// What a ray passes, whatever its wavelength.
struct AirColumns {
  std::vector<double> km;       ///< of each component: the integral of its profile along the ray
  std::vector<double> error_km; ///< bounds of the quadrature's errors, below 1e-8 of the columns
  bool blocked = false;         ///< the ground is in the way; the columns are then 0
};

/// Columns between two points, in km from the planet's centre, anywhere: in the air, on the ground, outside. Points
/// that lie under the ground by rounding (1e-12 of its radius) are on it. Throws Error(argument) for points that are
/// not finite and for impossible radii.
[[nodiscard]] AirColumns columns_between(const Medium& medium, const Vec3& from_km, const Vec3& to_km);

/// The same from a point to infinity. Throws Error(argument) for a direction that is not of unit length within 1e-9.
[[nodiscard]] AirColumns columns_to_space(const Medium& medium, const Vec3& from_km, const Vec3& direction);

/// The integral of a profile from the ground to the top, in km where the profile is 1.
[[nodiscard]] double zenith_column_km(const HeightProfile& profile, Length ground_radius, Length top_radius);

struct OpticalDepth {
  double value = 0; ///< infinite behind the ground
  double error = 0; ///< bound of the quadrature's error
  [[nodiscard]] double transmittance() const;
};
/// \param columns of the same medium
[[nodiscard]] OpticalDepth optical_depth(const Medium& medium, const AirColumns& columns, double wavelength_nm);

/// Extinction of the zenith seen from a height above the ground, magnitudes in V, for light of this spectrum.
/// Throws Error(argument) when the light has nothing in V.
[[nodiscard]] double zenith_extinction_v_mag(const Medium& medium, Length height, const Spectrum& light);

} // namespace vesper
