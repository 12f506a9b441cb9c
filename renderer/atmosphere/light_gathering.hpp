// The kernels of shaders/lib/light_field.glsl run along a ray, at all wavelengths.
#pragma once

#include "vesper/atmosphere/light_field_model.hpp"

namespace vesper {

/// The light scattered in the air, as the kernels read it: Lights by number and block.
struct LightFieldTables {
  std::vector<Lanes> field;   ///< by node, moment
  std::vector<Lanes> sources; ///< by node below source_heights, direction
  std::vector<Lanes> ground;  ///< log2 of the ground's diffuse irradiance, by angle
};

/// Where a light stands that is seen from the ray's origin under that zenith angle and azimuth from the ray.
[[nodiscard]] f32::LightPlace light_place(const LightRay& ray, double cos_light_zenith, double cos_azimuth);

/// Adds what the ray's scatterers and the ground at its end make of a light that shines on them, before the phase
/// functions.
/// \param by_scatterer lights by scatterer and block
/// \param by_ground by block
void add_direct(const LightFieldModel& model, const LightRay& ray, const f32::LightPlace& light, float light_radius_rad,
                Lanes* by_scatterer, Lanes* by_ground);

/// Adds what they make of the light that was scattered before, by block.
void add_scattered(const LightFieldModel& model, const LightRay& ray, const f32::LightPlace& light,
                   const LightFieldTables& tables, Lanes* by_air, Lanes* by_ground);

} // namespace vesper
