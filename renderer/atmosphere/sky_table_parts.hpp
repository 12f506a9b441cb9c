// What the tables of the sky have in common with the small ones.
#pragma once

#include "vesper/atmosphere/sampled_air.hpp"
#include "vesper/atmosphere/spectral_air.hpp"
#include "vesper/base/shader_math.hpp"

#include <functional>
#include <vector>

namespace vesper {

/// Nodes of the transmittance and of the aerosol's phase function.
inline constexpr f32::SkyTransmittanceFrame sky_transmittance_nodes{96, 48};
inline constexpr int sky_phase_nodes = 256;

/// The aerosol's phase function near 550 nm for sky_aerosol_phase: the mean over what is no molecule, weighted by what
/// each component scatters from the ground to space.
[[nodiscard]] std::vector<f32::vec4> aerosol_phase_table(const SampledAir& air, const SpectralAir& optics);

/// The table of sky_transmittance_log2.
/// \param texel from the columns of air toward space, called from several threads
[[nodiscard]] std::vector<f32::vec4>
transmittance_table(const SampledAir& air, const std::function<f32::vec4(const SampledAir::PerComponent&)>& texel,
                    unsigned threads);

/// The table of sky_ground_view_log2: the same texels of the air between an observer and the ground, over the way in
/// km.
[[nodiscard]] std::vector<f32::vec4>
ground_view_table(const SampledAir& air, const std::function<f32::vec4(const SampledAir::PerComponent&)>& texel,
                  unsigned threads);

/// Logarithm to base 2, not below the least.
[[nodiscard]] f32::vec4 log2_of(const f32::vec4& light, float least_log2);

} // namespace vesper
