#include "report/table_light.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/atmosphere/level_illuminance.hpp"

namespace vesper {
namespace {

SourceLight source_light(const SkyTables& tables, Length height, const SkyLight& light) {
  const Mat4 matrix = from_table_light(light);
  const auto of_light = [&](const Xyzs& of_table) { return matrix * vector_of(of_table); };
  const Angle altitude = latitude_of(light.direction);
  const Vec4 zenith = of_light(sky_luminance(tables, {height, light.direction, light.angular_radius, {0.0, 0.0, 1.0}}));
  return {of_light(direct_illuminance(tables, height, altitude, light.angular_radius)).y,
          of_light(diffuse_illuminance(tables, height, altitude)).y, zenith.y, zenith.w};
}

} // namespace

SceneLight table_light(const SkyTables& tables, Length height, const std::vector<SkyLight>& lights) {
  SceneLight scene;
  for (const SkyLight& light : lights) {
    (light.name == "sun" ? scene.sun : scene.moon) = source_light(tables, height, light);
  }
  return scene;
}

} // namespace vesper
