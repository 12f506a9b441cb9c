// The light of the night sky itself, added to what is drawn already. BEYOND draws what shines from behind the air and the
// Moon: zodiacal light as ZODIACAL, faint stars as MILKY_WAY. The rest is in the air: airglow, sky glow and all that the
// air scatters of these.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#ifdef BEYOND
#include "lib/sun.glsl"
#include "lib/dark_sky.glsl"
#endif

layout(location = 0) uniform mat3 horizon_from_view;
layout(location = 1) uniform vec2 size;
layout(location = 2) uniform float focal;
layout(location = 3) uniform float horizon_sin_altitude;
layout(location = 4) uniform vec2 strip; // first row and number of rows that the framebuffer holds
layout(location = 5) uniform vec2 rows;  // below the horizon and above it: of the map, or of the air's tables
layout(location = 6) uniform vec3 half_sines; // SkyMapFrame

#ifdef BEYOND
layout(binding = 0) uniform sampler2D zodiacal_map; // luminance at 1 au, zodiacal_place
layout(binding = 1) uniform sampler2D air_shares;   // logarithms to base 2 of what air leaves of X, Y, Z, S: by Z of Y + Z
layout(binding = 2) uniform sampler1D air_bends;    // x: refraction over the cosine of the altitude
layout(binding = 3) uniform samplerCube milky_way;  // ICRS axes, luminance
layout(location = 7) uniform mat3 helioecliptic_from_view;
layout(location = 8) uniform mat3 icrs_from_view;
layout(location = 9) uniform float zodiacal_scale;
layout(location = 10) uniform vec4 dust_corona;
layout(location = 11) uniform float sin_sun_radius;
#else
layout(binding = 0) uniform sampler2D map; // ordered as that of sky.frag; luminance
#endif

layout(location = 0) out vec4 luminance;

SkyMapFrame map_frame() { return SkyMapFrame(half_sines.x, half_sines.y, half_sines.z); }

#ifdef BEYOND
vec4 zodiacal_light(vec3 direction) {
  vec2 texels = vec2(textureSize(zodiacal_map, 0));
  vec2 place = (zodiacal_place(direction) * (texels - 1.0) + 0.5) / texels;
  vec4 all = zodiacal_scale * textureLod(zodiacal_map, place, 0.0);
  return max(all - dust_in_corona(direction, sin_sun_radius) * dust_corona, vec4(0.0));
}

// The least width of a texel: pixels that lie as far apart as texels would miss light of some and see others twice.
const float texel_pixels = 2.0;

// Where a direction of view truly looks that is seen at a sine of altitude: lowered along the tangent of its circle
// through the zenith, within 0.1 arcsec for the bend of any air.
vec4 starlight(vec3 view, float sin_altitude, float bend, float texel_rad) {
  vec3 zenith = vec3(horizon_from_view[0].z, horizon_from_view[1].z, horizon_from_view[2].z);
  vec3 icrs = icrs_from_view * (view - bend * (zenith - sin_altitude * view));
  float level = cube_level(texel_rad, float(textureSize(milky_way, 0).x));
  return textureLod(milky_way, opengl_cube_direction(icrs), level);
}
#endif

void main() {
  vec3 view;
  PixelFrame frame = PixelFrame(PROJECTION, size, focal);
  vec2 at = gl_FragCoord.xy + vec2(0.0, strip.x);
  if (!unproject(at, frame, view)) {
    discard;
  }
  vec3 direction = horizon_from_view * view;
  float depth = horizon_sin_altitude - direction.z;
#ifdef BEYOND
  bool below = depth > 0.0;
  float row = sky_map_row_texel(sky_map_row(direction.z, below, map_frame()), below, rows) / (rows.x + rows.y);
  vec4 light = vec4(0.0);
#ifdef ZODIACAL
  light += zodiacal_light(helioecliptic_from_view * view);
#endif
#ifdef MILKY_WAY
  light += starlight(view, direction.z, textureLod(air_bends, row, 0.0).x, texel_pixels * pixel_width(at, frame));
#endif
  float hues = float(textureSize(air_shares, 0).x);
  float hue = light.z / max(light.y + light.z, 1.0e-30);
  luminance = light * exp2(textureLod(air_shares, vec2((hue * (hues - 1.0) + 0.5) / hues, row), 0.0));
#else
  float cover = 0.5 + depth * min(sqrt(pixels_per_steradian(at, frame)), 1.0e7);
  vec2 texels = vec2(textureSize(map, 0));
  float row;
  vec2 place = sky_map_texel(direction, depth, cover, rows, texels.x, map_frame(), row);
  luminance = row <= 1.0001 ? textureLod(map, place / texels, 0.0) : vec4(0.0);
#endif
}
