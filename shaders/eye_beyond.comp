// Past the picture the sphere is taken to be as bright as the darkest cell, so that a picture of a small part of an even
// sky has no darker edges: what the lights have above it remains in them.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/eye_glare.glsl"
#include "eye_block.glsl"
#include "eye_lights.glsl"

const int group = 64;
layout(local_size_x = group) in;
shared vec4 darkest[group];

void main() {
  int me = int(gl_LocalInvocationID.x);
  ivec2 size = level_size(eye.cell_level);
  int cells = size.x * size.y;
  vec4 least = vec4(3.0e38);
  for (int i = me; i < cells; i += group) {
    float solid_angle = lights[i].solid_angle.x;
    least = solid_angle > 0.0 ? min(least, max(lights[i].light, 0.0) / solid_angle) : least;
  }
  darkest[me] = least;
  for (int apart = group / 2; apart > 0; apart /= 2) {
    barrier();
    if (me < apart) {
      darkest[me] = min(darkest[me], darkest[me + apart]);
    }
  }
  barrier();
  least = darkest[0];
  for (int i = me; i < cells; i += group) {
    lights[i].light -= lights[i].solid_angle.x * least;
  }
  if (me == 0) {
    beyond = least;
  }
}
