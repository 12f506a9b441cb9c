// The light of the night sky itself, added to what is drawn already. BEYOND draws what shines from behind the air and the
// Moon: zodiacal light and, as MILKY_WAY, faint stars, refracted as REFRACTION says. The rest is in the air: airglow, sky
// glow and all that the air scatters of these.
#include "prelude.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/refraction.glsl"
#ifndef REFRACTION
#define REFRACTION refraction_traced
#endif
#ifdef BEYOND
#include "lib/extinction.glsl"
#include "lib/sun.glsl"
#include "lib/dark_sky.glsl"
#else
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#endif

layout(location = 0) uniform mat3 horizon_from_view;
layout(location = 1) uniform vec2 size;
layout(location = 2) uniform float focal;
layout(location = 3) uniform float horizon_sin_altitude;
layout(location = 4) uniform vec2 strip; // first row and number of rows that the framebuffer holds

#ifdef BEYOND
layout(binding = 0) uniform sampler2D zodiacal_map;
layout(binding = 1) uniform sampler2D extinction_table;
layout(binding = 2) uniform samplerCube milky_way; // ICRS axes, luminance
layout(binding = 3) uniform sampler1D refraction_table;
layout(location = 5) uniform mat3 helioecliptic_from_horizon;
layout(location = 6) uniform mat3 icrs_from_horizon;
layout(location = 7) uniform float zodiacal_scale;  // 0 for none
layout(location = 8) uniform vec4 dust_corona;
layout(location = 9) uniform float sin_sun_radius;
layout(location = 10) uniform vec3 refraction_air; // RefractionFrame: strength, horizon_apparent, horizon_true
layout(location = 11) uniform ivec2 extinction_size; // StarExtinctionFrame
layout(location = 12) uniform vec3 extinction_rows;
layout(location = 13) uniform vec2 extinction_hues;
layout(location = 14) uniform vec4 refraction_scales; // RefractionFrame: scale_apparent, scale_true
#else
layout(binding = 0) uniform sampler2D map; // ordered as that of sky.frag; luminance
layout(location = 5) uniform vec2 map_rows;
layout(location = 6) uniform vec3 map_half_sines; // SkyMapFrame
#endif

layout(location = 0) out vec4 luminance;

#ifdef BEYOND
vec4 zodiacal_light(vec3 direction) {
  vec2 texels = vec2(textureSize(zodiacal_map, 0));
  vec2 place = (zodiacal_place(direction) * (texels - 1.0) + 0.5) / texels;
  vec4 all = zodiacal_scale * exp2(log2_dust_law(direction) + textureLod(zodiacal_map, place, 0.0));
  return max(all - dust_in_corona(direction, sin_sun_radius) * dust_corona, vec4(0.0));
}

#ifdef MILKY_WAY
// The least width of a texel: pixels that lie as far apart as texels would miss light of some and see others twice.
const float texel_pixels = 2.0;

// In a direction that is seen.
vec4 starlight(vec3 direction, float texel_rad) {
  RefractionFrame frame = RefractionFrame(REFRACTION, refraction_air.x, refraction_air.y, refraction_air.z,
                                          refraction_scales.xy, refraction_scales.zw);
  float bend = refraction_bend(dvec3(length(direction.xy), 0.0, direction.z), true, frame, refraction_table);
  // Lowered along the tangent of its circle through the zenith: within 0.1 arcsec for the bend of any air.
  vec3 truly = normalize(direction - bend * (vec3(0.0, 0.0, 1.0) - direction.z * direction));
  vec3 icrs = icrs_from_horizon * truly;
  float level = cube_level(texel_rad, float(textureSize(milky_way, 0).x));
  return textureLod(milky_way, opengl_cube_direction(icrs), level);
}
#endif
#endif

void main() {
  vec3 view;
  PixelFrame frame = PixelFrame(PROJECTION, size, focal);
  vec2 at = gl_FragCoord.xy + vec2(0.0, strip.x);
  if (!unproject(at, frame, view)) {
    discard;
  }
  vec3 direction = horizon_from_view * view;
#ifdef BEYOND
  vec4 light = zodiacal_scale > 0.0 ? zodiacal_light(helioecliptic_from_horizon * direction) : vec4(0.0);
#ifdef MILKY_WAY
  light += starlight(direction, texel_pixels * pixel_width(at, frame));
#endif
  StarExtinctionFrame air = StarExtinctionFrame(extinction_size.x, extinction_size.y, extinction_rows.x,
                                                extinction_rows.y, extinction_rows.z, extinction_hues.x,
                                                extinction_hues.y);
  luminance = light * star_extinction(direction.z, light, air, extinction_table);
#else
  float depth = horizon_sin_altitude - direction.z;
  float cover = 0.5 + depth * min(sqrt(pixels_per_steradian(at, frame)), 1.0e7);
  vec2 texels = vec2(textureSize(map, 0));
  float row;
  vec2 place = sky_map_texel(direction, depth, cover, map_rows, texels.x,
                             SkyMapFrame(map_half_sines.x, map_half_sines.y, map_half_sines.z), row);
  luminance = row <= 1.0001 ? textureLod(map, place / texels, 0.0) : vec4(0.0);
#endif
}
