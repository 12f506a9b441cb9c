// Tiles of the picture in which a light's peak may show; the others are folded up. Instances: tiles of the first light,
// then of the second.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#include "sky_block.glsl"

layout(location = 0) uniform mat3 horizon_from_view;
layout(location = 1) uniform vec2 size;
layout(location = 2) uniform float focal;
layout(location = 4) uniform vec2 strip;
layout(location = 5) uniform ivec2 tiles; // over the picture

flat out int light;

vec3 direction_at(vec2 pixel) {
  vec3 view;
  unproject(pixel, PixelFrame(PROJECTION, size, focal), view);
  return horizon_from_view * view;
}

void main() {
  int tile = gl_InstanceID % (tiles.x * tiles.y);
  light = gl_InstanceID / (tiles.x * tiles.y);
  vec2 low = floor(size * vec2(tile % tiles.x, tile / tiles.x) / vec2(tiles));
  vec2 high = floor(size * (vec2(tile % tiles.x, tile / tiles.x) + 1.0) / vec2(tiles));
  vec3 centre = direction_at(0.5 * (low + high));
  float across = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    vec2 at = vec2((corner & 1) == 0 ? low.x : high.x, (corner & 2) == 0 ? low.y : high.y);
    across = max(across, acos(clamp(dot(centre, direction_at(at)), -1.0, 1.0)));
  }
  float apart = acos(clamp(dot(centre, block.lights[light].apparent.xyz), -1.0, 1.0));
  // A wide tile may hold more than its corners tell.
  bool shows = across > 0.4 || apart < acos(sky_peak_cos) + 1.2 * across;
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? low.x : high.x, (gl_VertexID & 2) == 0 ? low.y : high.y);
  corner.y = clamp(corner.y - strip.x, 0.0, strip.y);
  gl_Position = vec4(shows ? 2.0 * corner / vec2(size.x, strip.y) - 1.0 : vec2(-2.0), 0.0, 1.0);
}
