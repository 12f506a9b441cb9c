// The Moon: a sphere with a map of albedo and normals, lit by Sun and Earth. ECLIPSE has the Earth's shadow on it.
// LAMBERT is the yardstick of the benchmark: the same sphere and map under a law of cosines.
#include "disc_stage.glsl"
#include "lib/eclipse.glsl"
#include "lib/lunar_eclipse.glsl"
#include "lib/moon_surface.glsl"
#include "moon_block.glsl"

layout(binding = 2) uniform samplerCube moon_map; // albedo and normal, mean-Earth axes
#ifdef ECLIPSE
layout(binding = 3) uniform sampler2D eclipse_table;
#endif

int disc_cells(DiscCell pixel) { return meets_disc(pixel) ? cells_for(pixel) : 0; }

vec4 disc_light(DiscCell cell, out float hidden) {
  float r = length(cell.place);
  vec2 outward = cell.place / max(r, 1.0e-9);
  float width = width_along(cell, outward);
  hidden = disc_cover(r, width);
  if (hidden == 0.0) {
    return vec4(0.0);
  }
  vec2 place = disc_inner(r, width) * outward;
  vec3 on_disc = disc_normal(place, block.disc.sine);
  vec3 normal = moon.fixed_from_disc * on_disc;
  vec4 surface = textureLod(moon_map, opengl_cube_direction(normal), moon.map_level);
  vec3 relief = normalize(surface.yzw);
#ifdef LAMBERT
  return surface.x / pi * max(dot(relief, moon.lighting.to_sun), 0.0) * moon.lighting.sunlit * hidden;
#endif
  vec3 to_observer = -(moon.fixed_from_disc * disc_sight(place, block.disc.sine));
  vec4 eclipse = vec4(1.0);
#ifdef ECLIPSE
  vec3 point_km = moon.from_earth_km.xyz + moon.from_earth_km.w * normal;
  eclipse = lunar_eclipse_shares(point_km, moon.shadow, moon.eclipse, eclipse_table);
#endif
  vec4 light = moon_luminance(surface.x, normal, relief, to_observer, moon.lighting, eclipse);
  return light * (hidden * disc_dimming(place, block.disc.sine, block.disc.scale));
}
