// Takes the light of points out of the blocks of extended light, in the tiles that have any.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"
#include "listed_tile.glsl"

layout(local_size_x = 4, local_size_y = 4) in; // the blocks of tiles
layout(binding = 0) uniform sampler2D light;
layout(binding = 1) uniform sampler2D points;
layout(binding = 0, rgba32f) uniform writeonly image2D extended;
layout(location = 0) uniform ivec2 strip; // its first row of blocks, its rows of pixels

void main() {
  ivec2 first = listed_tile(true) + ivec2(int(block_side) * int(gl_LocalInvocationID.x), 0);
  ivec2 count = clamp(ivec2(int(eye.size.x), strip.y) - first, ivec2(0), ivec2(block_side));
  if (count.x * count.y == 0) {
    return;
  }
  vec4 sum = vec4(0.0);
  for (int y = 0; y < count.y; ++y) {
    for (int x = 0; x < count.x; ++x) {
      sum += texelFetch(points, first + ivec2(x, y), 0);
    }
  }
  ivec2 block = first / int(block_side) + ivec2(0, strip.x);
  imageStore(extended, block, texelFetch(light, block, 0) - sum / float(count.x * count.y));
}
