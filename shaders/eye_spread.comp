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

// The light of a texel that is `step` texels away and comes to the node.
vec4 light_from(ivec2 texel, ivec2 step, ivec2 node) {
  // One that stands for another, past the edge, is seen as in a mirror.
  bvec2 mirrored = bvec2(step.x != 0 && texel.x == node.x, step.y != 0 && texel.y == node.y);
  vec2 away = vec2(step) + mix(vec2(1.0), vec2(-1.0), mirrored) * texelFetch(centre, texel, level).xy;
  return b_spline(away.x) * b_spline(away.y) * texelFetch(light, texel, level);
}

vec4 light_from_row(ivec3 columns, int row, int step, ivec2 node) {
  return light_from(ivec2(columns.x, row), ivec2(-1, step), node) + light_from(ivec2(columns.y, row), ivec2(0, step), node) +
         light_from(ivec2(columns.z, row), ivec2(1, step), node);
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(spread)))) {
    return;
  }
  ivec2 size = level_size(level);
  ivec2 node = min(texel, size - 1);
  ivec3 columns = columns_beside(node.x, size.x);
  ivec3 rows = beside(node.y, size.y);
  imageStore(spread, texel, light_from_row(columns, rows.x, -1, node) + light_from_row(columns, rows.y, 0, node) +
                                light_from_row(columns, rows.z, 1, node));
}
