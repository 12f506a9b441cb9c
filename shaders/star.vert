// One instanced billboard a star: place, brightness and the pixel rectangle of its point-spread function.
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

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 proper_motion;
layout(location = 2) in float parallax;
layout(location = 3) in float radial_velocity;
layout(location = 4) in float illuminance;
layout(location = 5) in vec4 color;
layout(location = 6) in uint number;

flat out vec2 star_pixel;
flat out vec2 star_scale;  // of an offset in pixels to the argument of the profile
flat out vec4 star_light;  // X, Y, Z, S illuminance of the profile's peak, lux a pixel
flat out float star_glare; // cheap tier: intensity of the glare over the light

const vec4 outside = vec4(2.0, 2.0, 2.0, 1.0);

// A rectangle of whole pixels, high excluded.
struct Box {
  vec2 low;
  vec2 high;
};

Box clipped(vec2 pixel, vec2 radius, vec2 first, vec2 last) {
  return Box(clamp(floor(pixel - radius), first, last), clamp(ceil(pixel + radius), first, last));
}

void place_corner(Box box) {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? box.low.x : box.high.x, (gl_VertexID & 2) == 0 ? box.low.y : box.high.y);
  // Row 0 of the picture is row 0 of the framebuffer, or of its first strip.
  corner = clamp(corner - vec2(0.0, block.strip.x), vec2(0.0), vec2(float(block.size.x), block.strip.y));
  gl_Position = vec4(2.0 * corner / vec2(float(block.size.x), block.strip.y) - 1.0, 0.0, 1.0);
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

void main() {
  StarPlaceFrame place_frame =
      StarPlaceFrame(block.years, block.observer_au, block.velocity_c, block.lorentz_inverse, block.sun_to_observer,
                     block.solar_potential);
  dvec3 icrs = star_place(dvec3(position), dvec3(proper_motion), double(parallax), double(radial_velocity), place_frame);
  dvec3 horizon = normalize(block.horizon_from_icrs * icrs);
  dvec3 direction = block.view_from_horizon * horizon;
  float sin_altitude = float(horizon.z);

  ProjectionFrame frame = ProjectionFrame(PROJECTION, block.size, block.focal);
  int copy = gl_InstanceID % block.copies;
  int face = PROJECTION == projection_cubemap ? cube_face_by_rank(direction, copy) : 0;
  dvec2 projected;
  bool visible = project(direction, face, frame, projected);
  star_pixel = vec2(projected);
  star_scale = vec2(1.0);
  star_light = vec4(0.0);
  star_glare = 0.0;
  gl_Position = outside;
  if (!visible) {
    return;
  }

  float path = optical_path(sin_altitude, block.observer_height_km);
  vec4 light = illuminance * color * extinction(block.optical_depth, path);
  uint key = hash_pair(number, block.seed);

#ifdef CHEAP
  if (block.pupil_m > 0.0) {
    light *= mueller_scintillation(key, block.frame_number, path);
  }
  light *= mueller_day_fade(block.sun_sin_altitude);
  star_glare = mueller_glare_intensity(magnitude_of(light.y), block.control_magnitude);
  // The glare's billboard grows with the root of its intensity; the core keeps its size.
  float radius = max(mueller_radius, min(1.5 * sqrt(star_glare), 24.0));
  star_scale = vec2(1.0 / radius);
  star_light = light / (mueller_volume * mueller_radius * mueller_radius);
  vec2 first = PROJECTION == projection_cubemap ? vec2(0.0, float(face) * float(block.size.x)) : vec2(0.0);
  vec2 last = PROJECTION == projection_cubemap ? first + vec2(float(block.size.x)) : vec2(block.size);
  if (PROJECTION == projection_equirectangular && copy == 1) {
    star_pixel.x += star_pixel.x < 0.5 * last.x ? last.x : -last.x;
  }
  place_corner(clipped(star_pixel, vec2(radius), first, last));
#else
  float sigma = psf_sigma(light.y);
  float radius = psf_cut(light.y) * sigma;
  // Last, because the spread must not breathe with it.
  if (block.pupil_m > 0.0) {
    light *= scintillation(key, block.seconds, sin_altitude, block.exposure_s, block.pupil_m);
  }
  vec2 size = vec2(block.size);
  star_scale = vec2(psf_scale(sigma));
  if (PROJECTION == projection_equirectangular) {
    // A round star is as wide as the picture at the pole. The sphere ends at the upper and lower edge: what the spread
    // would lose there stays in the rows that are left.
    float cos_latitude = sqrt(max(1.0 - float(direction.y * direction.y), 0.0));
    float wide_radius = min(radius / max(cos_latitude, 1.0e-6), 0.5 * size.x);
    float wide_sigma = sigma * wide_radius / radius;
    star_scale.x = psf_scale(wide_sigma);
    Box box = clipped(star_pixel, vec2(wide_radius, radius), vec2(-size.x, 0.0), vec2(2.0 * size.x, size.y));
    star_light = light / (psf_axis_sum(star_pixel.x, box.low.x, box.high.x, wide_sigma) *
                          psf_axis_sum(star_pixel.y, box.low.y, box.high.y, sigma));
    if (copy == 1) {
      star_pixel.x += star_pixel.x < 0.5 * size.x ? size.x : -size.x;
    }
    place_corner(clipped(star_pixel, vec2(wide_radius, radius), vec2(0.0), size));
  } else if (PROJECTION == projection_cubemap) {
    star_light = light / (face_sum(direction, 0, frame, radius, sigma) + face_sum(direction, 1, frame, radius, sigma) +
                          face_sum(direction, 2, frame, radius, sigma));
    vec2 first = vec2(0.0, float(face) * size.x);
    place_corner(clipped(star_pixel, vec2(radius), first, first + vec2(size.x)));
  } else {
    vec2 spread = vec2(radius);
    star_light = light / box_sum(star_pixel, Box(floor(star_pixel - spread), ceil(star_pixel + spread)), sigma);
    place_corner(clipped(star_pixel, spread, vec2(0.0), size));
  }
#endif
}
