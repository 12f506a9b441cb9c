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
/// parallel beam (the light's angular radius is not looked at).
///
/// Adaptive quadrature along the ray, cut where the planet's shadow begins and ends and where profiles have kinks; the
/// columns towards the light are those of `columns_to_space`, shared by all wavelengths. Milliseconds for a few
/// exponential layers, up to a tenth of a second for `clear_medium` at 48 wavelengths.
///
/// \param wavelengths_nm at least one; the medium is valid at each of them
/// \param relative_error of the quadrature, 1e-8 to 0.1. Radiances below 1e-290 are not held to it.
/// Throws Error(argument) for a query, a wavelength or an error out of its range.
[[nodiscard]] SingleScattering single_scattering(const Medium& medium, const SkyQuery& query,
                                                 const std::vector<double>& wavelengths_nm,
                                                 double relative_error = 1.0e-6);

} // namespace vesper
