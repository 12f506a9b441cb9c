// The light of the air and of the ground below it, added to what is drawn already.
//
// Against the tables themselves the map's interpolation costs: see docs and tests/render/sky_pass_test.cpp.
#include "prelude.glsl"
#include "lib/projection.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "sky_block.glsl"

layout(binding = 0) uniform sampler2DArray map;
layout(binding = 1) uniform sampler1D phase; // logarithm to base 2, over the root of the sine of half the angle
layout(location = 0) uniform mat3 horizon_from_view;
layout(location = 1) uniform vec2 size;
layout(location = 2) uniform float focal;
layout(location = 3) uniform float horizon_sin_altitude;
layout(location = 4) uniform float first_row; // of the strip that the framebuffer holds

layout(location = 0) out vec4 luminance;

// place: from the horizon (0) to where the map ends (1).
vec4 light_at(vec3 direction, float azimuth, float place, bool below) {
  vec2 rows = vec2(textureSize(map, 0).y, block.map_rows_below);
  float first = below ? 0.5 : rows.y + 0.5;
  float last = below ? rows.y - 1.0 : rows.x - rows.y - 1.0;
  vec2 at = vec2(azimuth, (first + place * last) / rows.x);
  vec4 sum = exp2(textureLod(map, vec3(at, 0.0), 0.0));
  for (int light = 0; light < block.light_count; ++light) {
    vec3 apart = direction - block.lights[light].apparent.xyz;
    float steps = float(textureSize(phase, 0) - 1);
    float angle = sqrt(0.5 * length(apart));
    float lobe = textureLod(phase, (angle * steps + 0.5) / (steps + 1.0), 0.0).x;
    sum += exp2(textureLod(map, vec3(at, float(1 + light)), 0.0) + lobe);
  }
  return sum;
}

void main() {
  vec3 view;
  PixelFrame frame = PixelFrame(PROJECTION, size, focal);
  vec2 at = gl_FragCoord.xy + vec2(0.0, first_row);
  if (!unproject(at, frame, view)) {
    discard;
  }
  vec3 direction = horizon_from_view * view;
  float across = length(direction.xy);
  float altitude = atan(direction.z, across);
  float azimuth = across > 0.0 ? atan(direction.x, direction.y) / (2.0 * sky_half_turn) : 0.0;
  // As ground.frag: what a pixel at the horizon has on either side.
  float pixel = inversesqrt(pixels_per_steradian(at, frame));
  float cover = clamp(0.5 + (horizon_sin_altitude - direction.z) / max(pixel, 1.0e-7), 0.0, 1.0);
  float over = altitude - block.horizon_rad;
  luminance = vec4(0.0);
  if (cover < 1.0) {
    float range = block.highest_rad - block.horizon_rad;
    if (over < range || block.highest_rad > 1.57) {
      luminance = (1.0 - cover) * light_at(direction, azimuth, sqrt(clamp(over / range, 0.0, 1.0)), false);
    }
  }
  if (cover > 0.0) {
    float range = 0.5 * sky_half_turn + block.horizon_rad;
    luminance += cover * light_at(direction, azimuth, sqrt(clamp(-over / range, 0.0, 1.0)), true);
  }
}
