// Light that was scattered or reflected once, by quadrature with a known error.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_query.hpp"

#include <vector>

namespace vesper {

struct SingleScattering {
  std::vector<double> radiance; ///< 1/sr above an irradiance of 1, at the wavelengths asked for
  std::vector<double> error;    ///< bound of the quadrature's error
};

/// Radiance that arrives from the view direction after one scattering in the air or one reflection at the ground, for a
/// parallel beam (the light's angular radius is not looked at). Throws Error(argument) for a query out of its range.
[[nodiscard]] SingleScattering single_scattering(const Medium& medium, const SkyQuery& query,
                                                 const std::vector<double>& wavelengths_nm,
                                                 double relative_error = 1.0e-6);

} // namespace vesper
