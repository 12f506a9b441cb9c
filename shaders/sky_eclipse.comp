// Dims the map of a frame's sky (sky_map.comp) by what an eclipse of the Sun leaves of it. The ratios stand on a coarser
// net over the same columns and rows: layer 0 of all light, layer 1 of what aerosol scatters once of the first light, the Sun's. All are logarithms.
#include "prelude.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) uniform image2D map;
layout(binding = 0) uniform sampler2D ratios;
layout(location = 0) uniform ivec2 map_rows;   // of each layer: below the horizon, above it
layout(location = 1) uniform ivec2 ratio_rows; // likewise

// Rows of a layer run from the nadir to the horizon, and from there to the end.
float ratio_row(int row) {
  bool below = row < map_rows.x;
  int half_row = below ? row : row - map_rows.x;
  ivec2 rows = below ? ivec2(map_rows.x, ratio_rows.x) : ivec2(map_rows.y, ratio_rows.y);
  float place = float(half_row) / float(rows.x - 1) * float(rows.y - 1);
  return below ? place : float(ratio_rows.x) + place;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  int rows = map_rows.x + map_rows.y;
  int width = imageSize(map).x;
  if (texel.x >= width || texel.y >= rows) {
    return;
  }
  vec2 size = vec2(textureSize(ratios, 0));
  float column = float(texel.x) / float(width - 1) * (size.x - 1.0);
  float row = ratio_row(texel.y);
  for (int layer = 0; layer < 2; ++layer) {
    float first = float(layer * (ratio_rows.x + ratio_rows.y));
    ivec2 at = texel + ivec2(0, layer * rows);
    vec4 ratio = textureLod(ratios, (vec2(column, first + row) + 0.5) / size, 0.0);
    imageStore(map, at, imageLoad(map, at) + ratio);
  }
}
