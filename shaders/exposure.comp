// Plain exposure: frame in cd/m2 in, sRGB code values out, dithered.
#include "prelude.glsl"
#include "lib/hash.glsl"
#include "lib/display.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0, rgba32f) uniform readonly image2D frame;
layout(binding = 1) uniform writeonly image2D pixels;
layout(location = 0) uniform float white_cd_m2;
layout(location = 1) uniform int first_row; // of the picture, in this strip
layout(location = 2) uniform float steps;   // of the pixels, from black to white

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(frame)))) {
    return;
  }
  vec3 color = plain_exposure(imageLoad(frame, at).xyz, white_cd_m2);
  color = dithered(color, uint(at.x), uint(first_row + at.y), 0u, steps);
  imageStore(pixels, at, vec4(color, 1.0));
}
