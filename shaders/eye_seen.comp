// What the eye makes of the picture, on level 0: the light it adds to extended light, by glare and by pooling, and the
// shares of extended and of point light that stay where they are.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/mesopic.glsl"
#include "lib/vision.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1) uniform sampler2D veil;
layout(binding = 3) uniform sampler2D near_shares;
layout(binding = 0, rgba32f) uniform writeonly image2D added;
layout(binding = 1, rg32f) uniform writeonly image2D shares;
layout(binding = 2, rgba32f) uniform readonly image2D extended; // all levels

const float by_day_cd_m2 = 1.0e3;

// Variance, in pixels, of extended light as a level holds it and the picture reads it: means over texels, a B-spline
// between them, linear interpolation on level 0.
float level_variance(int level) {
  float side = texel_side(level);
  return (side * side - 1.0) / 12.0 + 0.25 * side * side + block_side * block_side / 6.0;
}

// Quadratic B-splines of the texels beside and here, for a place that is off the middle by -0.5 to 0.5.
vec3 b_splines(float off) {
  return vec3(0.5 * (0.5 - off) * (0.5 - off), 0.75 - off * off, 0.5 * (0.5 + off) * (0.5 + off));
}

vec4 light_in_row(int row, ivec3 columns, vec3 weights) {
  return weights.x * imageLoad(extended, ivec2(columns.x, row)) + weights.y * imageLoad(extended, ivec2(columns.y, row)) +
         weights.z * imageLoad(extended, ivec2(columns.z, row));
}

vec4 level_light(vec2 pixel, int level) {
  vec2 at = pixel / texel_side(level);
  ivec2 nearest = ivec2(at);
  vec2 off = at - vec2(nearest) - 0.5;
  ivec2 size = level_size(level);
  ivec3 columns = columns_beside(nearest.x, size.x);
  ivec3 rows = level_origin(level, imageSize(extended)).y + beside(nearest.y, size.y);
  vec3 across = b_splines(off.x);
  vec3 down = b_splines(off.y);
  return down.x * light_in_row(rows.x, columns, across) + down.y * light_in_row(rows.y, columns, across) +
         down.z * light_in_row(rows.z, columns, across);
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
    kept = textureLod(near_shares, place, 0.0).x;
    sum = textureLod(veil, place, float(finest_veil));
  }
  float pooled = 0.0;
  if (eye.acuity != 0) {
    float scale = degrees_per_pixel(pixel);
    int field = clamp(int(round(log2(1.0 / (block_side * scale)))), 0, eye.cell_level); // a degree
    ivec2 around = min(ivec2(pixel / texel_side(field)), level_size(field) - 1);
    float luminance = kept * imageLoad(extended, level_origin(field, imageSize(extended)) + around).y + sum.y;
    float variance = eye_pooling_variance_deg2(acuity_cycles_per_degree(luminance), acuity_cycles_per_degree(by_day_cd_m2)) /
                     (scale * scale);
    // Two levels around it, or the sharp picture and the finest level.
    int level = 0;
    while (level < eye.cell_level - 1 && level_variance(level + 1) < variance) {
      ++level;
    }
    float low = level_variance(level);
    float coarser = clamp((variance - low) / (level_variance(level + 1) - low), 0.0, 1.0);
    pooled = min(variance / low, 1.0);
    vec4 light = mix(level_light(pixel, level), level_light(pixel, level + 1), coarser);
    // Nothing is seen past a fisheye's circle, no darkness either.
    float seen = share_in_circle(pixel, sqrt(mix(low, level_variance(level + 1), coarser)), eye_frame());
    sum += kept * pooled * light / max(seen, 0.25);
  }
  imageStore(added, texel, sum);
  imageStore(shares, texel, vec4(kept * (1.0 - pooled), kept, 0.0, 0.0));
}
