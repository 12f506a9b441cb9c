// The coarsest level as lights: illuminance at the eye, the direction it comes from, softness of its far part.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"
#include "eye_lights.glsl"

layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D light;
layout(binding = 1) uniform sampler2D centre;

void main() {
  int number = int(gl_GlobalInvocationID.x);
  ivec2 size = level_size(eye.cell_level);
  if (number >= size.x * size.y) {
    return;
  }
  ivec2 cell = ivec2(number % size.x, number / size.x);
  int finer = min(eye.cell_level, 2);
  int level = eye.cell_level - finer;
  float side = texel_side(level);
  PixelFrame frame = eye_frame();
  vec4 sum = vec4(0.0);
  vec3 towards = vec3(0.0);
  float solid_angle = 0.0;
  for (int y = 0; y < 1 << finer; ++y) {
    for (int x = 0; x < 1 << finer; ++x) {
      ivec2 texel = (cell << finer) + ivec2(x, y);
      float area = coverage(texel, level) * side * side;
      if (area > 0.0) {
        vec2 from = texelFetch(centre, texel, level).xy + vec2(texel) + 0.5;
        vec2 pixel = clamp(from * side, vec2(0.5), eye.size - 0.5);
        float pixels = pixels_per_steradian(pixel, frame);
        if (pixels > 0.0) {
          vec4 here = texelFetch(light, texel, level) * (area / pixels);
          vec3 direction;
          unproject(pixel, frame, direction);
          sum += here;
          towards += max(here.y, 0.0) * direction;
          solid_angle += area / pixels;
        }
      }
    }
  }
  vec2 middle = min((vec2(cell) + 0.5) * texel_side(eye.cell_level), eye.size);
  vec3 direction;
  unproject(middle, frame, direction);
  float extent = length(towards);
  direction = extent > 0.0 ? towards / extent : direction;
  lights[number].light = sum;
  lights[number].direction = vec4(direction, softness(middle));
  lights[number].solid_angle = vec4(solid_angle);
}
