// The response functions that every source is integrated against once: colour, night vision, and the V band.
#pragma once

#include "vesper/base/vector.hpp"
#include "vesper/light/spectrum.hpp"

namespace vesper {

/// The four numbers that light has in this renderer. For irradiances x, y, z and s are in lux (y is the illuminance,
/// s the scotopic illuminance), for radiances in cd/m2.
struct Xyzs {
  double x = 0;
  double y = 0;
  double z = 0;
  double s = 0;
};
[[nodiscard]] inline Vec4 vector_of(const Xyzs& light) { return {light.x, light.y, light.z, light.s}; }

/// CIE 1931 chromaticity.
struct Chromaticity {
  double x = 0;
  double y = 0;
};
[[nodiscard]] Chromaticity chromaticity(const Xyzs& light);

/// Maximum luminous efficacies, lm/W, of photopic (CIE 1931, y_bar) and scotopic (CIE 1951, V') vision.
inline constexpr double photopic_efficacy_lm_w = 683.0;
inline constexpr double scotopic_efficacy_lm_w = 1700.0;

/// The range of the response functions, in nm.
inline constexpr int response_first_nm = 360;
inline constexpr int response_last_nm = 830;

/// CIE 1931 2 degree colour-matching functions, 360 to 830 nm. y_bar is V(lambda).
[[nodiscard]] const Spectrum& cie_x_bar();
[[nodiscard]] const Spectrum& cie_y_bar();
[[nodiscard]] const Spectrum& cie_z_bar();
/// CIE 1951 scotopic luminous efficiency, 380 to 780 nm.
[[nodiscard]] const Spectrum& cie_scotopic();
/// Johnson's V band, 470 to 700 nm, as a response to energy (Bessell 1990, PASP 102, 1181, table 2).
[[nodiscard]] const Spectrum& v_band();

/// A spectral irradiance in W/(m2 nm), or radiance in W/(m2 sr nm), through the colour-matching functions and V'.
/// Trapezoidal rule on a grid of 1 nm from 360 to 830 nm.
[[nodiscard]] Xyzs integrate_xyzs(const Spectrum& spectrum);

/// The same light through the V band: W/m2 or W/(m2 sr), weighted by the response.
[[nodiscard]] double integrate_v_band(const Spectrum& spectrum);

} // namespace vesper
