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

// Places in its map: ecliptic longitude from the Sun over pi, latitude over pi/2, both without their sign.
FN vec2 zodiacal_place(vec3 direction) {
  Real level = length(vec2(direction));
  return vec2(atan(abs(direction.y) + Real(1.0e-12), direction.x), Real(2.0) * atan(abs(direction.z), level)) / pi;
}

FN Real sun_elongation(vec3 direction) {
  return atan(length(vec2(direction.y, direction.z)), direction.x);
}

// The law that the map holds ratios to, 1 at the mean edge of the Sun's disc: the dust's corona (r^-2.25 in the plane of
// the ecliptic, r^-2.47 square to it: Koutchmy and Lamy 1985), with an oblateness that grows no more far from the Sun
// and is gone opposite to it.
CONSTANT Real dust_sun_radius = Real(0.004653);
FN Real dust_law(vec3 direction) {
  Real r = max(sun_elongation(direction) / dust_sun_radius, Real(1.0));
  Real across2 = max(direction.y * direction.y + direction.z * direction.z, Real(1.0e-12));
  Real chord2 = direction.x > Real(0.0) ? Real(2.0) * across2 / (Real(1.0) + direction.x)
                                        : Real(2.0) * (Real(1.0) - direction.x);
  Real upright2 = direction.z * direction.z / chord2;
  return exp2(-Real(2.25) * log2(r) - Real(0.22) * upright2 * log2(r / (Real(1.0) + Real(0.01) * r)));
}

// Number of the Sun's layer for the dust that it draws as the Sun's corona (f_corona in sun.glsl), which ends where
// zodiacal light begins.
FN Real dust_in_corona(vec3 direction, Real sin_sun_radius) {
  Real r = max(length(vec2(direction.y, direction.z)) / sin_sun_radius, Real(1.0));
  return direction.x > Real(0.0) && r <= corona_edge ? f_corona(r) : Real(0.0);
}

// The light of stars too faint to be drawn, in S10(V): a slab of stars and dust, A (1 - exp(-t / sin b)), which is 160
// on the galactic equator in the anticentre, 640 toward the centre, and 30 at the poles.
CONSTANT Real starlight_equator_s10 = Real(320.0);
CONSTANT Real starlight_depth = Real(0.098440); // -ln(1 - 30 / 320)
FN Real starlight_s10(vec3 galactic) {
  Real slab = Real(1.0) - exp(-starlight_depth / max(abs(galactic.z), Real(1.0e-4)));
  return starlight_equator_s10 * exp2(galactic.x) * slab;
}
