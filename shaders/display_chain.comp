// From the light of a strip to the code values of a display: what the eye's glare and acuity leave (EYE), colour by rods and
// cones, tone curve, points of light, the display's gamut and transfer (TRANSFER), dither. FALSE_COLOR has colours for
// luminance; NOISE adds the grain that is seen in the dark.
#include "prelude.glsl"
#ifndef TRANSFER
#define TRANSFER 0
#endif
#include "lib/hash.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/visibility.glsl"
#include "lib/mesopic.glsl"
#ifdef NOISE
#include "lib/vision.glsl"
#include "lib/visual_noise.glsl"
#endif
#include "lib/tone.glsl"
#ifdef FALSE_COLOR
#include "lib/false_color.glsl"
#endif
#include "lib/display.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D frame;
layout(binding = 1) uniform sampler2D points;
layout(binding = 2) uniform sampler1D curve;
#ifdef EYE
layout(binding = 3) uniform sampler2D eye_added;
layout(binding = 4) uniform sampler2D eye_shares;
#endif
layout(binding = 0) uniform writeonly image2D pixels;
layout(location = 0) uniform vec2 size; // of the picture
layout(location = 1) uniform float focal;
layout(location = 2) uniform ivec2 strip;       // first row and number of rows
layout(location = 3) uniform float steps;       // of the pixels, from black to white
layout(location = 4) uniform uint seed;         // of dither and grain
layout(location = 5) uniform int night_vision;  // 0: all is seen as by day
layout(location = 6) uniform int points_as_seen; // 0: points count by their luminance, as for a camera
#ifdef NOISE
layout(location = 7) uniform float seconds;
#endif
layout(location = 20) uniform DisplayModel display;

// Solid angle over which the eye spreads a point of light, sr: a disc of 2 arcmin.
const float point_image_sr = 2.7e-7;

float cone_share(vec4 light) { return night_vision == 0 ? 1.0 : local_cone_share(light.y, light.w); }

// Of the light that a display adds to its floor.
vec3 signal_of(vec3 xyz) {
  return fit_to_gamut(display.rgb_from_xyz * xyz / display.range_cd_m2, xyz.y / display.range_cd_m2);
}

vec3 mapped(vec4 extended, vec4 point, vec2 at) {
  float cones = cone_share(extended);
  vec3 seen = seen_color(extended, cones);
#ifdef NOISE
  PixelFrame picture = PixelFrame(PROJECTION, size, focal);
  vec3 direction;
  if (unproject(at, picture, direction)) {
    float degrees = degrees(inversesqrt(max(pixels_per_steradian(at, picture), 1.0e-6)));
    float grain = visual_noise_cd_m2(extended.w, cones);
    grain *= visual_noise(direction, int(at.x), int(at.y), degrees, seconds, seed);
    seen = max(seen + grain * night_hue, vec3(0.0));
  }
#endif
  float luminance = max(seen.y, 0.0);
  vec3 tone = tone_curve(luminance, curve);
  vec3 color = seen * (tone.x / max(luminance, 1.0e-30));
  // A loop of one round and no branch: software drivers leave out loops that nobody enters, but go through branches.
  int rounds = point.y > 0.0 ? 1 : 0;
  for (int i = 0; i < rounds; ++i) {
    float pixel_sr = 1.0 / max(pixels_per_steradian(at, PixelFrame(PROJECTION, size, focal)), 1.0e-6);
    // A pixel in the middle of a star holds a fourth of its light.
    vec3 seen_point = seen_color(point, cone_share(point * (4.0 * pixel_sr / point_image_sr)));
    float more = tone.y * point.y;
    if (points_as_seen != 0) {
      float lux = seen_light(point.y, point.w, cones) * pixel_sr;
      more = tone.y * point_boost(lux * tone.z) * lux / display.pixel_sr;
    }
    color += seen_point * (more / max(seen_point.y, 1.0e-30));
    // The ceiling is what the display can show of that colour.
    vec3 rgb = display.rgb_from_xyz * color / (tone.x + more);
    float ceiling = max(display.range_cd_m2 / max(max(rgb.x, rgb.y), max(rgb.z, 1.0)), tone.x);
    color *= under_ceiling(tone.x, more, ceiling) / (tone.x + more);
  }
  return signal_of(color);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= int(size.x) || at.y >= strip.y) {
    return;
  }
  vec4 all = texelFetch(frame, at, 0);
  vec4 point = min(texelFetch(points, at, 0), all);
  vec4 extended = all - point;
  vec2 pixel = vec2(at) + vec2(0.5, 0.5 + float(strip.x));
#ifdef EYE
  vec2 place = pixel / (4.0 * vec2(textureSize(eye_shares, 0)));
  // Of points alone nothing is taken away: their threshold was measured through eyes that scatter.
  extended = textureLod(eye_shares, place, 0.0).x * extended + textureLod(eye_added, place, 0.0);
#endif
#if PROJECTION == 1
  // Outside the fisheye's circle nothing is seen, no veil either.
  if (length(pixel - 0.5 * size) > 0.5 * min(size.x, size.y)) {
    extended = vec4(0.0);
  }
#endif
#ifdef FALSE_COLOR
  vec3 signal = false_color(extended.y + point.y);
  vec4 legend = false_color_legend(at.x, strip.x + at.y, int(size.x), int(size.y));
  signal = mix(signal, legend.xyz, legend.w);
#else
  vec3 signal = mapped(extended, point, pixel);
#endif
  DisplayModel coded = display;
  coded.transfer = TRANSFER;
  vec3 codes = vec3(transfer_encode(signal.x, coded), transfer_encode(signal.y, coded),
                    transfer_encode(signal.z, coded));
  imageStore(pixels, at, vec4(dithered(codes, uint(at.x), uint(strip.x + at.y), seed, steps), 1.0));
}
