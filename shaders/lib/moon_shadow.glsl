// The Moon's shadow in the air: how much of the Sun is seen past the Moon from a place near an observer.
//
// Places are in km from the observer. The shadow is given by what the Moon's centre is off the line from the observer to
// the Sun, so that single precision tells places a few metres apart although Sun and Moon are far away.

struct MoonShadow {
  vec3 to_sun;        // unit vector toward the Sun's centre, as the observer stands, without refraction
  vec3 moon_aside_km; // from that line to the Moon's centre, at right angles to it
  Real moon_along_km; // of the Moon's centre along the line, positive
  Real moon_radius_km;
  Real sun_distance_km;
  Real sun_radius_km;
};

// The discs that are seen from a place: angular radii of Sun and Moon, and the angle between their centres, in x, y, z.
// Flat discs: what is left out is 1e-5 of an angle.
FN vec3 moon_shadow_discs(vec3 place_km, MoonShadow shadow) {
  Real along = dot(place_km, shadow.to_sun);
  vec3 aside = place_km - along * shadow.to_sun;
  Real to_sun = shadow.sun_distance_km - along;
  Real to_moon = shadow.moon_along_km - along;
  vec3 apart = (shadow.moon_aside_km - aside) / to_moon + aside / to_sun;
  return vec3(shadow.sun_radius_km / to_sun, shadow.moon_radius_km / to_moon, length(apart));
}

// Share of the Sun's diameter, along the line of centres, that stands out past the Moon's limb: 0 where a total eclipse
// begins, 1 where the discs touch from outside; negative inside the umbra, more than 1 outside the shadow.
FN Real moon_shadow_gap(vec3 discs) { return Real(0.5) * (Real(1.0) + (discs.z - discs.y) / discs.x); }

// Place of a gap in the table of the light that it lets through, 0 to 1: light goes with its power of 3/2.
FN Real moon_shadow_gap_place(Real gap) { return sqrt(clamp(gap, Real(0.0), Real(1.0))); }
FN Real moon_shadow_node_gap(Real place) { return place * place; }

// Share of the Sun's light at four wavelengths at a place. table: over moon_shadow_gap_place, for the Moon's size as the
// observer sees it.
FN vec4 moon_shadow_light(sampler1D table, int nodes, vec3 place_km, MoonShadow shadow) {
  Real place = moon_shadow_gap_place(moon_shadow_gap(moon_shadow_discs(place_km, shadow))) * Real(nodes - 1);
  int i = min(int(place), nodes - 2);
  return mix(texelFetch(table, i, 0), texelFetch(table, i + 1, 0), place - Real(i));
}
