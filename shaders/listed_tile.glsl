// For stages that work on one of a strip's lists of tiles: a tile for each row of a group, which has tiles_in_group.
#define TILES readonly
#include "point_tiles.glsl"

// The first pixel, in the strip, of this row's tile; past any picture for a row without one.
ivec2 listed_tile(bool with_points) {
  uint group = gl_WorkGroupID.y * groups_across + gl_WorkGroupID.x;
  uint number = tiles_in_group * group + gl_LocalInvocationID.y;
  uvec2 tile = uvec2(tiles[min(with_points ? all - 1u - number : number, all - 1u)]) >> uvec2(0u, 16u) & 0xffffu;
  bool listed = number < lists[with_points ? 1 : 0].count;
  return listed ? point_tile * ivec2(tile) : ivec2(1 << 24);
}
