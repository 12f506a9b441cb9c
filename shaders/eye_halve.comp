// A level of the pyramid from the finer one before it.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D light;
layout(binding = 1) uniform sampler2D centre;
layout(binding = 0, rgba32f) uniform writeonly image2D next_light;
layout(binding = 1, rg32f) uniform writeonly image2D next_centre;
#ifdef POINTS
layout(binding = 2) uniform sampler2D extended;
layout(binding = 2, rgba32f) uniform writeonly image2D next_extended;
#endif
layout(location = 0) uniform int level; // to make

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, level_size(level)))) {
    return;
  }
  // How much of the children's columns and rows lies in the picture.
  vec4 parts = clamp((eye.size / texel_side(level - 1) - 2.0 * vec2(texel)).xyxy - vec4(0.0, 0.0, 1.0, 1.0), 0.0, 1.0);
  vec4 sum = vec4(0.0);
  vec4 of_extended = vec4(0.0);
  vec2 moment = vec2(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    float part = parts[2 * offset.x] * parts[2 * offset.y + 1];
    ivec2 child = 2 * texel + offset * int(part > 0.0);
    vec4 here = part * texelFetch(light, child, level - 1);
    sum += here;
    moment += max(here.y, 0.0) * (0.5 * (texelFetch(centre, child, level - 1).xy + vec2(offset)) - 0.25);
#ifdef POINTS
    of_extended += part * texelFetch(extended, child, level - 1);
#endif
  }
  float weight = (parts.x + parts.z) * (parts.y + parts.w);
  imageStore(next_light, texel, sum / weight);
  imageStore(next_centre, texel, vec4(sum.y > 0.0 ? clamp(moment / sum.y, -0.5, 0.5) : vec2(0.0), 0.0, 0.0));
#ifdef POINTS
  imageStore(next_extended, texel, of_extended / weight);
#endif
}
