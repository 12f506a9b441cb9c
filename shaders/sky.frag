// The light of the air and of the ground below it, added to what is drawn already. PEAK draws what aerosol scatters close
// to a light, which the rest leaves out. DARK_SKY draws with it what dark_sky.frag has in the air, in the same order.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#include "sky_block.glsl"

layout(binding = 0) uniform sampler2D map;     // what it holds: sky_map.comp
layout(binding = 1) uniform sampler1D phase;    // x: the peak of the aerosol's phase function, per steradian
layout(location = 0) uniform mat3 horizon_from_view;
layout(location = 1) uniform vec2 size;
layout(location = 2) uniform float focal;
layout(location = 3) uniform float horizon_sin_altitude;
layout(location = 4) uniform vec2 strip; // first row and number of rows that the framebuffer holds

#ifdef DARK_SKY
layout(binding = 2) uniform sampler2D dark_map;
layout(location = 5) uniform vec2 dark_rows;
#endif

#ifdef PEAK
flat in int light;
#else
const int light = 0;
#endif
layout(location = 0) out vec4 luminance;

void main() {
  vec3 view;
  PixelFrame frame = PixelFrame(PROJECTION, size, focal);
  vec2 at = gl_FragCoord.xy + vec2(0.0, strip.x);
  if (!unproject(at, frame, view)) {
    discard;
  }
  vec3 direction = horizon_from_view * view;
  float depth = horizon_sin_altitude - direction.z;
  float cover = 0.5 + depth * min(sqrt(pixels_per_steradian(at, frame)), 1.0e7);
  vec2 texels = vec2(textureSize(map, 0));
  vec2 rows = vec2(block.map_rows_below, block.map_rows_above);
  float row;
  vec2 place = sky_map_texel(direction, depth, cover, rows, texels.x, map_frame(), row);
#ifdef PEAK
  float cos_angle = dot(direction, block.lights[light].apparent.xyz);
  float steps = float(textureSize(phase, 0) - 1);
  float peak = textureLod(phase, (min(sky_peak_place(cos_angle), 1.0) * steps + 0.5) / (steps + 1.0), 0.0).x;
  place.y += float(1 + light) * (rows.x + rows.y);
  vec4 light_here = peak * exp2(textureLod(map, place / texels, 0.0));
#else
  vec4 light_here = exp2(textureLod(map, place / texels, 0.0));
#endif
#ifdef DARK_SKY
  vec2 dark_texels = vec2(textureSize(dark_map, 0));
  vec2 dark_place = sky_map_texel(direction, depth, cover, dark_rows, dark_texels.x, map_frame(), row);
  light_here += textureLod(dark_map, dark_place / dark_texels, 0.0);
#endif
  // Over the limb there is no air.
  luminance = row <= 1.0001 ? light_here : vec4(0.0);
}
