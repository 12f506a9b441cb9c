// A coarser net over the columns and rows of a frame's sky map, for stages that change the map.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) uniform image2D map;
layout(binding = 0) uniform sampler2D net; // its layers below one another
layout(location = 0) uniform ivec2 map_rows; // of each layer: below the horizon, above it
layout(location = 1) uniform ivec2 net_rows; // likewise

// Rows of a layer run from the nadir to the horizon, and from there to the end.
float net_row(int row) {
  bool below = row < map_rows.x;
  int half_row = below ? row : row - map_rows.x;
  ivec2 rows = below ? ivec2(map_rows.x, net_rows.x) : ivec2(map_rows.y, net_rows.y);
  float place = float(half_row) / float(rows.x - 1) * float(rows.y - 1);
  return below ? place : float(net_rows.x) + place;
}

// Whether the map's layers have the texel.
bool is_in_layer(ivec2 texel) { return texel.x < imageSize(map).x && texel.y < map_rows.x + map_rows.y; }

ivec2 in_layer(ivec2 texel, int layer) { return texel + ivec2(0, layer * (map_rows.x + map_rows.y)); }

vec4 net_at(ivec2 texel, int layer) {
  vec2 size = vec2(textureSize(net, 0));
  float column = float(texel.x) / float(imageSize(map).x - 1) * (size.x - 1.0);
  float row = float(layer * (net_rows.x + net_rows.y)) + net_row(texel.y);
  return textureLod(net, (vec2(column, row) + 0.5) / size, 0.0);
}
