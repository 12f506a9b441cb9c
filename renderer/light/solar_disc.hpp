// How the light of the Sun is spread over its disc, by wavelength: darker and redder toward the limb.
#pragma once

#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectrum.hpp"

#include <array>
#include <cstddef>

namespace vesper {

/// Published laws of the disc's brightness against mu, the cosine of the angle between line of sight and normal.
enum class LimbDarkening {
  /// mu^a (Neckel 1996, Solar Physics 167, 9, with u = 1): black at the very limb.
  neckel,
  /// A polynomial of fifth degree in mu (Neckel and Labs 1994, Solar Physics 153, 91, the measurements that Hestroffer
  /// and Magnan 1998, A&A 333, 338, rest on), linear between 30 wavelengths from 303 to 1099 nm and constant beyond.
  hestroffer_magnan,
};

/// Neckel's power a: 0.652 at 440 nm, 0.503 at 550 and 0.397 at 680, linear between them and beyond, and not below 0.
[[nodiscard]] double limb_darkening_power(double wavelength_nm);

/// Brightness of the disc over that at its centre.
/// \param mu 0 (limb) to 1 (centre); sqrt(1 - r^2) at a share r of the disc's radius from its centre
[[nodiscard]] double solar_limb_darkening(double wavelength_nm, double mu,
                                          LimbDarkening law = LimbDarkening::hestroffer_magnan);

/// Mean of solar_limb_darkening over the disc.
[[nodiscard]] double solar_disc_mean(double wavelength_nm, LimbDarkening law = LimbDarkening::hestroffer_magnan);

/// Either law as a sum of powers of mu that are the same for all wavelengths, so that light of many wavelengths adds up
/// term by term: brightness over the disc's mean = sum of terms[k] mu^(lowest + k step). Neckel's powers, 0.26 to 0.76,
/// are interpolated (Lagrange): within 6e-5 of the disc's mean from 360 to 830 nm, the range of the response functions.
inline constexpr std::size_t limb_terms = 6;
using LimbSeries = std::array<double, limb_terms>;
struct LimbPowers {
  double lowest;
  double step;
  [[nodiscard]] double operator[](std::size_t k) const { return lowest + step * static_cast<double>(k); }
  /// Mean of the k-th power over the disc.
  [[nodiscard]] double disc_mean(std::size_t k) const { return 2.0 / ((*this)[k] + 2.0); }
};
[[nodiscard]] LimbPowers limb_powers(LimbDarkening law);
[[nodiscard]] LimbSeries limb_series(double wavelength_nm, LimbDarkening law);

/// The terms of the disc's brightness through the response functions, over its solid angle: in lux for the spectrum of
/// the whole disc in W/(m2 nm). Over the disc they add up to integrate_xyzs(disc), to rounding.
[[nodiscard]] std::array<Xyzs, limb_terms> limb_xyzs(const Spectrum& disc, LimbDarkening law);

} // namespace vesper
