// Tiles of the picture in which the sky may show; those outside a fisheye's circle or all below the ground's edge are folded
// up.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "tiles.glsl"

layout(location = 13) uniform float ground_edge_rad; // altitude; less than that of the nadir without ground

void main() {
  Tile tile = tile_of(gl_InstanceID);
  vec3 view;
  bool inside = unproject(clamp(0.5 * size, tile.low, tile.high), PixelFrame(PROJECTION, size, focal), view);
  float highest = asin(clamp(tile.centre.z, -1.0, 1.0)) + 1.2 * tile.reach;
  gl_Position = corner_of(tile, inside && (is_wide(tile) || highest > ground_edge_rad));
}
