// The light of the air and of the ground below it, added to what is drawn already.
#include "prelude.glsl"
#include "lib/projection.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#include "sky_block.glsl"

layout(binding = 0) uniform sampler2DArray map; // what it holds: sky_map.comp
layout(binding = 1) uniform sampler1D phase;    // x: the peak of the aerosol's phase function, per steradian
layout(location = 0) uniform mat3 horizon_from_view;
layout(location = 1) uniform vec2 size;
layout(location = 2) uniform float focal;
layout(location = 3) uniform float horizon_sin_altitude;
layout(location = 4) uniform float first_row; // of the strip that the framebuffer holds

layout(location = 0) out vec4 luminance;

// No light above the limb.
vec4 light_at(vec3 direction, float column, bool below) {
  vec3 texels = vec3(textureSize(map, 0));
  float row = sky_map_row(direction.z, below, map_frame());
  float first = below ? 0.0 : float(block.map_rows_below);
  float last = below ? float(block.map_rows_below - 1) : texels.y - float(block.map_rows_below + 1);
  vec2 at = vec2(column + 0.5 / texels.x, (first + min(row, 1.0) * last + 0.5) / texels.y);
  vec4 sum = exp2(textureLod(map, vec3(at, 0.0), 0.0));
  for (int light = 0; light < block.light_count; ++light) {
    float cos_angle = dot(direction, block.lights[light].apparent.xyz);
    if (cos_angle > sky_peak_cos) {
      float steps = float(textureSize(phase, 0) - 1);
      float peak = textureLod(phase, (sky_peak_place(cos_angle) * steps + 0.5) / (steps + 1.0), 0.0).x;
      sum += peak * exp2(textureLod(map, vec3(at, float(1 + light)), 0.0));
    }
  }
  return row <= 1.0001 ? sum : vec4(0.0);
}

void main() {
  vec3 view;
  PixelFrame frame = PixelFrame(PROJECTION, size, focal);
  vec2 at = gl_FragCoord.xy + vec2(0.0, first_row);
  if (!unproject(at, frame, view)) {
    discard;
  }
  vec3 direction = horizon_from_view * view;
  float column = sky_map_column(direction.xy);
  float depth = horizon_sin_altitude - direction.z;
  luminance = light_at(direction, column, depth > 0.0);
  // What a pixel at the horizon has on its other side, weighted as in ground.frag.
  if (abs(depth) < 0.1) {
    float pixel = max(inversesqrt(pixels_per_steradian(at, frame)), 1.0e-7);
    float other = clamp(0.5 - abs(depth) / pixel, 0.0, 0.5);
    if (other > 0.0) {
      luminance = mix(luminance, light_at(direction, column, depth <= 0.0), other);
    }
  }
}
