// Lists the tiles of a strip by whether they hold marked ones of the picture.
#include "prelude.glsl"
#define TILES
#include "point_tiles.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 1) readonly buffer Marks { uint marks[]; };
layout(location = 0) uniform int first_row; // of the strip
layout(location = 1) uniform int last_row;  // of marks

void main() {
  uint tile = gl_GlobalInvocationID.x;
  if (tile >= all) {
    return;
  }
  // A strip may start within a row of the picture's tiles.
  ivec2 rows = (first_row + point_tile.y * int(tile / columns) + ivec2(0, point_tile.y - 1)) / point_tile.y;
  rows = min(rows, last_row);
  ivec2 places = rows * int(columns) + int(tile % columns);
  uint list = marks[places.x] | marks[places.y];
  uint number = atomicAdd(lists[list].count, 1u);
  if (number % (tiles_in_group * groups_across) == 0u) {
    atomicAdd(lists[list].groups.y, 1u);
  }
  tiles[list == 0u ? number : all - 1u - number] = tile % columns + (tile / columns << 16u);
}
