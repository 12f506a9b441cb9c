// What light a point must send for the eye to see it.

// Of the factor by which an observer needs more light than Blackwell's trained ones, who had to be right half the time:
// 1.4 to 2.4 for real ones under the sky, found from what they saw (Crumey 2014, section 3.1). 1.7 is seeing a star
// without doubt in nine trials of ten (1.62, Blackwell 1946) with a little to spare.
CONSTANT Real default_field_factor = Real(1.7);

// Below this the background is as good as black, cd/m2 (Crumey 2014, section 2.3).
CONSTANT Real dark_background_cd_m2 = Real(1.0e-5);

// The least illuminance at the eye, in lux, by which a point of light is seen over a background that the eye is adapted
// to: Crumey 2014 (MNRAS 442, 2600) from the thresholds of Blackwell 1946 between 3e-5 and 3e3 cd/m2, his equation 34
// with the constants of 28 and, where rods see and it is nearer the measurements, 53. Constant below 1e-5 cd/m2. It
// never falls: between 0.009 and 0.065 cd/m2, where rods give way to cones and the equations dip by some hundredths of
// a magnitude, it is constant. Beyond the measurements it goes on towards Weber's law, a constant contrast; Venus and
// Sirius by day are the test of that (tests/accuracy/star_visibility_test.cpp).
// background_cd_m2: any; as seen_light (mesopic.glsl) weighs it: photopic, but for coloured light in the dark.
// field_factor: > 0; the threshold is in proportion to it.
FN Real threshold_illuminance_lux(Real background_cd_m2, Real field_factor) {
  const Real top_of_rods = Real(0.38322077); // where equation 34 has its maximum, and its root there
  const Real at_top = Real(1.2023035e-4);
  Real x = sqrt(sqrt(max(background_cd_m2, dark_background_cd_m2)));
  Real root =
      x * (sqrt(Real(5.949e-8) + x * (Real(-2.389e-7) + x * Real(2.459e-7))) + Real(4.120e-4) - x * Real(4.225e-4));
  Real rods = x < top_of_rods ? min(x * (Real(6.505e-4) - x * Real(8.461e-4)), at_top) : at_top;
  root = max(root, rods);
  return field_factor * root * root;
}
