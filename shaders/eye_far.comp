// The far part of the veil, by the true angles between directions, and the shares of the light that stay: on the level
// above the cells.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"
#include "eye_lights.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform samplerBuffer light_texels; // EyeLights, which is read faster so
layout(binding = 0, rgba32f) uniform writeonly image2D far_veil;
layout(binding = 1, rg32f) uniform writeonly image2D near_shares; // x: kept in place

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(far_veil)))) {
    return;
  }
  vec2 pixel = min((vec2(texel) + 0.5) * texel_side(eye.cell_level - 1), eye.size);
  EyeScatter scatter = eye_scatter_here();
  vec3 here;
  unproject(pixel, eye_frame(), here);
  float scale = degrees_per_pixel(pixel);
  float soft = softness(pixel);
  float near_light = eye_near_light(soft, scatter);
  const float square_degrees = 180.0 / pi * (180.0 / pi);
  float squared_magnification = eye.media.w * eye.media.w;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < eye.lights; ++i) {
    vec4 light = texelFetch(light_texels, 1 + 3 * i);
    vec4 direction = texelFetch(light_texels, 2 + 3 * i);
    float angle = squared_magnification * square_degrees * squared_angle(here, direction.xyz);
    sum += light * eye_spread_far(min(angle, 32400.0), direction.w, scatter);
  }
  imageStore(far_veil, texel, squared_magnification * sum + (1.0 - near_light) * beyond);
  float spread = 0.0;
  for (int level = eye.cell_level; level >= finest_veil; --level) {
    spread += eye_octave_light(level_sigma * texel_side(level) * scale, soft, scatter);
  }
  imageStore(near_shares, texel, vec4(max(near_light - spread, 0.0), 0.0, 0.0, 0.0));
}
