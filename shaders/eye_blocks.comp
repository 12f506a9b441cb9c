// A strip of the frame in blocks of 4 x 4 pixels: their mean light, and where in them it comes from, so that a star's veil
// has the star in its middle.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"

layout(local_size_x = 64) in; // what lies side by side is read together: a fourth less time than for a square
layout(binding = 0) uniform sampler2D frame;
layout(binding = 0, rgba32f) uniform writeonly image2D light;
layout(binding = 1, rg32f) uniform writeonly image2D centre; // in texels, from the texel's middle
layout(binding = 2, rgba32f) uniform writeonly image2D extended; // eye_points.comp writes all three anew where there are points

layout(location = 0) uniform ivec2 strip; // its first row of blocks, its rows of pixels

void main() {
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  ivec2 first = int(block_side) * block;
  ivec2 most = ivec2(int(eye.size.x), strip.y);
  ivec2 count = clamp(most - first, ivec2(0), ivec2(block_side));
  if (count.x * count.y == 0) {
    return;
  }
  vec4 sum = vec4(0.0);
  vec2 moment = vec2(0.0);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      ivec2 pixel = first + ivec2(x, y);
      float part = x < count.x && y < count.y ? 1.0 : 0.0;
      pixel = min(pixel, most - 1);
      vec4 here = part * texelFetch(frame, pixel, 0);
      sum += here;
      moment += max(here.y, 0.0) * vec2(x, y);
    }
  }
  float share = 1.0 / float(count.x * count.y);
  block.y += strip.x;
  imageStore(light, block, share * sum);
  imageStore(centre, block, vec4(block_centre(sum.y, moment), 0.0, 0.0));
  imageStore(extended, block, share * sum);
}
