// The boxes of pixels that show some of a disc.
#include "prelude.glsl"
#include "lib/refraction.glsl"
#include "lib/extinction.glsl"
#include "lib/disc.glsl"
#include "disc_block.glsl"

void main() {
  vec4 box = block.boxes[gl_InstanceID];
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? box.x : box.z, (gl_VertexID & 2) == 0 ? box.y : box.w);
  corner.y = clamp(corner.y - block.strip.x, 0.0, block.strip.y);
  gl_Position = vec4(2.0 * corner / vec2(block.size.x, block.strip.y) - 1.0, 0.0, 1.0);
}
