// Light of the cells by which a picture is metered: sums over the samples that fall into a strip, added to those of the
// strips before. EYE has the light as glare and acuity leave it, from the eye's blocks of the whole picture.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D frame;
#ifdef EYE
layout(binding = 3) uniform sampler2D eye_added;
layout(binding = 4) uniform sampler2D eye_shares;
#else
layout(binding = 1) uniform sampler2D points;
#endif
layout(location = 0) uniform vec2 size; // of the picture
layout(location = 1) uniform float focal;
layout(location = 2) uniform ivec2 strip; // first row and number of rows
layout(location = 3) uniform ivec2 cells;
layout(location = 4) uniform int samples; // along a cell's edge
#ifdef FOVEAL
layout(location = 5) uniform float foveal; // per sr
#endif
layout(std430, binding = 0) buffer Cells { vec4 sums[]; }; // Y, S, weight: of extended light

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(cell, cells))) {
    return;
  }
  PixelFrame picture = PixelFrame(PROJECTION, size, focal);
  vec4 sum = sums[cell.y * cells.x + cell.x];
  for (int i = 0; i < samples * samples; ++i) {
    vec2 place = (vec2(cell) + (vec2(i % samples, i / samples) + 0.5) / float(samples)) / vec2(cells);
    ivec2 at = ivec2(place * size);
    if (at.y < strip.x || at.y >= strip.x + strip.y) {
      continue;
    }
    float per_steradian = pixels_per_steradian(place * size, picture);
    if (per_steradian <= 0.0) {
      continue;
    }
#ifdef EYE
    ivec2 block = at / 4;
    float inside = share_in_circle(4.0 * (vec2(block) + 0.5), 4.0 / sqrt(12.0), picture);
    float kept = texelFetch(eye_shares, block, 0).x / max(inside, 0.25);
    vec4 extended = kept * texelFetch(frame, block, 0) + texelFetch(eye_added, block, 0);
#else
    ivec2 texel = at - ivec2(0, strip.x);
    vec4 extended = max(texelFetch(frame, texel, 0) - texelFetch(points, texel, 0), vec4(0.0));
#endif
    float weight = 1.0 / per_steradian;
#ifdef FOVEAL
    vec3 direction;
    unproject(place * size, picture, direction);
    weight *= exp(-foveal * 2.0 * (1.0 - direction.z));
#endif
    sum += weight * vec4(extended.y, extended.w, 1.0, 0.0);
  }
  sums[cell.y * cells.x + cell.x] = sum;
}
