// Discs in front of each other: the Sun covered by the Moon for an observer, and by the Earth for a point of the Moon.
// Radii and separations may be in any one unit where only their ratios matter.

// x - sin x for x >= 0, without its cancellation near 0.
FN Real angle_minus_sine(Real x) {
  if (x > Real(0.5)) {
    return x - sin(x);
  }
  Real s = x * x;
  Real series = Real(1.0);
  for (int k = 6; k >= 1; --k) {
    series = Real(1.0) - s * series / Real((2 * k + 2) * (2 * k + 3));
  }
  return x * s * series / Real(6.0);
}

// Half the angle, at the centre of a circle, of its chord in common with another circle that it crosses: the triangle
// with the sides radius, separation and other, solved for the half-angle so that no digits are lost near tangency.
FN Real common_chord_half_angle(Real radius, Real other, Real separation) {
  Real opposite = max((other - separation + radius) * (other + separation - radius), Real(0.0));
  Real adjacent = max((separation + radius - other) * (separation + radius + other), Real(0.0));
  return Real(2.0) * atan(sqrt(opposite), sqrt(adjacent));
}

// Share, 0 to 1, of a disc's area that another disc hides. All lengths >= 0; a disc of radius 0 is a point, which is
// hidden (1) inside the other's edge. Discs are flat: for the Sun's and the Moon's this leaves out 1e-5.
FN Real disc_covered(Real radius, Real other, Real separation) {
  if (separation >= radius + other) {
    return Real(0.0);
  }
  if (separation <= abs(radius - other)) {
    Real ratio = other < radius ? other / radius : Real(1.0);
    return ratio * ratio;
  }
  // Two circular segments over the common chord.
  Real own = angle_minus_sine(Real(2.0) * common_chord_half_angle(radius, other, separation));
  Real others = angle_minus_sine(Real(2.0) * common_chord_half_angle(other, radius, separation));
  Real ratio = other / radius;
  return clamp((own + ratio * ratio * others) / (Real(2.0) * pi), Real(0.0), Real(1.0));
}

// The Earth's shadow in space, from its centre. C++ fills it from vesper::LunarEclipseState.
struct EarthShadow {
  vec3 axis;            // unit vector, away from the Sun
  Real sun_distance_km;
  Real sun_radius_km;
  Real edge_radius_km;  // of the Earth with as much of the air as casts the shadow
};

// Where a point (km, from the Earth's centre) lies: distance from the axis and along it, positive behind the Earth, km.
FN vec2 earth_shadow_place(vec3 point_km, EarthShadow shadow) {
  Real along = dot(point_km, shadow.axis);
  return vec2(length(point_km - along * shadow.axis), along);
}

// Radii of umbra and penumbra (x, y) at a distance along the axis, km: the cones that touch Sun and Earth. The umbra's
// is negative beyond its tip.
FN vec2 earth_shadow_radii_km(Real along_km, EarthShadow shadow) {
  Real sine_umbra = (shadow.sun_radius_km - shadow.edge_radius_km) / shadow.sun_distance_km;
  Real sine_penumbra = (shadow.sun_radius_km + shadow.edge_radius_km) / shadow.sun_distance_km;
  return vec2((shadow.edge_radius_km - along_km * sine_umbra) * inversesqrt(Real(1.0) - sine_umbra * sine_umbra),
              (shadow.edge_radius_km + along_km * sine_penumbra) *
                  inversesqrt(Real(1.0) - sine_penumbra * sine_penumbra));
}
