// Hillaire's small tables of the sky (2020, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique",
// Computer Graphics Forum 39, 13): the tier that is ready in milliseconds and needs no memory to speak of.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_query.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/response_functions.hpp"

#include <vector>

namespace vesper {

/// What shaders/lib/small_sky.glsl reads, at four wavelengths. What it leaves out, beside what four wavelengths cannot
/// tell: light scattered more than once is the same in all directions, and comes from a neighbourhood that is lit as
/// evenly as the place itself. docs/SKY_TABLES.md says how wrong that is: little by day, much in twilight.
struct SmallSkyTables {
  f32::SmallSkyFrame frame{};
  f32::SkyTransmittanceFrame transmittance_frame{};
  std::vector<f32::vec4> air;
  std::vector<f32::vec4> transmittance;
  std::vector<f32::vec4> multiple;
  std::vector<f32::vec4> phase;
  std::vector<double> wavelengths_nm; ///< at most four, by spectral_rule
  f32::mat4 responses{};              ///< X, Y, Z, S above 1 lux of sunlight, from the radiances at the wavelengths
  f32::vec4 albedo{};                 ///< of the ground, by wavelength
};

/// Throws Error(argument) for a medium out of its range.
[[nodiscard]] SmallSkyTables make_small_sky_tables(const Medium& medium);

/// Luminance of the air toward an observer anywhere, above 1 lux of sunlight from the query's direction; the ground's
/// own light is not in it. Throws Error(argument) for a query out of its range.
[[nodiscard]] Xyzs sky_luminance(const SmallSkyTables& tables, const SkyQuery& query);

} // namespace vesper
