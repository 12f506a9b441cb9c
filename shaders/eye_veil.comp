// The veil on a level: what this level spreads and what the coarser ones do.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"
#include "eye_veil.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) uniform writeonly image2D next_veil;
layout(location = 0) uniform int level;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(next_veil);
  if (any(greaterThanEqual(texel, size))) {
    return;
  }
  vec2 place = (vec2(texel) + 0.5) / vec2(size);
  vec2 pixel = min((vec2(texel) + 0.5) * texel_side(level), eye.size);
  float share = eye_octave_light(level_sigma * texel_side(level) * degrees_per_pixel(pixel), softness(pixel),
                                 eye_scatter_here());
  imageStore(next_veil, texel, share * smooth_spread(place, level) + coarser_veil(place, level));
}
