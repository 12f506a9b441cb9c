// Tiles of the picture for vertex stages that leave out those in which nothing shows. Triangle strips of four corners, one
// tile an instance.
layout(location = 0) uniform mat3 horizon_from_view;
layout(location = 1) uniform vec2 size;
layout(location = 2) uniform float focal;
layout(location = 4) uniform vec2 strip;  // first row and number of rows that the framebuffer holds
layout(location = 12) uniform ivec2 tiles; // over the picture

// Its place in the picture, and what it covers of the sky.
struct Tile {
  vec2 low;
  vec2 high;
  vec3 centre; // horizon frame
  float reach; // angle from there to the farthest corner, rad
};

vec3 direction_at(vec2 pixel) {
  vec3 view;
  unproject(pixel, PixelFrame(PROJECTION, size, focal), view);
  return horizon_from_view * view;
}

Tile tile_of(int number) {
  Tile tile;
  tile.low = floor(size * vec2(number % tiles.x, number / tiles.x) / vec2(tiles));
  tile.high = floor(size * (vec2(number % tiles.x, number / tiles.x) + 1.0) / vec2(tiles));
  tile.centre = direction_at(0.5 * (tile.low + tile.high));
  tile.reach = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    vec2 at = vec2((corner & 1) == 0 ? tile.low.x : tile.high.x, (corner & 2) == 0 ? tile.low.y : tile.high.y);
    tile.reach = max(tile.reach, acos(clamp(dot(tile.centre, direction_at(at)), -1.0, 1.0)));
  }
  return tile;
}

// A wide tile may hold more than its corners tell.
bool is_wide(Tile tile) { return tile.reach > 0.4; }

vec4 corner_of(Tile tile, bool shows) {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? tile.low.x : tile.high.x, (gl_VertexID & 2) == 0 ? tile.low.y : tile.high.y);
  corner.y = clamp(corner.y - strip.x, 0.0, strip.y);
  return vec4(shows ? 2.0 * corner / vec2(size.x, strip.y) - 1.0 : vec2(-2.0), 0.0, 1.0);
}
