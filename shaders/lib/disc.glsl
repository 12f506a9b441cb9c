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

// By how much a larger picture is darker, so that its light stays the same: exact at every place.
FN Real disc_dimming(vec2 place, Real sine, Real scale) {
  Real square = sine * sine * dot(place, place);
  Real scaled = max(Real(1.0) - scale * scale * square, Real(0.0));
  return sqrt(scaled / max(Real(1.0) - square, Real(1.0e-6))) / (scale * scale);
}
