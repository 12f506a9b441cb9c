// Place, brightness and pixel rectangle of every star's billboards: one invocation a star, so that the four corners
// of a billboard share the work.
//
// PROJECTION is a number of projection.glsl. CHEAP selects Mueller's point-spread function, fades and scintillation.
#include "prelude.glsl"
#include "lib/hash.glsl"
#include "lib/star_place.glsl"
#include "lib/projection.glsl"
#include "lib/star_psf.glsl"
#include "lib/extinction.glsl"
#include "lib/scintillation.glsl"
#include "star_block.glsl"

layout(local_size_x = 64) in;

// One star of the catalogue: vesper::StarRecord as plain floats.
const uint record_floats = 14u;
layout(std430, binding = 0) readonly buffer Records { float records[]; };
layout(std430, binding = 1) readonly buffer Numbers { uint numbers[]; };

// What star.vert reads; the C++ twin is StarBillboard in renderer/gpu/star_pass.cpp.
struct StarBillboard {
  vec4 light; // X, Y, Z, S illuminance of the profile's peak, lux a pixel
  vec2 pixel; // where the star stands
  vec2 scale; // of an offset in pixels to the argument of the profile
  vec4 box;   // pixels to draw: low x, low y, high x, high y; empty for a star that is not in the picture
  vec4 glare; // cheap tier, x: intensity of the glare
};
layout(std430, binding = 2) writeonly buffer Billboards { StarBillboard billboards[]; };

// A rectangle of whole pixels, high excluded.
struct Box {
  vec2 low;
  vec2 high;
};

Box clipped(vec2 pixel, vec2 radius, vec2 first, vec2 last) {
  return Box(clamp(floor(pixel - radius), first, last), clamp(ceil(pixel + radius), first, last));
}

vec4 box_corners(Box box) { return vec4(box.low, box.high); }

float box_sum(vec2 pixel, Box box, float sigma) {
  return psf_axis_sum(pixel.x, box.low.x, box.high.x, sigma) * psf_axis_sum(pixel.y, box.low.y, box.high.y, sigma);
}

// Sum of the weights on the rank-th cube face, which ends where its neighbours begin.
float face_sum(dvec3 direction, int rank, ProjectionFrame frame, float radius, float sigma) {
  int face = cube_face_by_rank(direction, rank);
  dvec2 pixel;
  if (!project(direction, face, frame, pixel)) {
    return 0.0;
  }
  vec2 first = vec2(0.0, float(face) * float(block.size.x));
  return box_sum(vec2(pixel), clipped(vec2(pixel), vec2(radius), first, first + vec2(float(block.size.x))), sigma);
}

vec3 record_vec3(uint at) { return vec3(records[at], records[at + 1u], records[at + 2u]); }

StarBillboard billboard(uint star, int copy) {
  uint at = star * record_floats;
  StarPlaceFrame place_frame =
      StarPlaceFrame(block.years, block.observer_au, block.velocity_c, block.lorentz_inverse, block.sun_to_observer,
                     block.solar_potential);
  dvec3 icrs = star_place(dvec3(record_vec3(at)), dvec3(record_vec3(at + 3u)), double(records[at + 6u]),
                          double(records[at + 7u]), place_frame);
  dvec3 horizon = normalize(block.horizon_from_icrs * icrs);
  dvec3 direction = block.view_from_horizon * horizon;
  float sin_altitude = float(horizon.z);

  ProjectionFrame frame = ProjectionFrame(PROJECTION, block.size, block.focal);
  int face = PROJECTION == projection_cubemap ? cube_face_by_rank(direction, copy) : 0;
  dvec2 projected;
  bool visible = project(direction, face, frame, projected);
  StarBillboard result = StarBillboard(vec4(0.0), vec2(projected), vec2(1.0), vec4(0.0), vec4(0.0));
  vec2 size = vec2(block.size);
  if (!visible) {
    return result;
  }

  float path = optical_path(sin_altitude, block.observer_height_km);
  vec4 color = vec4(records[at + 9u], records[at + 10u], records[at + 11u], records[at + 12u]);
  vec4 light = records[at + 8u] * modulate_xyzs(color, extinction(block.optical_depth, path));
  uint key = hash_pair(numbers[star], block.seed);

#ifdef CHEAP
  if (block.pupil_m > 0.0) {
    light = modulate_xyzs(light, mueller_scintillation(key, block.frame_number, path));
  }
  light *= mueller_day_fade(block.sun_sin_altitude);
  result.glare.x = mueller_glare_intensity(magnitude_of(light.y), block.control_magnitude);
  // The glare's billboard grows with the root of its intensity; the core keeps its size.
  float radius = max(mueller_radius, min(1.5 * sqrt(result.glare.x), 24.0));
  result.scale = vec2(1.0 / radius);
  result.light = light / (mueller_volume * mueller_radius * mueller_radius);
  vec2 first = PROJECTION == projection_cubemap ? vec2(0.0, float(face) * float(block.size.x)) : vec2(0.0);
  vec2 last = PROJECTION == projection_cubemap ? first + vec2(float(block.size.x)) : vec2(block.size);
  if (PROJECTION == projection_equirectangular && copy == 1) {
    result.pixel.x += result.pixel.x < 0.5 * last.x ? last.x : -last.x;
  }
  result.box = box_corners(clipped(result.pixel, vec2(radius), first, last));
#else
  float sigma = psf_sigma(light.y);
  float radius = psf_cut(light.y) * sigma;
  // Last, because the spread must not breathe with it.
  if (block.pupil_m > 0.0) {
    light = modulate_xyzs(
        light, scintillation(key, block.seconds, sin_altitude, block.exposure_s, block.pupil_m));
  }
  result.scale = vec2(psf_scale(sigma));
  if (PROJECTION == projection_equirectangular) {
    // A round star is as wide as the picture at the pole. The sphere ends at the upper and lower edge: what the spread
    // would lose there stays in the rows that are left.
    float cos_latitude = sqrt(max(1.0 - float(direction.y * direction.y), 0.0));
    float wide_radius = min(radius / max(cos_latitude, 1.0e-6), 0.5 * size.x);
    float wide_sigma = sigma * wide_radius / radius;
    result.scale.x = psf_scale(wide_sigma);
    Box box = clipped(result.pixel, vec2(wide_radius, radius), vec2(-size.x, 0.0), vec2(2.0 * size.x, size.y));
    result.light = light / (psf_axis_sum(result.pixel.x, box.low.x, box.high.x, wide_sigma) *
                          psf_axis_sum(result.pixel.y, box.low.y, box.high.y, sigma));
    if (copy == 1) {
      result.pixel.x += result.pixel.x < 0.5 * size.x ? size.x : -size.x;
    }
    result.box = box_corners(clipped(result.pixel, vec2(wide_radius, radius), vec2(0.0), size));
  } else if (PROJECTION == projection_cubemap) {
    result.light = light / (face_sum(direction, 0, frame, radius, sigma) + face_sum(direction, 1, frame, radius, sigma) +
                          face_sum(direction, 2, frame, radius, sigma));
    vec2 first = vec2(0.0, float(face) * size.x);
    result.box = box_corners(clipped(result.pixel, vec2(radius), first, first + vec2(size.x)));
  } else {
    vec2 spread = vec2(radius);
    result.light = light / box_sum(result.pixel, Box(floor(result.pixel - spread), ceil(result.pixel + spread)), sigma);
    result.box = box_corners(clipped(result.pixel, spread, vec2(0.0), size));
  }
#endif
  return result;
}

void main() {
  uint star = gl_GlobalInvocationID.x;
  if (star >= block.star_count) {
    return;
  }
  for (int copy = 0; copy < block.copies; ++copy) {
    billboards[star * uint(block.copies) + uint(copy)] = billboard(star, copy);
  }
}
