// The disc of a far sphere, the Moon's or the Sun's, as a picture sees it through the air that bends its light.
//
// Places on the disc are in units of its radius, x level and y towards the zenith: those of an orthographic picture from
// infinitely far away, which the sine of the angle to the centre gives from any distance. They are reckoned from the
// centre out, so that a float is worth 1e-6 of the disc near the middle of a narrow picture.

// C++ fills it from vesper::PlannedDisc; the order is that of a std140 block.
struct DiscFrame {
  vec3 centre;      // where it is seen; all vectors are along view axes
  Real sine;        // of its angular radius
  vec3 right;       // level, square to the centre
  Real scale;       // its picture is larger by this factor about its centre
  vec3 upward;      // towards the zenith, square to where the centre stands without air
  Real flattening;  // height over width as the centre is seen
  vec3 zenith;
  Real along;       // the centre's own share in where it stands (disc_raising)
  Real turn;        // and the zenith's
  Real up_centre;   // upward times the centre as it is seen, and times the zenith
  Real up_zenith;
  Real padding;
};

// What a bend (lib/refraction.glsl) makes of a direction d of a given sine of altitude: x d + y zenith.
FN vec2 disc_raising(Real sin_altitude, Real bend) {
  Real angle2 = bend * bend * max(Real(1.0) - sin_altitude * sin_altitude, Real(0.0));
  Real turn = bend * (Real(1.0) - angle2 / Real(6.0) * (Real(1.0) - angle2 / Real(20.0)));
  Real cosine = Real(1.0) - angle2 / Real(2.0) * (Real(1.0) - angle2 / Real(12.0) * (Real(1.0) - angle2 / Real(30.0)));
  return vec2(cosine - sin_altitude * turn, turn);
}

// Place on the disc of what is seen in a direction, whose bend at the apparent altitude is given. Only directions less
// than a right angle from the centre have one.
FN vec2 disc_place(vec3 direction, Real bend, DiscFrame disc) {
  vec2 raising = disc_raising(dot(disc.zenith, direction), -bend);
  vec3 off = direction - disc.centre;
  Real across = raising.x * dot(disc.right, off);
  Real up = raising.x * dot(disc.upward, off) + (raising.x - disc.along) * disc.up_centre +
            (raising.y - disc.turn) * disc.up_zenith;
  return vec2(across, up) / (disc.sine * disc.scale);
}

// The step of places between two directions close to each other.
FN vec2 disc_step(vec3 step, DiscFrame disc) {
  return vec2(dot(disc.right, step), dot(disc.upward, step) / disc.flattening) / (disc.sine * disc.scale);
}

// Share of a pixel inside the limb, at a distance r of its centre from that of the disc; width: of the pixel in the
// direction of r. Over all pixels the shares add up to the disc's area.
FN Real disc_cover(Real r, Real width) {
  Real edge = Real(1.0) - width * width / Real(24.0);
  return clamp(Real(0.5) + (edge - r) / width, Real(0.0), Real(1.0));
}

// Distance from the disc's centre at which the sphere is turned towards the observer as it is on the average over what
// such a pixel has inside of the limb: where it takes its light. The cosine falls to the limb as a root does, so that
// its mean is not that of the middle.
FN Real disc_inner(Real r, Real width) {
  Real outer = r + Real(0.5) * width;
  Real inner = max(r - Real(0.5) * width, Real(0.0));
  Real a = sqrt(max(Real(1.0) - outer * outer, Real(0.0)));
  Real b = sqrt(max(Real(1.0) - inner * inner, Real(1.0e-12)));
  Real cosine = Real(2.0 / 3.0) * (a * a + a * b + b * b) / (a + b);
  return sqrt(max(Real(1.0) - cosine * cosine, Real(0.0)));
}

// Unit vector from the observer to a place: x level, y up, z to the disc's centre. The last is more than 0.
FN vec3 disc_sight(vec2 place, Real sine) {
  vec2 across = sine * place;
  return vec3(across.x, across.y, sqrt(max(Real(1.0) - dot(across, across), Real(0.0))));
}

// The sphere's normal at a place inside the limb, along the same axes: where the sight first meets the sphere.
FN vec3 disc_normal(vec2 place, Real sine) {
  Real square = min(dot(place, place), Real(1.0));
  Real height = sqrt(Real(1.0) - square); // cosine of the sight to the normal
  Real cosine = sqrt(Real(1.0) - sine * sine * square);
  Real across = cosine - sine * height;
  return vec3(across * place.x, across * place.y, -sine * square - height * cosine);
}

// Whether light stands above a place's horizon. above: it would at the limb; below_limb: square of the place less 1;
// z2: square of the light's depth behind the disc.
FN bool disc_is_lit(Real above, Real below_limb, Real z2) {
  return above > Real(0.0) && above * above > -z2 * below_limb;
}

// What a straight line of places shows of the sphere is an arc: a place on it is (middle + radius sin(angle)) times the
// line's length from its beginning.
struct DiscArc {
  Real middle;
  Real radius;
  Real start; // angles
  Real end;
};

// The part of that arc that a light behind the disc may reach, nothing unless start < end. Between limb and terminator
// it is the whole; where a line cuts both horns of the crescent, what is between them too.
// to_light: unit vector along the axes of disc_sight, z not negative: a crescent, or half a disc
// reach: sine of the depth below the sphere's own horizon that light gets to
FN DiscArc disc_lit_arc(vec2 from, vec2 line, vec3 to_light, Real reach) {
  DiscArc arc;
  arc.start = Real(0.0);
  arc.end = Real(0.0);
  Real square = dot(line, line);
  Real half_slope = dot(from, line);
  Real below_limb = dot(from, from) - Real(1.0);
  arc.middle = -half_slope / square;
  arc.radius = sqrt(max(half_slope * half_slope - square * below_limb, Real(0.0))) / square;
  Real low = max(arc.middle - arc.radius, Real(0.0));
  Real high = min(arc.middle + arc.radius, Real(1.0));
  if (low >= high) {
    return arc;
  }
  // Light stands as high as start + t slope, less the share of z: a convex function, so that what is dark is one piece.
  Real start = reach + dot(vec2(to_light.x, to_light.y), from);
  Real slope = dot(vec2(to_light.x, to_light.y), line);
  Real z2 = to_light.z * to_light.z;
  bool low_lit = disc_is_lit(start + low * slope, below_limb + low * (Real(2.0) * half_slope + low * square), z2);
  bool high_lit = disc_is_lit(start + high * slope, below_limb + high * (Real(2.0) * half_slope + high * square), z2);
  if (!low_lit && !high_lit) {
    return arc;
  }
  if (low_lit != high_lit) {
    Real a = slope * slope + z2 * square;
    Real b = start * slope + z2 * half_slope;
    Real root = sqrt(max(b * b - a * (start * start + z2 * below_limb), Real(0.0)));
    Real edge = clamp((high_lit ? root - b : -root - b) / a, low, high);
    low = high_lit ? edge : low;
    high = high_lit ? high : edge;
  }
  low -= arc.middle;
  high -= arc.middle;
  // GLSL promises nothing of an arc sine's error; 2e-4 was found.
  arc.start = atan(low, sqrt(max((arc.radius - low) * (arc.radius + low), Real(0.0))));
  arc.end = atan(high, sqrt(max((arc.radius - high) * (arc.radius + high), Real(0.0))));
  return arc;
}

// By how much a larger picture is darker, so that its light stays the same: exact at every place.
FN Real disc_dimming(vec2 place, Real sine, Real scale) {
  Real square = sine * sine * dot(place, place);
  Real scaled = max(Real(1.0) - scale * scale * square, Real(0.0));
  return sqrt(scaled / max(Real(1.0) - square, Real(1.0e-6))) / (scale * scale);
}
