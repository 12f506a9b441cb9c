// The Sun's disc and, with CORONA, the light around it; what the Moon hides is left out.
#include "disc_stage.glsl"
#include "lib/sun.glsl"
#include "sun_block.glsl"

int disc_cells(DiscCell pixel) {
#ifdef CORONA
  const int beside_disc = 1;
#else
  const int beside_disc = 0;
#endif
  return meets_disc(pixel) ? cells_for(pixel) : beside_disc;
}

// Share of a cell that the Moon leaves free.
float beside_moon(DiscCell cell) {
  if (sun.moon.w == 0.0) {
    return 1.0;
  }
  float scale = block.disc.sine * block.disc.scale;
  vec3 off = disc_sight(cell.place, scale) - sun.moon.xyz;
  float distance = length(off);
  vec2 outward = normalize(off.xy + vec2(1.0e-9, 0.0));
  float width = scale * width_along(cell, outward);
  return clamp(0.5 + (distance - sun.moon.w) / width, 0.0, 1.0);
}

vec4 disc_light(DiscCell cell, out float hidden) {
  float r = length(cell.place);
  vec2 outward = cell.place / max(r, 1.0e-9);
  float width = width_along(cell, outward);
  float inside = disc_cover(r, width);
  float free = beside_moon(cell);
  vec4 light = vec4(0.0);
  if (inside > 0.0) {
    light = inside * sun_disc_luminance(disc_inner(r, width), sun.shading);
  }
#ifdef CORONA
  if (inside < 1.0) {
    vec2 place = vec2(dot(sun.turn.xy, cell.place), dot(sun.turn.zw, cell.place));
    light += (1.0 - inside) * corona_luminance(place * max(1.0, 1.0 / r), sun.shading);
  }
#endif
  hidden = inside * free;
  if (free == 0.0 || light.y == 0.0) {
    return vec4(0.0);
  }
  return light * (free * disc_dimming(cell.place, block.disc.sine, block.disc.scale));
}
