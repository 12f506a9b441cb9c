// What light a point must send for the eye to see it.

// Of the factor by which an observer needs more light than Blackwell's trained ones, who had to be right half the time:
// 1.4 to 2.4 for real ones under the sky, found from what they saw (Crumey 2014, section 3.1). 1.7 is seeing a star without
// doubt in nine trials of ten (1.62, Blackwell 1946) with a little to spare.
CONSTANT Real default_field_factor = Real(1.7);

// Below this the background is as good as black, cd/m2 (Crumey 2014, section 2.3).
CONSTANT Real dark_background_cd_m2 = Real(1.0e-5);

// Root of the threshold in lux^(1/2) of a point over a background of fourth root x in (cd/m2)^(1/4): Crumey 2014,
// equations 28 and 34.
FN Real root_of_threshold(Real x) {
  return x * (sqrt(Real(5.949e-8) + x * (Real(-2.389e-7) + x * Real(2.459e-7))) + Real(4.120e-4) - Real(4.225e-4) * x);
}

// The least illuminance at the eye, in lux, by which a point of light is seen over a background that the eye is adapted
// to: Crumey 2014 (MNRAS 442, 2600) from the thresholds of Blackwell 1946, 3e-5 to 3e3 cd/m2. Beyond, to the Sun's disc,
// it goes on as the square root of the background's first power (Weber's law); at 1e4 cd/m2 Venus and Sirius by day hold
// it. Below 1e-5 cd/m2 it is constant. It never falls: the fit's dip of 0.029 mag from 0.022 to 0.065 cd/m2, where rods
// give way to cones, is filled.
// background_cd_m2: 0 or more, as `seen_light` weighs it (vision.glsl): photopic, but for coloured light in the dark.
// field_factor: > 0; the threshold grows with it.
FN Real threshold_illuminance_lux(Real background_cd_m2, Real field_factor) {
  const Real top_of_rods = Real(0.38322077); // where the fit's maximum lies, and its value
  const Real at_top = Real(1.2023035e-4);
  Real x = sqrt(sqrt(max(background_cd_m2, dark_background_cd_m2)));
  Real root = root_of_threshold(x);
  root = x < top_of_rods ? root : max(root, at_top);
  return field_factor * root * root;
}
