// The tiles of a strip: those without points of light and those with them. renderer/gpu/point_tiles.cpp lists them; TILES
// says how a stage uses the lists.
const ivec2 point_tile = ivec2(16, 4); // pixels
const uint tiles_in_group = 4u;        // of those that work on a list
const uint groups_across = 256u;

struct TileList {
  uvec3 groups; // that work on it: groups_across, rows of them, 1
  uint count;
};
layout(std430, binding = 5) TILES buffer TileLists {
  TileList lists[2]; // without points, with them
  uint columns;      // of tiles
  uint all;          // tiles of the strip
  uint tiles[];      // column + 65536 row; the first list from the front, the second from the end
};
