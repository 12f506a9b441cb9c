// The Moon: a sphere with a map of albedo and normals, lit by Sun and Earth. ECLIPSE has the Earth's shadow on it,
// CRESCENT adds up the Sun's light where it falls. LAMBERT is the yardstick of the benchmark: the same sphere and map
// under a law of cosines.
#include "disc_stage.glsl"
#include "lib/eclipse.glsl"
#include "lib/lunar_eclipse.glsl"
#include "lib/moon_surface.glsl"
#include "moon_block.glsl"

layout(binding = 2) uniform samplerCube moon_map; // albedo and normal, mean-Earth axes
#ifdef ECLIPSE
layout(binding = 3) uniform sampler2D eclipse_table;
#endif

#ifdef CRESCENT
int disc_cells(DiscCell pixel) { return meets_disc(pixel) ? 1 : 0; }
#else
int disc_cells(DiscCell pixel) { return meets_disc(pixel) ? cells_for(pixel) : 0; }
#endif

// What a pixel's places share.
struct MoonSight {
  vec3 to_observer; // along mean-Earth axes, like all that follow
  float dimming;    // of a larger picture
};

MoonSight moon_sight(vec2 place) {
  return MoonSight(-(moon.fixed_from_disc * disc_sight(place, block.disc.sine)),
                   disc_dimming(place, block.disc.sine, block.disc.scale));
}

struct MoonPlace {
  vec3 normal; // of the sphere
  vec3 relief;
  float albedo;
};

MoonPlace moon_place(vec2 place, float level) {
  vec3 normal = moon.fixed_from_disc * disc_normal(place, block.disc.sine);
  vec4 surface = textureLod(moon_map, opengl_cube_direction(normal), level);
  return MoonPlace(normal, normalize(surface.yzw), surface.x);
}

#ifdef CRESCENT
// A crescent is thinner than its pixels, and rough where the Sun stands low: lines through the pixel, across the limb
// rather than along it, are followed from limb to terminator and no further, in even steps over the sphere. Earthlight
// is that of one place in the pixel's middle, which goes before those of the first line in the same loop: where a loop
// has no step to take, a software rasteriser takes one for nothing.
vec4 disc_light(DiscCell pixel, out float hidden) {
  float r = length(pixel.place);
  vec2 outward = pixel.place / max(r, 1.0e-9);
  float width = width_along(pixel, outward);
  hidden = disc_cover(r, width);
  vec3 to_sun = moon.lighting.to_sun * moon.fixed_from_disc;
  float reach = lunar_relief_reach + block.disc.sine;
  float extent = 0.5 * (length(pixel.across) + length(pixel.down));
  float nearest = min(r + extent, 1.0);
  bool lit = disc_is_lit(reach + dot(to_sun.xy, pixel.place) + length(to_sun.xy) * extent, nearest * nearest - 1.0,
                         to_sun.z * to_sun.z);
  float along_across = abs(dot(pixel.across, pixel.place)) / length(pixel.across);
  float along_down = abs(dot(pixel.down, pixel.place)) / length(pixel.down);
  vec2 line = along_across > along_down ? pixel.across : pixel.down;
  vec2 beside = along_across > along_down ? pixel.down : pixel.across;
  int lines = lit ? clamp(int(ceil(moon.crescent_cells * length(beside))), 1, most_cells) : 1;
  vec2 middle = disc_inner(r, width) * outward;
  MoonSight sight = moon_sight(middle);
  float by_sun = 0.0;
  float by_earth = 0.0;
  for (int i = 0; i < lines; ++i) {
    vec2 from = pixel.place + ((float(i) + 0.5) / float(lines) - 0.5) * beside - 0.5 * line;
    DiscArc arc = disc_lit_arc(from, line, to_sun, reach);
    float angle = arc.end - arc.start;
    int cells = lit && angle > 0.0 ? clamp(int(ceil(moon.crescent_cells * angle)), 1, most_cells) : 0;
    float step = angle / float(max(cells, 1));
    float weight = arc.radius * step / float(lines);
    float first = arc.start + (float(i) + 0.5) / float(lines) * step; // lines stagger their places
    vec2 at_angle = vec2(sin(first), cos(first));
    vec2 turn = vec2(sin(step), cos(step));
    for (int k = i == 0 ? -1 : 0; k < cells; ++k) {
      bool earthlit = k < 0;
      vec2 place = earthlit ? middle : from + (arc.middle + arc.radius * at_angle.x) * line;
      float share = earthlit ? hidden : weight * at_angle.y;
      MoonPlace at = moon_place(place, earthlit ? moon.map_level : 0.0);
      float light = share * at.albedo *
                    lunar_relief_reflectance(at.normal, at.relief, sight.to_observer,
                                             earthlit ? moon.lighting.to_earth : moon.lighting.to_sun,
                                             earthlit ? earth_radius_from_moon_rad : moon.lighting.sun_radius_rad,
                                             earthlit ? moon.lighting.earth_law : moon.lighting.sun_law);
      by_earth += earthlit ? light : 0.0;
      by_sun += earthlit ? 0.0 : light;
      at_angle = earthlit ? at_angle
                          : vec2(at_angle.x * turn.y + at_angle.y * turn.x, at_angle.y * turn.y - at_angle.x * turn.x);
    }
  }
  return sight.dimming / pi * (by_sun * moon.lighting.sunlit + by_earth * moon.lighting.earthlit);
}
#else
vec4 disc_light(DiscCell cell, out float hidden) {
  float r = length(cell.place);
  vec2 outward = cell.place / max(r, 1.0e-9);
  float width = width_along(cell, outward);
  hidden = disc_cover(r, width);
  if (hidden == 0.0) {
    return vec4(0.0);
  }
  vec2 place = disc_inner(r, width) * outward;
  MoonPlace at = moon_place(place, moon.map_level);
  MoonSight sight = moon_sight(place);
  at.albedo *= sight.dimming;
#ifdef LAMBERT
  return at.albedo / pi * max(dot(at.relief, moon.lighting.to_sun), 0.0) * moon.lighting.sunlit * hidden;
#endif
  vec4 eclipse = vec4(1.0);
#ifdef ECLIPSE
  vec3 point_km = moon.from_earth_km.xyz + moon.from_earth_km.w * at.normal;
  eclipse = lunar_eclipse_shares(point_km, moon.shadow, moon.eclipse, eclipse_table);
#endif
  return hidden * moon_luminance(at.albedo, at.normal, at.relief, sight.to_observer, moon.lighting, eclipse);
}

#endif
