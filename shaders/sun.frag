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

// Share of a cell that the Moon leaves free, and the way out of its disc.
float beside_moon(DiscCell cell, out vec2 outward) {
  outward = vec2(1.0, 0.0);
  if (sun.moon.w == 0.0) {
    return 1.0;
  }
  float scale = block.disc.sine * block.disc.scale;
  vec3 off = disc_sight(cell.place, scale) - sun.moon.xyz;
  float distance = length(off);
  outward = normalize(off.xy + vec2(1.0e-9, 0.0));
  float width = scale * width_along(cell, outward);
  return clamp(0.5 + (distance - sun.moon.w) / width, 0.0, 1.0);
}

vec4 disc_light(DiscCell cell, out float hidden) {
  float r = length(cell.place);
  vec2 outward = cell.place / max(r, 1.0e-9);
  float width = width_along(cell, outward);
  float inside = disc_cover(r, width);
  vec2 from_moon;
  float free = beside_moon(cell, from_moon);
  // Where limbs are parallel one hides the other, or leaves as much as it can: only limbs across each other are as good as
  // independent.
  float along = dot(outward, from_moon);
  float seen = mix(inside * free, along > 0.0 ? max(inside + free - 1.0, 0.0) : min(inside, free), abs(along));
  vec4 light = vec4(0.0);
  if (inside > 0.0) {
    light = seen * sun_disc_luminance(disc_inner(r, width), sun.shading);
  }
#ifdef CORONA
  if (inside < 1.0) {
    vec2 place = vec2(dot(sun.turn.xy, cell.place), dot(sun.turn.zw, cell.place));
    light += (free - seen) * corona_luminance(place * max(1.0, 1.0 / r), sun.shading);
  }
#endif
  hidden = seen;
  if (free == 0.0 || light.y == 0.0) {
    return vec4(0.0);
  }
  return light * disc_dimming(cell.place, block.disc.sine, block.disc.scale);
}
