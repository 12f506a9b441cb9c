// Astronomical refraction: from a direction without air to the direction seen, and back.
//
// Directions are unit vectors in the horizon frame (z = zenith). All that is computed or stored is the bend: the angle
// of refraction over the cosine of the altitude, which stays smooth at the zenith and lets the vector be turned without
// ever asking for its azimuth.

CONSTANT int refraction_none = 0;
CONSTANT int refraction_published = 1; // Saemundsson's formula
CONSTANT int refraction_traced = 2;    // a table of traced rays

// What all pixels of a frame share. C++ fills it from vesper::Refraction.
struct RefractionFrame {
  int kind;
  Real strength;          // factor of all refraction: pressure and temperature of the published formula; for a table,
                          // the refractivity of the wanted wavelength over that of the table's
  Real horizon_apparent;  // sine of the altitude of the ray that grazes the ground, as it is seen: where nodes crowd
  Real horizon_true;      // and without air
  vec2 scale_apparent;    // nodes per unit of arc_sinh below and above the horizon
  vec2 scale_true;
};

// The table's nodes stand at equal steps of arc_sinh((sin(altitude) - horizon) / width) below and above the horizon.
// A texel: bend at the apparent altitude, its slope by arc_sinh, the same at the true altitude.
CONSTANT Real refraction_width = Real(0.03);
CONSTANT int refraction_intervals_below = 64;
CONSTANT int refraction_intervals_above = 96;

FN Real arc_sinh(Real x) {
  Real size = log(abs(x) + sqrt(x * x + Real(1.0)));
  return x < Real(0.0) ? -size : size;
}

// The unit vector raised towards the zenith by bend * cos(altitude), at most 0.2 rad.
FN PVec3 raised(PVec3 direction, PReal bend) {
  PReal across2 = direction.x * direction.x + direction.y * direction.y;
  PReal angle2 = bend * bend * across2;
  // Sine over angle and cosine, within 1e-13 at 0.1 rad.
  PReal turn = bend * (PReal(1.0) - angle2 / PReal(6.0) *
                       (PReal(1.0) - angle2 / PReal(20.0) * (PReal(1.0) - angle2 / PReal(42.0))));
  PReal cosine = PReal(1.0) - angle2 / PReal(2.0) *
                 (PReal(1.0) - angle2 / PReal(12.0) *
                  (PReal(1.0) - angle2 / PReal(30.0) * (PReal(1.0) - angle2 / PReal(56.0))));
  PReal across = cosine - direction.z * turn;
  return PVec3(across * direction.x, across * direction.y, cosine * direction.z + across2 * turn);
}

// Interpolates the table (Hermite's cubics) at a sine of altitude.
FN Real table_bend(Real sin_altitude, bool apparent, RefractionFrame frame, sampler1D table) {
  Real horizon = apparent ? frame.horizon_apparent : frame.horizon_true;
  vec2 scale = apparent ? frame.scale_apparent : frame.scale_true;
  Real x = arc_sinh((sin_altitude - horizon) / refraction_width);
  Real nodes_per_x = x < Real(0.0) ? scale.x : scale.y;
  int last = refraction_intervals_below + refraction_intervals_above;
  Real at = clamp(Real(refraction_intervals_below) + x * nodes_per_x, Real(0.0), Real(last));
  int node = min(int(at), last - 1);
  vec4 a = texelFetch(table, node, 0);
  vec4 b = texelFetch(table, node + 1, 0);
  vec2 left = apparent ? vec2(a.x, a.y) : vec2(a.z, a.w);
  vec2 right = apparent ? vec2(b.x, b.y) : vec2(b.z, b.w);
  Real f = at - Real(node);
  Real g = Real(1.0) - f;
  return g * g * ((Real(1.0) + Real(2.0) * f) * left.x + f * left.y / nodes_per_x) +
         f * f * ((Real(1.0) + Real(2.0) * g) * right.x - g * right.y / nodes_per_x);
}

CONSTANT Real degrees_per_radian = Real(57.295779513082321);
// Where the published formula has its largest value, 44.6 arcmin: -5.11 + sqrt(10.3). Below it the formula falls, to
// cross zero and a pole at -5.11 degrees; here it fades to nothing at the nadir.
CONSTANT Real published_lowest_deg = Real(-1.9006388);

// Refraction in radians at a true altitude in degrees, and its derivative by the altitude in radians: Saemundsson 1986
// (Sky and Telescope 72, 70) with the constant of Meeus 1998 (chapter 16) that makes it vanish at the zenith, for
// 1010 hPa and 10 C.
FN vec2 published_refraction(Real true_altitude_deg) {
  Real h = max(true_altitude_deg, published_lowest_deg);
  Real shifted = h + Real(5.11);
  Real angle = (h + Real(10.3) / shifted) / degrees_per_radian;
  Real arcminute = Real(1.0) / (Real(60.0) * degrees_per_radian);
  Real sine = sin(angle);
  Real value = arcminute * (Real(1.02) * cos(angle) / sine + Real(0.0019279));
  Real slope = -arcminute * Real(1.02) * (Real(1.0) - Real(10.3) / (shifted * shifted)) / (sine * sine);
  Real below = (h - true_altitude_deg) / (Real(90.0) + published_lowest_deg);
  return vec2(value * (Real(1.0) - below * below),
              slope + value * Real(2.0) * below * degrees_per_radian / (Real(90.0) + published_lowest_deg));
}

// Bend of the published formula at a true altitude, or at an apparent one, where the formula is solved for (Newton,
// three steps: within 1e-7 rad of the true altitude that leads there).
FN Real published_bend(Real altitude_rad, Real cos_altitude, bool apparent, Real strength) {
  Real true_altitude = altitude_rad;
  vec2 refraction = strength * published_refraction(true_altitude * degrees_per_radian);
  if (apparent) {
    for (int i = 0; i < 3; ++i) {
      true_altitude -= (true_altitude + refraction.x - altitude_rad) / (Real(1.0) + refraction.y);
      refraction = strength * published_refraction(true_altitude * degrees_per_radian);
    }
  }
  return refraction.x / max(cos_altitude, Real(1.0e-6));
}

// Bend at a direction that is apparent (seen through the air) or true (without air).
FN Real refraction_bend(PVec3 direction, bool apparent, RefractionFrame frame, sampler1D table) {
  if (frame.kind == refraction_none) {
    return Real(0.0);
  }
  if (frame.kind == refraction_published) {
    Real across = Real(sqrt(direction.x * direction.x + direction.y * direction.y));
    return published_bend(atan(Real(direction.z), across), across, apparent, frame.strength);
  }
  return frame.strength * table_bend(Real(direction.z), apparent, frame, table);
}

// Where a source in a true direction is seen.
FN PVec3 apparent_direction(PVec3 true_direction, RefractionFrame frame, sampler1D table) {
  return raised(true_direction, PReal(refraction_bend(true_direction, false, frame, table)));
}

// Where what is seen in a direction truly stands: for each pixel of a disc, which is flattened by it.
FN PVec3 true_direction_of(PVec3 apparent, RefractionFrame frame, sampler1D table) {
  return raised(apparent, PReal(-refraction_bend(apparent, true, frame, table)));
}
