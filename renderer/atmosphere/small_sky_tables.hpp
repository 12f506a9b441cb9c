// Hillaire's small tables of the sky (2020, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique",
// Computer Graphics Forum 39, 13): the tier that is ready in a fraction of a second and needs no memory to speak of.
#pragma once

#include "vesper/atmosphere/medium.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/base/shader_math.hpp"

#include <vector>

namespace vesper {

/// What shaders/lib/small_sky.glsl reads, at four wavelengths. What it leaves out, beside what four wavelengths cannot
/// tell: light scattered more than once is the same in all directions, and comes from a neighbourhood that is lit as
/// evenly as the place itself. docs/ACCURACY.md says how wrong that is: little by day, much in twilight.
struct SmallSkyTables {
  f32::SmallSkyFrame frame{};
  f32::SkyTransmittanceFrame transmittance_frame{};
  std::vector<f32::vec4> air;
  std::vector<f32::vec4> transmittance;
  std::vector<f32::vec4> multiple;
  std::vector<double> wavelengths_nm; ///< at most four, by spectral_rule
  f32::mat4 responses{};              ///< X, Y, Z, S above 1 lux of sunlight, from the radiances at the wavelengths
};

/// Tables of the sky that hold these in place of the large ones: for all that takes SkyTables.
/// Throws Error(argument) for a medium out of its range.
[[nodiscard]] SkyTables make_small_sky_tables(const Medium& medium);

/// Luminance of the air above 1 lux of sunlight along a view from inside it, in X, Y, Z and S.
[[nodiscard]] f32::SmallSkyLight small_sky_light(const SmallSkyTables& tables, float height_km, float altitude_rad,
                                                 bool meets_ground, float light_altitude_rad, float azimuth_cos);

} // namespace vesper
