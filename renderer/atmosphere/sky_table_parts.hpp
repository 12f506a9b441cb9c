// What all tables of the sky hold, however the light in them is found.
#pragma once

#include "vesper/atmosphere/sampled_air.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/spectral_air.hpp"
#include "vesper/atmosphere/spectral_rule.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace vesper {

/// Nodes of the transmittance and of the aerosol's phase function.
inline constexpr f32::SkyTransmittanceFrame sky_transmittance_nodes{96, 48};
inline constexpr int sky_phase_nodes = 256;

/// A medium at the few wavelengths that tell what the eye makes of sunlight in it.
class SunlitAir {
public:
  /// \param most_wavelengths of spectral_rule
  SunlitAir(const Medium& medium, std::size_t most_wavelengths);

  [[nodiscard]] const SampledAir& air() const { return air_; }
  [[nodiscard]] const SpectralAir& optics() const { return optics_; }

  /// X, Y, Z and S above 1 lux of sunlight, of a ratio to its irradiance by wavelength.
  template <class Values> [[nodiscard]] f32::vec4 responses(const Values& ratio) const {
    Vec4 sum(0.0);
    for (std::size_t l = 0; l < weights_.size(); ++l) {
      sum += static_cast<double>(ratio[l]) * weights_[l];
    }
    return {sum};
  }
  /// Of a ratio of 1 at one wavelength.
  [[nodiscard]] const Vec4& response(std::size_t wavelength) const { return weights_[wavelength]; }

private:
  SpectralRule rule_;
  SampledAir air_;
  SpectralAir optics_;
  std::vector<Vec4> weights_; ///< for 1 lux, by wavelength
};

/// Tables with all that needs no transport of light: frame, phase function, transmittance, light and albedo.
[[nodiscard]] SkyTables tables_without_light(const SunlitAir& sunlit, const SkyTableSize& size, unsigned threads);

/// The table of sky_transmittance_log2.
/// \param texel from the columns of air toward space, called from several threads
[[nodiscard]] std::vector<f32::vec4>
transmittance_table(const SampledAir& air, const std::function<f32::vec4(const SampledAir::PerComponent&)>& texel,
                    unsigned threads);

/// Logarithm to base 2 of what is dark.
inline constexpr float sky_darkest_log2 = -100.0F;
/// Logarithm to base 2, not below the least.
[[nodiscard]] f32::vec4 log2_of(const f32::vec4& light, float least_log2);

} // namespace vesper
