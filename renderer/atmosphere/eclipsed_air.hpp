// How light spreads sideways in the air: what fills the Moon's shadow from around it.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/small_sky_tables.hpp"
#include "vesper/base/shader_math.hpp"

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace vesper {

/// The answer of a medium to sunlight whose strength is a wave over the ground: the diffuse light of all orders.
/// Patterns are sums of waves, so that this is all there is to know of a medium, whatever shadow falls on it.
///
/// The air is level but for the rays in it, which see the Earth's curvature, and scatters evenly to all sides; what
/// aerosol scatters forward, by its asymmetry, counts as not scattered (the similarity relation; van de Hulst 1980,
/// Multiple Light Scattering, ch. 14).
class EclipsedAir {
public:
  /// Heights at which light is known, crowded at the ground; behind them the ground itself is another place of light.
  static constexpr std::array heights_km{0.001F, 0.5F,  1.0F,  2.0F,  3.5F,  5.0F,  7.0F, 9.5F,
                                         12.5F,  16.0F, 20.0F, 25.0F, 32.0F, 42.0F, 60.0F};
  /// Between which of them a height stands.
  struct HeightPlace {
    std::size_t below;
    float above; ///< share of the next
  };
  [[nodiscard]] static HeightPlace height_place(float height_km);
  static constexpr std::size_t ground = heights_km.size();
  static constexpr std::size_t places = heights_km.size() + 1;
  static constexpr std::size_t most_wavelengths = 4;
  /// Of a wavelength, one number a place: mean radiance over the sphere, or irradiance over pi on the ground.
  using Column = std::array<std::complex<double>, places>;
  struct Diffuse {
    Column mean;     ///< as above
    Column vertical; ///< of the light times the squared sine of the altitude it comes from; nothing on the ground
  };

  /// Takes some tenths of a second. Throws Error(argument) for a medium out of its range.
  explicit EclipsedAir(const Medium& medium);

  /// Hillaire's tables of the medium, which light is looked up in along single rays.
  [[nodiscard]] const SkyTables& tables() const { return tables_; }
  [[nodiscard]] std::span<const double> wavelengths_nm() const { return tables_.small->wavelengths_nm; }
  [[nodiscard]] const f32::vec4& albedo() const { return albedo_; }
  /// Share of the aerosol's scattering that counts as none: its asymmetry.
  [[nodiscard]] const f32::vec4& forward() const { return forward_; }

  /// Waves of diffuse light out of waves of sunlight.
  /// \param per_km length of the wave vector, at most most_per_km
  /// \param sunlit mean radiance over the sphere that the Sun's own light makes at each height, W/(m2 sr) or any unit;
  ///        on the ground its irradiance over pi
  [[nodiscard]] Diffuse diffuse(std::size_t wavelength, double per_km, const Column& sunlit) const;

  /// The shortest waves are some 11 km along the diagonals of a chart of 16 km.
  static constexpr double most_per_km = 0.28;

private:
  using Matrix = std::array<std::array<double, places>, places>;
  static constexpr std::size_t wave_count = 96;

  void fill_transfers();
  void solve();

  SkyTables tables_; ///< small ones
  f32::vec4 albedo_{};
  f32::vec4 forward_{};
  std::vector<Matrix> responses_; ///< by wavelength, then wave
  std::vector<Matrix> verticals_; ///< likewise, for Diffuse::vertical, of all light that is sent off
};

} // namespace vesper
