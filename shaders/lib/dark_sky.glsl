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

// Places in its map, 0 to 1 along each side: of the ecliptic longitude from the Sun, without its sign, and of the latitude,
// likewise. Both are even along the sides of a square, for which no angle need be found; the kink between two sides, at a
// longitude of 90 degrees, falls on the middle of the map.
FN vec2 zodiacal_place(vec3 direction) {
  vec3 size = abs(direction);
  Real level = length(vec2(direction));
  Real along = direction.x / max(size.x + size.y, Real(1.0e-12));
  return vec2(Real(0.5) - Real(0.5) * along, size.z / (size.z + level));
}

FN vec3 zodiacal_direction(vec2 place) {
  Real along = Real(1.0) - Real(2.0) * place.x;
  vec2 level = (Real(1.0) - place.y) * normalize(vec2(along, Real(1.0) - abs(along)));
  return normalize(vec3(level.x, level.y, place.y));
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
