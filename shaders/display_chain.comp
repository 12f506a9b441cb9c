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
#include "listed_tile.glsl"

layout(local_size_x = 16, local_size_y = 4) in; // the columns of tiles
layout(binding = 0) uniform writeonly image2D pixels;
layout(binding = 1, rgba32f) uniform readonly image2D frame;
layout(binding = 5, rgba32f) uniform readonly image1D curve;
#ifdef POINTS
layout(binding = 2, rgba32f) uniform readonly image2D points;
#endif
#ifdef EYE
layout(binding = 3, rgba32f) uniform readonly image2D eye_added;
layout(binding = 4, rg32f) uniform readonly image2D eye_shares;
layout(location = 11) uniform bool wraps; // whether the left edge continues the right one
#endif
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
layout(location = 8) uniform mat3 signal_from_xyz; // of light over the floor
layout(location = 9) uniform vec3 rod_hue;         // night_hue once it is shown
layout(location = 10) uniform float color_to_keep; // of scale_with_color
layout(location = 20) uniform DisplayModel display;

// Solid angle over which the eye spreads a point of light, sr: a disc of 2 arcmin.
const float point_image_sr = 2.7e-7;

// Logarithms to base 2 by the bits of floats, which count them in straight pieces: within 0.043.
float octave_of(float x) { return float(floatBitsToInt(x)) * exp2(-23.0) - 126.957; }

// local_cone_share within 0.005.
float cone_share(vec4 light) {
  float share = cone_share_of_octave(octave_of(mesopic_luminance(light.y, light.w, 0.5)));
  return night_vision == 0 ? 1.0 : share;
}

// tone_curve in shares of the display's range, by a texel for each eighth of an octave as floats count them:
// renderer/gpu/display_chain.cpp fills it.
vec3 curve_at(float luminance) {
  const int eighth = 1 << 20;
  int bits = floatBitsToInt(luminance) - ((127 + tone_lowest_octave) << 23);
  bits = clamp(bits, 0, tone_nodes * eighth - 1);
  vec4 texel = imageLoad(curve, bits / eighth);
  return vec3(texel.x + float(bits & (eighth - 1)) * exp2(-20.0) * texel.y, texel.z, texel.w);
}

vec3 mapped(vec4 extended, vec4 point, vec2 at) {
  float cones = cone_share(extended);
  float rods = (1.0 - cones) * rods_at_555_nm;
  PixelFrame picture = PixelFrame(PROJECTION, size, focal);
  float rod_light = rods * extended.w;
#ifdef NOISE
  vec3 direction;
  if (unproject(at, picture, direction)) {
    float degrees = degrees(inversesqrt(max(pixels_per_steradian(at, picture), 1.0e-6)));
    float grain = visual_noise_cd_m2(extended.w, cones);
    grain *= visual_noise(direction, int(at.x), int(at.y), degrees, seconds, seed);
    rod_light = max(rod_light + (cones + rods) * grain, 0.0);
  }
#endif
  // seen_color times (cones + rods), which only its luminance needs.
  vec3 color = cones * extended.xyz + rod_light * rod_hue;
  float luminance = max(color.y, 1.0e-30);
  float seen = luminance / (cones + rods);
  vec3 tone = curve_at(seen);
  // Of the light that a display adds to its floor.
  vec3 signal = signal_from_xyz * color;
  float highest = max(signal.x, max(signal.y, signal.z));
  float scale = scale_with_color(tone.x, luminance, highest, seen, color_to_keep);
  signal *= scale;
  float shown = scale * luminance;
  highest *= scale;
  if (point.y > 0.0) {
    float pixel_sr = 1.0 / max(pixels_per_steradian(at, picture), 1.0e-6);
    // A pixel in the middle of a star holds a fourth of its light.
    vec3 seen_point = seen_color(point, cone_share(point * (4.0 / point_image_sr * pixel_sr)), rod_hue);
    float more = tone.y * point.y;
    if (points_as_seen != 0) {
      float lux = seen_light(point.y, point.w, cones) * pixel_sr;
      more = tone.y * point_boost(lux * tone.z) * lux / display.pixel_sr;
    }
    signal += signal_from_xyz * (seen_point * (more / max(seen_point.y, 1.0e-30)));
    if (more > 0.0) {
      // The ceiling is what the display can show of that colour.
      float asked = shown + more;
      highest = max(signal.x, max(signal.y, signal.z));
      float ceiling = asked / max(highest, asked);
      shown = under_ceiling(shown, more, max(ceiling, shown));
      signal *= shown / asked;
      highest *= shown / asked;
    }
  }
  return towards_grey(signal, shown, highest);
}

float encoded(float signal) {
#if TRANSFER == 0
  return quick_srgb_encode(signal);
#else
  DisplayModel coded = display;
  coded.transfer = TRANSFER;
  return transfer_encode(signal, coded);
#endif
}

// What the eye makes of light: that of extended sources it adds, the shares of theirs and of points' that it leaves.
struct Seen {
  vec4 added;
  vec2 shares;
};

Seen between(Seen a, Seen b, float share) { return Seen(mix(a.added, b.added, share), mix(a.shares, b.shares, share)); }

#ifdef EYE
Seen seen_by_block(ivec2 block) {
  return Seen(imageLoad(eye_added, block), imageLoad(eye_shares, block).xy);
}

Seen seen_in_row(int row, ivec2 columns, float beside) {
  row = clamp(row, 0, imageSize(eye_shares).y - 1);
  return between(seen_by_block(ivec2(columns.x, row)), seen_by_block(ivec2(columns.y, row)), beside);
}
#endif

void show(ivec2 at, Seen seen) {
  ivec2 within = min(at, ivec2(int(size.x), strip.y) - 1);
  vec4 all = max(imageLoad(frame, within), 0.0); // lest impossible light have no luminance
#ifdef POINTS
  vec4 point = min(imageLoad(points, within), all);
#else
  vec4 point = vec4(0.0);
#endif
  vec4 extended = seen.shares.x * (all - point) + seen.added;
  point *= seen.shares.y;
  vec2 pixel = vec2(at) + vec2(0.5, 0.5 + float(strip.x));
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
  vec3 codes = vec3(encoded(signal.x), encoded(signal.y), encoded(signal.z));
  imageStore(pixels, at, vec4(dithered(codes, uint(at.x), uint(strip.x + at.y), seed, steps), 1.0));
}

void main() {
#ifdef POINTS
  ivec2 first = listed_tile(true);
#else
  ivec2 first = listed_tile(false);
#endif
  first.x += int(gl_LocalInvocationID.x);
  // The four pixels of a column lie in one block of the eye's: they share what stands beside it.
#ifdef EYE
  int last = imageSize(eye_shares).x - 1;
  ivec2 columns = first.x / 4 + ivec2(0, (first.x & 2) - 1);
  columns.y = columns.y < 0 ? (wraps ? last : 0) : columns.y > last ? (wraps ? 0 : last) : columns.y;
  float aside = abs(0.25 * float(first.x & 3) - 0.375);
  int row = (first.y + strip.x) / 4;
  Seen above = seen_in_row(row - 1, columns, aside);
  Seen here = seen_in_row(row, columns, aside);
  Seen below = seen_in_row(row + 1, columns, aside);
#else
  const Seen here = Seen(vec4(0.0), vec2(1.0));
  const Seen above = here;
  const Seen below = here;
#endif
  // A loop would take a fourth longer.
  show(first, between(here, above, 0.375));
  show(first + ivec2(0, 1), between(here, above, 0.125));
  show(first + ivec2(0, 2), between(here, below, 0.125));
  show(first + ivec2(0, 3), between(here, below, 0.375));
}
