// From luminance in the scene to luminance on the display.

// Luminances that are metered and mapped, by logarithms to base 2 of cd/m2: 6e-8 to 1.7e10. What is darker counts as black.
CONSTANT int tone_lowest_octave = -24;
CONSTANT int tone_highest_octave = 34;
CONSTANT int tone_bins_per_octave = 4;   // of the histogram
CONSTANT int tone_nodes_per_octave = 8;  // of the curve
CONSTANT int tone_bins = 232;            // 58 octaves
CONSTANT int tone_nodes = 465;

// Where a luminance lies among the histogram's bins: bin i has its middle at i. -1 or less for black.
FN Real tone_bin(Real luminance_cd_m2) {
  Real octave = log2(max(luminance_cd_m2, Real(1.0e-30))) - Real(tone_lowest_octave);
  return min(Real(tone_bins_per_octave) * octave - Real(0.5), Real(tone_bins - 1));
}

// The luminance in the middle of a bin, cd/m2.
FN Real tone_bin_luminance(Real bin) {
  return exp2(Real(tone_lowest_octave) + (bin + Real(0.5)) / Real(tone_bins_per_octave));
}

// What a curve makes of a luminance: x: luminance in cd/m2 that the display adds to its floor; y: the same of a point, over
// the light that the eye gets of it; z: one over a point's threshold in the scene, 1/lux. A texel holds x, its rise to the
// next texel, y and z.
FN vec3 tone_curve(Real luminance_cd_m2, sampler1D curve) {
  Real octave = log2(max(luminance_cd_m2, Real(1.0e-30))) - Real(tone_lowest_octave);
  Real at = clamp(Real(tone_nodes_per_octave) * octave, Real(0.0), Real(tone_nodes - 1));
  Real node = floor(at);
  vec4 texel = texelFetch(curve, int(node), 0);
  return vec3(texel.x + (at - node) * texel.y, texel.z, texel.w);
}

// Share of the cones in what is seen at one place, which adapts to itself: the first step of the iteration of CIE 191:2010.
// Within 0.08 of its solution (mesopic_cone_share) for light of S/P from 0.5 to 2.5.
FN Real local_cone_share(Real photopic_cd_m2, Real scotopic_cd_m2) {
  Real seen = mesopic_luminance(photopic_cd_m2, scotopic_cd_m2, Real(0.5));
  return cone_share_of_octave(log2(max(seen, Real(1.0e-30))));
}

// By how much a point that is plainly seen stands out more on a display than the law below asks for: a choice of taste, by
// which stars of the magnitudes 1, 3 and 5 look on a monitor of 200 cd/m2 as they are remembered.
CONSTANT Real point_prominence = Real(5.0);

// Factor by which a point is made brighter than its threshold asks for, by its illuminance in one pixel over the threshold.
// The brightness of a point goes as the root of its light, that of a disc, such as a display makes of it, as the cube root
// (Stevens 1975, Psychophysics, table 1): to be as bright over its threshold, the disc's light goes as the point's to the
// power of 1.5. A point at its threshold, which has a fourth of its light in its brightest pixel, keeps it within 15 %
// there and 6 % in all.
FN Real point_boost(Real over_threshold) {
  Real x = Real(4.0) * over_threshold;
  return Real(1.0) + point_prominence * x * x * sqrt(x) / (Real(34.0) + x * x);
}

// A display luminance with a point's light on top: as much more where there is room, ever less towards the ceiling.
FN Real under_ceiling(Real luminance, Real more, Real ceiling) {
  Real room = max(ceiling - luminance, Real(1.0e-6) * ceiling);
  return luminance + room * (Real(1.0) - exp(-more / room));
}

// Share of its colour that light keeps where its luminance alone would be the display's white: a choice of taste.
CONSTANT Real kept_color = Real(0.5);
// What is brighter burns out to white: the luminance that bleaches half of the cones' pigment, 2e4 td (Rushton and Henry
// 1968, Vision Res. 8, 617) through a pupil of 4 mm2.
CONSTANT Real burning_out_cd_m2 = Real(5000.0);

// Factor from the light of a colour to what is shown of it, at first of the luminance `shown`: what the display has no room
// for as it is gives up luminance, so that it keeps colour. White stays, and of one colour more light never shows less.
// shown: share of the display's range, 0 to 1; luminance, > 0, and highest, the largest linear component, in one unit;
// seen_cd_m2: luminance in the scene; kept: share of the colour, 0 to 1
FN Real scale_with_color(Real shown, Real luminance, Real highest, Real seen_cd_m2, Real kept) {
  Real over = seen_cd_m2 * (Real(1.0) / burning_out_cd_m2);
  Real rest = Real(1.0) + over * over;
  Real excess = max(shown * highest - luminance, Real(0.0));
  return shown * rest / (luminance * rest + kept * excess);
}

// Reinhard et al. 2002, eq. 4, extended: luminance over the middle grey's, times the key; `white` becomes 1.
FN Real reinhard_extended(Real scaled, Real white) {
  return scaled * (Real(1.0) + scaled / (white * white)) / (Real(1.0) + scaled);
}

// The key that suits a scene's adaptation luminance: Krawczyk, Myszkowski and Seidel 2005, eq. 11. 0.03 in the dark, 0.18 at
// 1 cd/m2 (where the formula has 0.16), 0.7 by day.
FN Real automatic_key(Real adaptation_cd_m2) {
  Real decades = Real(0.30102999566398120) * log2(adaptation_cd_m2 + Real(1.0));
  return Real(1.03) - Real(2.0) / (Real(2.0) + decades);
}

// Hable's filmic curve (Atmosphere Plus, 1.2.2).
CONSTANT Real hable_white = Real(11.2);
CONSTANT Real hable_bias = Real(2.0);
FN Real hable_part(Real x) {
  const Real a = Real(0.15);
  const Real b = Real(0.50);
  const Real c = Real(0.10);
  const Real d = Real(0.20);
  const Real e = Real(0.02);
  const Real f = Real(0.30);
  return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
}
// 1 at half its white; above it goes on to 1.2.
FN Real hable_curve(Real exposed) { return hable_part(exposed * hable_bias) / hable_part(hable_white); }

// The luminance that saturates a camera of ISO 100 at an exposure value: ISO 12232 (saturation-based speed, 78/S) for a lens
// that passes 65 % (q in that standard).
FN Real photographic_white_cd_m2(Real exposure_value) { return Real(1.2) * exp2(exposure_value); }
// The exposure value at ISO 100 that a reflected-light meter tells (ISO 2720, K = 12.5).
FN Real metered_exposure_value(Real luminance_cd_m2) {
  return log2(max(luminance_cd_m2, Real(1.0e-30)) * (Real(100.0) / Real(12.5)));
}
