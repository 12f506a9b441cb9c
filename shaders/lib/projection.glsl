// Projections of the sphere onto a picture. Directions are in view axes: x right, y up, z forward. Pixels count from
// the top left corner, y down; the centre of the first pixel is (0.5, 0.5).

CONSTANT int projection_perspective = 0;     // gnomonic, focal length in pixels per unit tangent
CONSTANT int projection_fisheye = 1;         // azimuthal equidistant, pixels per radian
CONSTANT int projection_stereographic = 2;   // conformal, pixels per radian at the centre
CONSTANT int projection_equirectangular = 3; // longitude and latitude about the view direction
CONSTANT int projection_cubemap = 4;         // six gnomonic faces as cube_map.glsl stacks them

struct ProjectionFrame {
  int kind;
  PVec2 size;  // pixels of the whole picture
  PReal focal; // pixels per unit, see above; half a face for the cube map, unused by the equirectangular map
};

// The angle atan2(y, x) for y >= 0, in [0, pi], from algebraic operations alone: GLSL has no double-precision
// trigonometry. Four half-angle steps, then the series; error below 1e-13 in double precision.
FN PReal arc_tangent(PReal y, PReal x) {
  PReal r = sqrt(x * x + y * y);
  // tan(angle/2), in the form that does not cancel; the last case only meets exact opposition.
  PReal t = x > PReal(0.0) ? y / (r + x) : (r - x) / max(y, PReal(1.0e-30));
  for (int i = 0; i < 3; ++i) {
    t = t / (PReal(1.0) + sqrt(PReal(1.0) + t * t));
  }
  PReal s = t * t;
  PReal series = PReal(0.0);
  for (int i = 8; i >= 0; --i) {
    series = PReal(1.0) / PReal(2 * i + 1) - s * series;
  }
  return PReal(16.0) * t * series;
}

// The same for any y, in (-pi, pi].
FN PReal signed_arc_tangent(PReal y, PReal x) { return y < PReal(0.0) ? -arc_tangent(-y, x) : arc_tangent(y, x); }

// View axes and those of the cube map, whose Z points backward: each of the other.
FN PVec3 cube_from_view(PVec3 direction) { return PVec3(direction.x, direction.y, -direction.z); }

// cube_face of a direction in view axes.
FN int cube_face_by_rank(PVec3 direction, int rank) { return cube_face(cube_from_view(direction), rank); }

// Pixel of a unit direction. Face is only used by the cube map: its pixel may then lie outside the face, on the plane
// that continues it. False where the projection has no place for the direction.
FN bool project(PVec3 direction, int face, ProjectionFrame frame, OUT(PVec2) pixel) {
  PVec2 centre = PReal(0.5) * frame.size;
  PReal radius = sqrt(direction.x * direction.x + direction.y * direction.y);
  PVec2 offset = PVec2(direction.x, -direction.y);
  pixel = centre;
  if (frame.kind == projection_perspective) {
    if (direction.z <= PReal(1.0e-3)) {
      return false;
    }
    pixel = centre + (frame.focal / direction.z) * offset;
    return true;
  }
  if (frame.kind == projection_fisheye) {
    PReal scale =
        radius > PReal(0.0) ? arc_tangent(radius, direction.z) / radius : PReal(1.0);
    pixel = centre + (frame.focal * scale) * offset;
    return radius > PReal(0.0) || direction.z > PReal(0.0);
  }
  if (frame.kind == projection_stereographic) {
    PReal denominator = PReal(1.0) + direction.z;
    if (denominator < PReal(1.0e-4)) {
      return false;
    }
    pixel = centre + (PReal(2.0) * frame.focal / denominator) * offset;
    return true;
  }
  if (frame.kind == projection_equirectangular) {
    PReal longitude = signed_arc_tangent(direction.x, direction.z);
    PReal latitude =
        signed_arc_tangent(direction.y, sqrt(direction.x * direction.x + direction.z * direction.z));
    PReal half_turn = signed_arc_tangent(PReal(0.0), PReal(-1.0));
    pixel = centre + PVec2(longitude * frame.size.x / (PReal(2.0) * half_turn), -latitude * frame.size.y / half_turn);
    return true;
  }
  PVec3 local = transpose(cube_face_axes(face)) * cube_from_view(direction);
  if (local.z <= PReal(1.0e-3)) {
    return false;
  }
  PReal half_face = frame.focal;
  pixel = PVec2(half_face + half_face * local.x / local.z,
                half_face * PReal(2 * face + 1) - half_face * local.y / local.z);
  return true;
}

// What the per-pixel functions need of a ProjectionFrame, in the GPU's own precision.
struct PixelFrame {
  int kind;
  vec2 size;
  Real focal;
};

// Unit direction in view axes through a point of the picture; false outside the picture's sphere (beyond the fisheye's
// circle).
FN bool unproject(vec2 pixel, PixelFrame frame, OUT(vec3) direction) {
  vec2 offset = vec2(pixel.x - Real(0.5) * frame.size.x, Real(0.5) * frame.size.y - pixel.y);
  direction = vec3(Real(0.0), Real(0.0), Real(1.0));
  if (frame.kind == projection_perspective) {
    direction = normalize(vec3(offset.x, offset.y, frame.focal));
    return true;
  }
  if (frame.kind == projection_fisheye) {
    Real radius = length(offset);
    Real angle = radius / frame.focal;
    Real scale = radius > Real(0.0) ? sin(angle) / radius : Real(0.0);
    direction = vec3(scale * offset.x, scale * offset.y, cos(angle));
    return radius <= Real(0.5) * min(frame.size.x, frame.size.y);
  }
  if (frame.kind == projection_stereographic) {
    vec2 plane = offset / (Real(2.0) * frame.focal);
    Real s = dot(plane, plane);
    direction = vec3(Real(2.0) * plane.x, Real(2.0) * plane.y, Real(1.0) - s) / (Real(1.0) + s);
    return true;
  }
  if (frame.kind == projection_equirectangular) {
    Real longitude = Real(2.0) * pi * offset.x / frame.size.x;
    Real latitude = pi * offset.y / frame.size.y;
    direction = vec3(cos(latitude) * sin(longitude), sin(latitude), cos(latitude) * cos(longitude));
    return true;
  }
  int face = clamp(int(floor(pixel.y / frame.size.x)), 0, 5);
  vec2 plane = vec2(pixel.x, pixel.y - Real(face) * frame.size.x) / frame.focal - vec2(Real(1.0), Real(1.0));
  vec3 outward = mat3(cube_face_axes(face)) * vec3(plane.x, -plane.y, Real(1.0));
  direction = normalize(vec3(outward.x, outward.y, -outward.z));
  return true;
}

// One over the solid angle of the pixel with the given centre, 1/sr, from the projection's area element at the centre;
// 0 outside the fisheye's circle. Against the pixel's exact solid angle: within 1e-4 up to a field of 120 degrees at
// 256 pixels, 0.2 % for a perspective of 170 degrees at 256 pixels.
FN Real pixels_per_steradian(vec2 pixel, PixelFrame frame) {
  vec2 offset = pixel - Real(0.5) * frame.size;
  if (frame.kind == projection_perspective) {
    vec2 plane = offset / frame.focal;
    Real t = Real(1.0) + dot(plane, plane);
    return frame.focal * frame.focal * t * sqrt(t);
  }
  if (frame.kind == projection_fisheye) {
    Real radius = length(offset);
    Real angle = radius / frame.focal;
    // Near the antipode the pixel's own extent bounds the sine.
    Real scale = angle > Real(1.0e-3) ? angle / max(sin(angle), Real(0.25) / frame.focal) : Real(1.0);
    return radius <= Real(0.5) * min(frame.size.x, frame.size.y) ? frame.focal * frame.focal * scale : Real(0.0);
  }
  if (frame.kind == projection_stereographic) {
    vec2 plane = offset / (Real(2.0) * frame.focal);
    Real t = Real(1.0) + dot(plane, plane);
    return frame.focal * frame.focal * t * t;
  }
  if (frame.kind == projection_equirectangular) {
    // Exact: the difference of the sines of the pixel's edges.
    Real latitude = pi * offset.y / frame.size.y;
    return frame.size.x / (Real(4.0) * pi * cos(latitude) * sin(Real(0.5) * pi / frame.size.y));
  }
  Real row = pixel.y - floor(pixel.y / frame.size.x) * frame.size.x;
  vec2 plane = vec2(offset.x, row - frame.focal) / frame.focal;
  Real t = Real(1.0) + dot(plane, plane);
  return frame.focal * frame.focal * t * sqrt(t);
}

// Share of what is spread about a pixel, normally with a standard deviation in pixels, that falls within the circle of a
// fisheye; within 0.01 (the normal integral by a logistic curve). Other projections fill their pictures.
FN Real share_in_circle(vec2 pixel, Real sigma, PixelFrame frame) {
  if (frame.kind != projection_fisheye) {
    return Real(1.0);
  }
  Real within = Real(0.5) * min(frame.size.x, frame.size.y) - length(pixel - Real(0.5) * frame.size);
  return Real(1.0) / (Real(1.0) + exp(clamp(Real(-1.702) * within / sigma, Real(-30.0), Real(30.0))));
}

// Width on the sky of the pixel with the given centre, rad: along its longer side where the projection stretches it.
FN Real pixel_width(vec2 pixel, PixelFrame frame) {
  vec2 offset = pixel - Real(0.5) * frame.size;
  if (frame.kind == projection_fisheye) {
    return Real(1.0) / frame.focal;
  }
  if (frame.kind == projection_stereographic) {
    vec2 plane = offset / (Real(2.0) * frame.focal);
    return Real(1.0) / (frame.focal * (Real(1.0) + dot(plane, plane)));
  }
  if (frame.kind == projection_equirectangular) {
    Real across = Real(2.0) * cos(pi * offset.y / frame.size.y) / frame.size.x;
    return pi * max(Real(1.0) / frame.size.y, across);
  }
  if (frame.kind == projection_cubemap) {
    offset.y = pixel.y - floor(pixel.y / frame.size.x) * frame.size.x - frame.focal;
  }
  return inversesqrt(frame.focal * frame.focal + dot(offset, offset));
}
