// A level's light, spread from where it comes to the texels around it; texels past the picture repeat the last ones.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D light;
layout(binding = 1) uniform sampler2D centre;
layout(binding = 0, rgba32f) uniform writeonly image2D spread;
layout(location = 0) uniform int level;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(spread)))) {
    return;
  }
  ivec2 size = level_size(level);
  ivec2 node = min(texel, size - 1);
  vec4 sum = vec4(0.0);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      vec2 mirror;
      ivec2 from = in_picture(node + ivec2(x, y), size, mirror);
      vec2 away = vec2(x, y) + mirror * texelFetch(centre, from, level).xy;
      sum += b_spline(away.x) * b_spline(away.y) * texelFetch(light, from, level);
    }
  }
  imageStore(spread, texel, sum);
}
