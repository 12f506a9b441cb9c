// The opaque Earth: hides what lies below the geometric horizon, whose dip follows the observer's height.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"

layout(location = 0) uniform mat3 horizon_from_view;
layout(location = 1) uniform vec2 size;
layout(location = 2) uniform float focal;
layout(location = 3) uniform float horizon_sin_altitude;
layout(location = 4) uniform vec2 strip; // first row and number of rows that the framebuffer holds

layout(location = 0) out vec4 cover; // alpha: share of the pixel that the ground covers
layout(location = 1) out vec4 points_cover;

void main() {
  vec3 direction;
  PixelFrame frame = PixelFrame(PROJECTION, size, focal);
  vec2 at = gl_FragCoord.xy + vec2(0.0, strip.x);
  if (!unproject(at, frame, direction)) {
    discard;
  }
  float depth = horizon_sin_altitude - (horizon_from_view * direction).z;
  float pixel = inversesqrt(pixels_per_steradian(at, frame));
  cover = vec4(0.0, 0.0, 0.0, clamp(0.5 + depth / max(pixel, 1.0e-7), 0.0, 1.0));
  points_cover = cover;
}
