// The blocks of the tiles that have points of light: extended light without it, and of all light that which scatters. A
// picture that magnifies shows extended sources with as much more light as they are larger, but points as the naked eye
// sees them: so much do they count.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"
#include "listed_tile.glsl"

layout(local_size_x = 4, local_size_y = 4) in; // the blocks of tiles
layout(binding = 0) uniform sampler2D frame;
layout(binding = 1) uniform sampler2D points;
layout(binding = 0, rgba32f) uniform writeonly image2D light;
layout(binding = 1, rg32f) uniform writeonly image2D centre; // in texels, from the texel's middle
layout(binding = 2, rgba32f) uniform writeonly image2D extended;
layout(location = 0) uniform ivec2 strip; // its first row of blocks, its rows of pixels

void main() {
  ivec2 first = listed_tile(true) + ivec2(int(block_side) * int(gl_LocalInvocationID.x), 0);
  ivec2 count = clamp(ivec2(int(eye.size.x), strip.y) - first, ivec2(0), ivec2(block_side));
  if (count.x * count.y == 0) {
    return;
  }
  float magnification = eye.media.w;
  vec4 sum = vec4(0.0);
  vec4 of_extended = vec4(0.0);
  vec2 moment = vec2(0.0);
  for (int y = 0; y < count.y; ++y) {
    for (int x = 0; x < count.x; ++x) {
      vec4 point = texelFetch(points, first + ivec2(x, y), 0);
      vec4 rest = texelFetch(frame, first + ivec2(x, y), 0) - point;
      vec4 here = rest + point / (magnification * magnification);
      sum += here;
      of_extended += rest;
      moment += max(here.y, 0.0) * vec2(x, y);
    }
  }
  float share = 1.0 / float(count.x * count.y);
  ivec2 block = first / int(block_side) + ivec2(0, strip.x);
  imageStore(light, block, share * sum);
  imageStore(centre, block, vec4(block_centre(sum.y, moment), 0.0, 0.0));
  imageStore(extended, block, share * of_extended);
}
