// What the eye makes of the picture, on level 0: the light it adds to extended light, by glare and by pooling, and the
// shares of extended and of point light that stay where they are.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/mesopic.glsl"
#include "lib/vision.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"
#include "eye_veil.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 3) uniform sampler2D near_shares;
layout(binding = 4) uniform sampler2D extended;
layout(binding = 0, rgba32f) uniform writeonly image2D added;
layout(binding = 1, rg32f) uniform writeonly image2D shares;

const float by_day_cd_m2 = 1.0e3;

// Variance, in pixels, of extended light as a level holds it and the picture reads it: means over texels, a B-spline
// between them, linear interpolation on level 0.
float level_variance(int level) {
  float side = texel_side(level);
  return (side * side - 1.0) / 12.0 + 0.25 * side * side + block_side * block_side / 6.0;
}

vec4 level_light(vec2 pixel, int level) {
  vec2 at = pixel / texel_side(level) - 0.5;
  ivec2 nearest = ivec2(floor(at + 0.5));
  ivec2 size = level_size(level);
  vec4 sum = vec4(0.0);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      vec2 mirror;
      ivec2 from = in_picture(nearest + ivec2(x, y), size, mirror);
      vec2 away = vec2(nearest + ivec2(x, y)) - at;
      sum += b_spline(away.x) * b_spline(away.y) * texelFetch(extended, from, level);
    }
  }
  return sum;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(added);
  if (any(greaterThanEqual(texel, size))) {
    return;
  }
  vec2 place = (vec2(texel) + 0.5) / vec2(size);
  vec2 pixel = min((vec2(texel) + 0.5) * block_side, eye.size);
  vec4 sum = vec4(0.0);
  float kept = 1.0;
  if (eye.glare != 0) {
    vec2 near_share = textureLod(near_shares, place, 0.0).xy;
    kept = near_share.x;
    sum = near_share.y * smooth_spread(place, 0) + coarser_veil(place, 0);
  }
  float pooled = 0.0;
  if (eye.acuity != 0) {
    float scale = degrees_per_pixel(pixel);
    int field = clamp(int(round(log2(1.0 / (block_side * scale)))), 0, eye.cell_level); // a degree
    ivec2 around = min(ivec2(pixel / texel_side(field)), level_size(field) - 1);
    float luminance = kept * texelFetch(extended, around, field).y + sum.y;
    float variance = eye_pooling_variance_deg2(acuity_cycles_per_degree(luminance), acuity_cycles_per_degree(by_day_cd_m2)) /
                     (scale * scale);
    float finest = level_variance(0);
    if (variance <= finest) {
      pooled = variance / finest;
      sum += kept * pooled * level_light(pixel, 0);
    } else {
      pooled = 1.0;
      int level = 0;
      while (level < eye.cell_level - 1 && level_variance(level + 1) < variance) {
        ++level;
      }
      float low = level_variance(level);
      float coarser = clamp((variance - low) / (level_variance(level + 1) - low), 0.0, 1.0);
      sum += kept * mix(level_light(pixel, level), level_light(pixel, level + 1), coarser);
    }
  }
  imageStore(added, texel, sum);
  imageStore(shares, texel, vec4(kept * (1.0 - pooled), kept, 0.0, 0.0));
}
