// Tiles of the picture in which a light's peak may show; the others are folded up. Instances: tiles of the first light,
// then of the second.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#include "sky_block.glsl"
#include "tiles.glsl"

flat out int light;

void main() {
  Tile tile = tile_of(gl_InstanceID % (tiles.x * tiles.y));
  light = gl_InstanceID / (tiles.x * tiles.y);
  float apart = acos(clamp(dot(tile.centre, block.lights[light].apparent.xyz), -1.0, 1.0));
  gl_Position = corner_of(tile, is_wide(tile) || apart < acos(sky_peak_cos) + 1.2 * tile.reach);
}
