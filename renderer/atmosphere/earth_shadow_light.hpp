// The sunlight in the Earth's shadow around the Moon's orbit, by wavelength: made once, then looked up.
#pragma once

#include "vesper/atmosphere/earth_shadow_load.hpp"
#include "vesper/atmosphere/medium.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/light/spectrum.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vesper {

/// Shares of the sunlight that reach places of the shadow (EarthShadowSolver): over the distance from the axis
/// (columns) and along it (rows) as shaders/lib/lunar_eclipse.glsl has them, the Sun's distance, the wavelength and
/// Danjon's L.
struct EarthShadowLight {
  f64::LunarEclipseMap frame{};
  std::vector<double> wavelengths_nm; ///< ascending
  double nearest_sun_au = 0.0;        ///< of two distances
  double farthest_sun_au = 0.0;
  /// Minus the logarithms of the shares, in units of 1/2000: by L (0, 1, 2, 3, 4), Sun, row, column and wavelength.
  std::vector<std::uint16_t> log_shares;

  static constexpr double logs_per_unit = 2000.0;
  static constexpr std::size_t suns = 2;
  static constexpr std::size_t rows = 4;
  [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(frame.inner + frame.outer) + 1; }
  [[nodiscard]] std::size_t size() const {
    return earth_shadow_loads.size() * suns * rows * columns() * wavelengths_nm.size();
  }
};

/// Half a second on one core. Throws Error(argument) for an impossible medium.
[[nodiscard]] EarthShadowLight make_earth_shadow_light(const Medium& medium);
/// That of clear_medium(), embedded.
[[nodiscard]] const EarthShadowLight& default_earth_shadow_light();

/// Of one eclipse: as far along the axis as the Moon reaches.
struct EclipseSpectra {
  f64::LunarEclipseMap frame{};
  Length sun_distance;
  std::vector<double> wavelengths_nm;
  std::vector<double> log_shares; ///< by row, column and wavelength

  /// Adds weight times the shares at a place (earth_shadow_place in shaders/lib/eclipse.glsl).
  void add(const Vec2& place_km, const f64::EarthShadow& shadow, double weight, std::span<double> shares) const;
  /// Shares over 360 to 830 nm, their logarithms linear in the wavelength to the power of -4.
  [[nodiscard]] Spectrum spectrum(std::span<const double> shares) const;
};

/// \param moon_along of the Moon's centre along the axis: 355 to 408 thousand km; beyond, that of the nearer end
/// \param sun_distance of the Earth: 0.982 to 1.018 au; beyond, as well
/// \param danjon L, 0 to 4. Throws Error(argument) otherwise.
[[nodiscard]] EclipseSpectra eclipse_spectra(const EarthShadowLight& light, Length moon_along, Length sun_distance,
                                             double danjon);

/// What lunar_eclipse_shares reads.
struct LunarEclipseTable {
  f64::LunarEclipseFrame frame{};
  std::vector<Vec4> texels; ///< shares of X, Y, Z, S, row by row

  [[nodiscard]] f64::sampler2D sampler() const { return {texels.data(), frame.columns, frame.rows}; }
};
/// \param moonlight without an eclipse, in any unit
[[nodiscard]] LunarEclipseTable lunar_eclipse_table(const EclipseSpectra& spectra, const Spectrum& moonlight);

} // namespace vesper
