// Light as rods and cones weigh it: how bright, how coloured.

// Scotopic luminous efficacy at 555 nm over the photopic one, 683 / 1699 (CIE 191:2010).
CONSTANT Real rods_at_555_nm = Real(0.40200118);

// Scotopic over photopic light of a star of B-V = 0.7, which Crumey 2014 (section 3.1) takes as the usual star.
CONSTANT Real usual_star_sp_ratio = Real(2.297);

// XYZ of what rods see, at 1 cd/m2: chromaticity 0.2750, 0.2815. Its hue is that of paintings of moonlit scenes, whose mean
// is 0.25, 0.25 (Jensen et al. 2000); its strength, 0.6 of the way there from white, is a choice of taste: at full strength
// the Milky Way glares like neon. Krawczyk, Myszkowski and Seidel 2005 have 0.300, 0.300, fainter and rather purple.
CONSTANT vec3 night_hue = vec3(Real(0.97691), Real(1.0), Real(1.57549));

FN Real log10_of(Real x) { return Real(0.43429448190325182) * log(x); }

// Luminance in cd/m2 as an eye of the cones' share m sees it (CIE 191:2010, MES2): photopic at 1, scotopic at 0.
FN Real mesopic_luminance(Real photopic_cd_m2, Real scotopic_cd_m2, Real cone_share) {
  Real rods = (Real(1.0) - cone_share) * rods_at_555_nm;
  return (cone_share * photopic_cd_m2 + rods * scotopic_cd_m2) / (cone_share + rods);
}

// The share of the cones, 0 to 1, by log2 of the mesopic luminance in cd/m2 that it gives: m = 0.7670 + 0.3334 log10 of CIE
// 191:2010.
FN Real cone_share_of_octave(Real octave) {
  return clamp(Real(0.7670) + Real(0.10036340) * octave, Real(0.0), Real(1.0));
}

// The share of the cones, 0 to 1, in an eye adapted to a light: the m of CIE 191:2010, which is that of the
// mesopic luminance it gives. 0 in the dark (below 0.005 cd/m2 scotopic), 1 by day
// (above 5 cd/m2 photopic), steady between. Halving, because the customary iteration swings about for reddish light
// (S/P < 0.3). Within 1.2e-4.
// Both luminances: 0 or more.
FN Real mesopic_cone_share(Real photopic_cd_m2, Real scotopic_cd_m2) {
  Real low = Real(0.0);
  Real high = Real(1.0);
  for (int i = 0; i < 12; ++i) {
    Real m = Real(0.5) * (low + high);
    Real seen = mesopic_luminance(photopic_cd_m2, scotopic_cd_m2, m);
    bool more = cone_share_of_octave(log2(max(seen, Real(1.0e-30)))) > m;
    low = more ? m : low;
    high = more ? high : m;
  }
  return high >= Real(1.0) ? Real(1.0) : (low <= Real(0.0) ? Real(0.0) : Real(0.5) * (low + high));
}

// Light as threshold_illuminance_lux counts it, in its unit (cd/m2 or lux): of a background or of a point over it.
// Between rods and cones it is weighed by the mesopic luminance over that of a usual star of the same photopic light
// (Crumey 2014, equations 6 and 16, carried into mesopic light). So the field factor, which was found from stars' V
// magnitudes, keeps its meaning; a red star or a sodium-lit sky counts for less in the dark than its V, a blue one for
// more.
FN Real seen_light(Real photopic, Real scotopic, Real cone_share) {
  Real rods = (Real(1.0) - cone_share) * rods_at_555_nm;
  return (cone_share * photopic + rods * scotopic) / (cone_share + rods * usual_star_sp_ratio);
}

// The colour that light shows to an eye: CIE XYZ whose Y is its mesopic luminance. What the cones see keeps its colour,
// what the rods see is bluish grey, in the proportion of MES2: by day nothing changes, in the dark colour is lost and
// blues outshine reds (Purkinje).
// xyzs: X, Y, Z and scotopic luminance S, cd/m2; cone_share: mesopic_cone_share; rod_hue: X, Y, Z of what rods see, Y = 1.
FN vec3 seen_color(vec4 xyzs, Real cone_share, vec3 rod_hue) {
  Real rods = (Real(1.0) - cone_share) * rods_at_555_nm;
  return (cone_share * vec3(xyzs) + rods * xyzs.w * rod_hue) / (cone_share + rods);
}
FN vec3 seen_color(vec4 xyzs, Real cone_share) { return seen_color(xyzs, cone_share, night_hue); }

// The cheap tier: Thompson, Shirley and Ferwerda 2002 as the thesis gives it (its equations 5.6 to 5.8).

// Scotopic luminance from XYZ by the fit of Larson, Rushmeier and Piatko 1997. It has a pole at X = 0 and is negative
// in deep red: its ratio to Y is kept within 0 and 7.6, the true one at 500 nm where X is least.
FN Real cheap_scotopic_luminance(vec3 xyz) {
  vec3 light = max(xyz, vec3(Real(0.0), Real(0.0), Real(0.0)));
  Real rest = light.y + light.z;
  Real x = max(light.x, max(rest / Real(5.977), Real(1.0e-30)));
  return light.y * max(Real(1.33) * (Real(1.0) + rest / x) - Real(1.68), Real(0.0));
}

// A tone-mapped colour as night shows it: (V + N) C_b, and the day's again where it is bright.
// xyz: of the mapped picture, its white 1; noise: of the same unit; dark, bright: Y below which all is night, above
// which all is day.
FN vec3 thompson_night(vec3 xyz, Real noise, Real dark, Real bright) {
  Real night = clamp((bright - xyz.y) / max(bright - dark, Real(1.0e-30)), Real(0.0), Real(1.0));
  return mix(xyz, max(cheap_scotopic_luminance(xyz) + noise, Real(0.0)) * night_hue, night);
}
