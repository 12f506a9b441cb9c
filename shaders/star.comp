// Place, brightness and pixel rectangle of every star's billboards: one invocation a star, so that the four corners
// of a billboard share the work.
//
// PROJECTION is a number of projection.glsl. CHEAP selects Mueller's point-spread function, fades and scintillation.
// DISCS gives every star an angular diameter, which calms its scintillation.
#include "prelude.glsl"
#include "lib/hash.glsl"
#include "lib/star_place.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/star_psf.glsl"
#include "lib/refraction.glsl"
#include "lib/extinction.glsl"
#include "lib/scintillation.glsl"
#include "star_block.glsl"

layout(local_size_x = 64) in;

// One star of the catalogue: vesper::StarRecord as plain floats.
const uint record_floats = 14u;
layout(std430, binding = 0) readonly buffer Records { float records[]; };
layout(std430, binding = 1) readonly buffer Numbers { uint numbers[]; };

layout(binding = 0) uniform sampler1D refraction_table;
#ifndef CHEAP
layout(binding = 1) uniform sampler2D extinction_table;
#endif
#ifdef DISCS
layout(std430, binding = 3) readonly buffer Discs { float disc_rad[]; };
#endif

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

// What all billboards of a star share.
struct PlacedStar {
  dvec3 direction; // unit vector in view axes
  float sin_altitude; // apparent
  uint key;     // of its random numbers
  vec4 light;   // X, Y, Z, S illuminance behind the air, lux
  float radius; // of the billboard, pixels
  float glare;  // cheap tier: intensity of the glare
  float pupil;  // that averages its scintillation, metres
};

PlacedStar place(uint star) {
  uint at = star * record_floats;
  StarPlaceFrame frame = StarPlaceFrame(block.years, block.observer_au, block.velocity_c, block.lorentz_inverse,
                                        block.sun_to_observer, block.solar_potential);
  dvec3 icrs = star_place(dvec3(record_vec3(at)), dvec3(record_vec3(at + 3u)), double(records[at + 6u]),
                          double(records[at + 7u]), frame);
  RefractionFrame refraction =
      RefractionFrame(block.refraction_kind, block.refraction_strength, block.refraction_horizons.x,
                      block.refraction_horizons.y, block.refraction_scales.xy, block.refraction_scales.zw);
  dvec3 horizon =
      apparent_direction(normalize(block.horizon_from_icrs * icrs), refraction, refraction_table);
  float sin_altitude = float(horizon.z);
  vec4 light =
      records[at + 8u] * vec4(records[at + 9u], records[at + 10u], records[at + 11u], records[at + 12u]);
#ifdef CHEAP
  float path = optical_path(sin_altitude, block.observer_height_km);
  light = modulate_xyzs(light, extinction(block.optical_depth, path));
#else
  StarExtinctionFrame air = StarExtinctionFrame(
      block.extinction_rows, block.extinction_columns, block.extinction_horizon, block.extinction_width,
      block.extinction_rows_per_x, block.extinction_reddest, block.extinction_columns_per_hue);
  light *= star_extinction(sin_altitude, light, air, extinction_table);
#endif
  PlacedStar placed = PlacedStar(block.view_from_horizon * horizon, sin_altitude, hash_pair(numbers[star], block.seed),
                                 light, 0.0, 0.0, block.pupil_m);
#ifdef DISCS
  placed.pupil = disc_pupil(block.pupil_m, disc_rad[star], sin_altitude);
#endif
#ifdef CHEAP
  if (block.pupil_m > 0.0) {
    placed.light = modulate_xyzs(light, mueller_scintillation(placed.key, block.frame_number, path));
  }
  placed.light *= mueller_day_fade(block.sun_sin_altitude);
  placed.glare = mueller_glare_intensity(magnitude_of(placed.light.y), block.control_magnitude);
  // The glare's billboard grows with the root of its intensity; the core keeps its size.
  placed.radius = max(mueller_radius, min(1.5 * sqrt(placed.glare), 24.0));
#else
  // From the light without scintillation: the spread must not breathe with it.
  placed.radius = psf_cut(light.y) * psf_sigma;
#endif
  return placed;
}

// The light as the picture receives it. Costs more than all the rest: for stars in the picture only.
vec4 received_light(PlacedStar star) {
#ifndef CHEAP
  if (block.pupil_m > 0.0) {
    return modulate_xyzs(
        star.light, scintillation(star.key, block.seconds, star.sin_altitude, block.exposure_s, star.pupil));
  }
#endif
  return star.light;
}

// One billboard for a star of unit light.
StarBillboard billboard(PlacedStar star, int copy) {
  ProjectionFrame frame = ProjectionFrame(PROJECTION, block.size, block.focal);
  int face = PROJECTION == projection_cubemap ? cube_face_by_rank(star.direction, copy) : 0;
  dvec2 projected;
  bool visible = project(star.direction, face, frame, projected);
  vec2 pixel = vec2(projected);
  vec2 size = vec2(block.size);
  vec2 first = PROJECTION == projection_cubemap ? vec2(0.0, float(face) * size.x) : vec2(0.0);
  vec2 last = PROJECTION == projection_cubemap ? first + vec2(size.x) : size;
  StarBillboard result = StarBillboard(vec4(0.0), pixel, vec2(1.0), vec4(0.0), vec4(star.glare, vec3(0.0)));
  if (!visible) {
    return result;
  }
  vec2 radius = vec2(star.radius);
#ifdef CHEAP
  result.scale = 1.0 / radius;
  float sum = mueller_volume * mueller_radius * mueller_radius;
#else
  result.scale = vec2(psf_scale(psf_sigma));
  float sum;
  if (PROJECTION == projection_equirectangular) {
    // A round star is as wide as the picture at the pole. The sphere ends at the upper and lower edge: what the spread
    // would lose there stays in the rows that are left.
    float cos_latitude = sqrt(max(1.0 - float(star.direction.y * star.direction.y), 0.0));
    radius.x = min(star.radius / max(cos_latitude, 1.0e-6), 0.5 * size.x);
    float wide_sigma = psf_sigma * radius.x / star.radius;
    result.scale.x = psf_scale(wide_sigma);
    Box box = clipped(pixel, radius, vec2(-size.x, 0.0), vec2(2.0 * size.x, size.y));
    sum = psf_axis_sum(pixel.x, box.low.x, box.high.x, wide_sigma) *
          psf_axis_sum(pixel.y, box.low.y, box.high.y, psf_sigma);
  } else if (PROJECTION == projection_cubemap) {
    sum = face_sum(star.direction, 0, frame, star.radius, psf_sigma) +
          face_sum(star.direction, 1, frame, star.radius, psf_sigma) +
          face_sum(star.direction, 2, frame, star.radius, psf_sigma);
  } else {
    sum = box_sum(pixel, Box(floor(pixel - radius), ceil(pixel + radius)), psf_sigma);
  }
#endif
  if (PROJECTION == projection_equirectangular && copy == 1) {
    result.pixel.x += pixel.x < 0.5 * size.x ? size.x : -size.x;
  }
  Box box = clipped(result.pixel, radius, first, last);
  result.box = vec4(box.low, box.high);
  result.light = vec4(1.0 / sum);
  return result;
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= block.star_count) {
    return;
  }
  PlacedStar star = place(index);
  vec4 light = vec4(0.0);
  bool lit = false;
  for (int copy = 0; copy < block.copies; ++copy) {
    StarBillboard result = billboard(star, copy);
    if (all(lessThan(result.box.xy, result.box.zw))) {
      if (!lit) {
        light = received_light(star);
        lit = true;
      }
      result.light *= light;
    }
    billboards[index * uint(block.copies) + uint(copy)] = result;
  }
}
