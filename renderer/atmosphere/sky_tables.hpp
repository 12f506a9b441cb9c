// The sky of a medium, solved for sunlight and kept in tables that the GPU reads: how bright it looks from anywhere.
#pragma once

#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_query.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/response_functions.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace vesper {

/// Nodes of the tables; what they cost and how good they are stands in docs/SKY_TABLES.md.
struct SkyTableSize {
  int heights = 16;
  int views_below = 16; ///< rays that meet the ground
  int views_above = 32;
  int lights = 64;        ///< altitudes of the light, 90 to -36 degrees
  LightFieldSize field{}; ///< how finely the light is solved that fills them
};

struct SmallSkyTables;

/// Light above 1 lux of sunlight (solar_irradiance_1au) outside the air, in X, Y, Z and S: cd/m2, or lux. Texels lie as
/// in shaders/lib/sky_table.glsl, which holds what they mean and how to read them.
struct SkyTables {
  f32::SkyTableFrame frame{};
  std::vector<f32::vec4> aerosol; ///< scattered once, by aerosol; over its phase function
  std::vector<f32::vec4> other;   ///< all other light from the air
  std::vector<f32::vec4> ground;  ///< diffuse illuminance of level ground, by altitude of the light
  std::vector<f32::vec4> phase;   ///< of the aerosol, by angle
  f32::SkyTransmittanceFrame transmittance_frame{};
  std::vector<f32::vec4> transmittance; ///< twice the frame's heights: toward space, then from the ground
  f32::vec4 light{};                    ///< X, Y, Z, S of 1 lux of sunlight
  f32::vec4 albedo{};                   ///< of the ground, in sunlight
  /// In place of `aerosol` and `other`, which are empty then: Hillaire's tier (small_sky_tables.hpp).
  std::shared_ptr<const SmallSkyTables> small;
};

/// The samplers of the tables, for the functions of sky_table.glsl. The tables outlive them.
[[nodiscard]] f32::sampler3D sampler(const SkyTables& tables, const std::vector<f32::vec4>& scattering);
[[nodiscard]] f32::sampler2D transmittance_sampler(const SkyTables& tables);
[[nodiscard]] f32::sampler1D line_sampler(const std::vector<f32::vec4>& texels);

/// Logarithm to base 2 of the aerosol's phase function without its peak: from sky_peak_cos (sky_map.glsl) on the
/// logarithm goes on in a straight line over the cosine.
[[nodiscard]] float log2_phase_without_peak(const SkyTables& tables, float cos_angle);

/// What the functions of sky_table.glsl give, as it is handed out.
[[nodiscard]] Xyzs to_xyzs(const f32::vec4& light);

/// Told from one thread at a time what share of the work is done, 0 to 1. What it throws ends the work.
using Progress = std::function<void(double share)>;

/// Solves the transport of light and fills the tables, in seconds.
/// \param threads 0 for one per core; the result does not depend on it
/// \param solver of the light field, such as gpu::GpuLightGatherer; none for the processor
/// Throws Error(argument) for a medium or a size out of its range.
[[nodiscard]] SkyTables make_sky_tables(const Medium& medium, const SkyTableSize& size = {}, unsigned threads = 0,
                                        const Progress& progress = {}, const LightFieldSolver& solver = {});

/// Mean sources along a view from inside the air, as the tables hold them, not logarithms.
struct SkySources {
  f32::vec4 aerosol{}; ///< over the phase function
  f32::vec4 other{};
};
/// \param azimuth_cos of the view's azimuth from the light's
[[nodiscard]] SkySources sky_sources(const SkyTables& tables, float height_km, float altitude_rad, bool meets_ground,
                                     float light_altitude_rad, float azimuth_cos);

/// Luminance toward an observer anywhere above 1 lux of sunlight from the query's direction, the ground's included
/// where the view meets it. Throws Error(argument) for a query out of its range.
[[nodiscard]] Xyzs sky_luminance(const SkyTables& tables, const SkyQuery& query);

} // namespace vesper
