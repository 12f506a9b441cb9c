// The light of the night sky itself: where it comes from along a view. Colours and levels are the caller's.

// Airglow: a shell of even brightness.
CONSTANT Real airglow_bottom_km = Real(85.0);
CONSTANT Real airglow_top_km = Real(95.0);

FN Real half_chord(Real radius, Real perigee) {
  return sqrt(max((radius - perigee) * (radius + perigee), Real(0.0)));
}

// Lengths of a view inside the shell, over its thickness (van Rhijn's function, of a shell that is not thin: finite for
// observers in it and along its limb): x before the view dips under the shell, y beyond, through the air. Nothing beyond
// the ground.
FN vec2 airglow_paths(Real sin_altitude, Real height_km, Real ground_km) {
  Real radius = ground_km + height_km;
  Real along = radius * sin_altitude;
  Real perigee = radius * sqrt(max((Real(1.0) - sin_altitude) * (Real(1.0) + sin_altitude), Real(0.0)));
  Real inner = half_chord(ground_km + airglow_bottom_km, perigee);
  Real outer = half_chord(ground_km + airglow_top_km, perigee);
  bool blocked = along < Real(0.0) && perigee < ground_km;
  Real near = max(-inner - max(-outer, along), Real(0.0));
  Real far = blocked ? Real(0.0) : max(outer - max(inner, along), Real(0.0));
  return vec2(near, far) / (airglow_top_km - airglow_bottom_km);
}

// Zodiacal light. Directions have x towards the Sun in the ecliptic and z to the ecliptic's north pole.

// Places in its map, 0 to 1 along each side: about the Sun, from the ecliptic to its poles, and away from the Sun, from it
// to its opposite, near both of which the map is fine. Both without the direction's sign, which the light does not have.
FN vec2 zodiacal_place(vec3 direction) {
  vec3 size = abs(direction);
  Real from_axis = sqrt(length(vec2(size.y, size.z)));
  Real to_nearest = from_axis / (from_axis + sqrt(Real(1.0) + size.x));
  return vec2(size.z / max(size.y + size.z, Real(1.0e-12)),
              direction.x > Real(0.0) ? to_nearest : Real(1.0) - to_nearest);
}

FN vec3 zodiacal_direction(vec2 place) {
  bool sunward = place.y < Real(0.5);
  Real to_nearest = sunward ? place.y : Real(1.0) - place.y;
  Real ratio = to_nearest / (Real(1.0) - to_nearest);
  Real half_tangent = ratio * ratio; // of half the angle to the Sun or to its opposite
  Real along = (Real(1.0) - half_tangent) * (Real(1.0) + half_tangent);
  vec2 across = Real(2.0) * half_tangent * normalize(vec2(Real(1.0) - place.x, place.x));
  return vec3(sunward ? along : -along, across.x, across.y) / (Real(1.0) + half_tangent * half_tangent);
}

FN Real sun_elongation(vec3 direction) {
  return atan(length(vec2(direction.y, direction.z)), direction.x);
}

// Binary logarithm of the law that the map holds ratios to, 0 at the mean edge of the Sun's disc: the dust's corona
// (r^-2.25 in the plane of the ecliptic, r^-2.47 square to it: Koutchmy and Lamy 1985), with an oblateness that grows no
// more far from the Sun and is gone opposite to it. Distances are chords of the sphere.
CONSTANT Real dust_sun_radius = Real(0.004653);
FN Real log2_dust_law(vec3 direction) {
  Real across2 = max(direction.y * direction.y + direction.z * direction.z, Real(1.0e-12));
  Real chord2 = direction.x > Real(0.0) ? Real(2.0) * across2 / (Real(1.0) + direction.x)
                                        : Real(2.0) * (Real(1.0) - direction.x);
  Real upright2 = direction.z * direction.z / chord2;
  Real r = max(sqrt(chord2) / dust_sun_radius, Real(1.0));
  Real log2_r = log2(r);
  return -Real(2.25) * log2_r - Real(0.22) * upright2 * (log2_r - log2(Real(1.0) + Real(0.01) * r));
}

// Number of the Sun's layer for the dust that it draws as the Sun's corona (f_corona in sun.glsl), which ends where
// zodiacal light begins.
FN Real dust_in_corona(vec3 direction, Real sin_sun_radius) {
  Real r = max(length(vec2(direction.y, direction.z)) / sin_sun_radius, Real(1.0));
  return direction.x > Real(0.0) && r <= corona_edge ? f_corona(r) : Real(0.0);
}
