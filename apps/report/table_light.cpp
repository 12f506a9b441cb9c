#include "report/table_light.hpp"

#include "vesper/astro/spherical.hpp"
#include "vesper/atmosphere/level_illuminance.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"

namespace vesper {
namespace {

SourceLight source_light(const SkyTables& tables, Length height, const SkyLight& light) {
  const Mat4 matrix = from_table_light(light);
  const auto lux_or_cd_m2 = [&](const Xyzs& of_table) { return (matrix * vector_of(of_table)).y; };
  const Angle altitude = latitude_of(light.direction);
  return {lux_or_cd_m2(direct_illuminance(tables, height, altitude, light.angular_radius)),
          lux_or_cd_m2(diffuse_illuminance(tables, height, altitude)),
          lux_or_cd_m2(sky_luminance(tables, {height, light.direction, light.angular_radius, {0.0, 0.0, 1.0}}))};
}

} // namespace

Mat4 from_table_light(const SkyLight& light) {
  const double all = integrate_xyzs(light.irradiance).y;
  return all > 0.0 ? all * response_matrix(solar_irradiance_1au(), light.irradiance) : Mat4(0.0);
}

SceneLight table_light(const SkyTables& tables, Length height, const std::vector<SkyLight>& lights) {
  SceneLight scene;
  for (const SkyLight& light : lights) {
    (light.name == "sun" ? scene.sun : scene.moon) = source_light(tables, height, light);
  }
  return scene;
}

} // namespace vesper
