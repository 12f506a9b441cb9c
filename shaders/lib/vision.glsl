// What the eye can tell apart, and how fast it adapts.

// Threshold of a large patch over a background, cd/m2, by cones alone and by rods alone: Ferwerda et al. 1996, from
// background luminances, photopic and scotopic, in cd/m2. Constant in the dark, in proportion to the background in the
// end. The last pieces are joined where they meet, at 10^1.917 and 10^-1.2, not as printed at 10^1.9 and 10^-1.44, where
// the threshold would drop by 1 and 3 %.
FN Real cone_threshold_cd_m2(Real photopic_cd_m2) {
  Real l = log10_of(max(photopic_cd_m2, Real(1.0e-30)));
  Real t = l <= Real(-2.6)
               ? Real(-0.72)
               : (l >= Real(1.917) ? l - Real(1.255)
                                 : pow(max(Real(0.249) * l + Real(0.65), Real(0.0)), Real(2.7)) - Real(0.72));
  return pow(Real(10.0), t);
}
FN Real rod_threshold_cd_m2(Real scotopic_cd_m2) {
  Real l = log10_of(max(scotopic_cd_m2, Real(1.0e-30)));
  Real t = l <= Real(-3.94)
               ? Real(-2.86)
               : (l >= Real(-1.2) ? l - Real(0.395)
                                  : pow(max(Real(0.405) * l + Real(1.6), Real(0.0)), Real(2.18)) - Real(2.86));
  return pow(Real(10.0), t);
}

// The least difference that either tells: Larson, Rushmeier and Piatko 1997, who join the two at 0.96 cd/m2, where they
// cross.
FN Real just_noticeable_cd_m2(Real background_cd_m2) {
  return min(cone_threshold_cd_m2(background_cd_m2), rod_threshold_cd_m2(background_cd_m2));
}

// Finest grating that is seen, cycles per degree: Shlaer's measurements (1937) as Larson, Rushmeier and Piatko 1997 fit
// them. 1.2 in the dark, 51 by day.
FN Real acuity_cycles_per_degree(Real background_cd_m2) {
  Real l = log10_of(max(background_cd_m2, Real(1.0e-5))); // the background is as good as black there
  return Real(17.25) * atan(Real(1.4) * l + Real(0.35)) + Real(25.72);
}

// Root mean square of the grain that is seen in the dark, cd/m2 scotopic: light at threshold is what stands out of it,
// so it is as strong as the rods' threshold, and goes as the rods' share of seeing goes. Gone by day, where cones see
// less than their threshold of it.
FN Real visual_noise_cd_m2(Real scotopic_cd_m2, Real cone_share) {
  return (Real(1.0) - cone_share) * min(rod_threshold_cd_m2(scotopic_cd_m2), scotopic_cd_m2);
}

// Time constants of adaptation, s. To light it is nervous: 0.1 s of cones and 0.4 s of rods (Durand and Dorsey 2000,
// who cite Adelson 1982; Krawczyk et al. 2005). To darkness pigment has to grow again: 110 s and 400 s (Hood and
// Finkelstein 1986, in Pattanaik et al. 2000).
CONSTANT Real cone_light_adaptation_s = Real(0.1);
CONSTANT Real rod_light_adaptation_s = Real(0.4);
CONSTANT Real cone_dark_adaptation_s = Real(110.0);
CONSTANT Real rod_dark_adaptation_s = Real(400.0);

// Adaptation luminance, cd/m2, after dt_s seconds of looking at another: its logarithm nears the new one exponentially,
// as the logarithm of the threshold falls with the bleached pigment (Dowling and Rushton's law; Alpern, Rushton and
// Torii 1970). Steps of any length add up exactly.
// last, next: adapted to before, and seen now, cd/m2 (0 counts as 1e-5); dt_s: 0 or more.
FN Real adapted_luminance(Real next_cd_m2, Real last_cd_m2, Real dt_s, Real to_light_s, Real to_dark_s) {
  Real next = log(max(next_cd_m2, Real(1.0e-5)));
  Real last = log(max(last_cd_m2, Real(1.0e-5)));
  return exp(next + (last - next) * exp(-dt_s / (next > last ? to_light_s : to_dark_s)));
}

// The same of cones (x, photopic) and rods (y, scotopic).
FN vec2 adapted(vec2 next_cd_m2, vec2 last_cd_m2, Real dt_s) {
  return vec2(adapted_luminance(next_cd_m2.x, last_cd_m2.x, dt_s, cone_light_adaptation_s, cone_dark_adaptation_s),
              adapted_luminance(next_cd_m2.y, last_cd_m2.y, dt_s, rod_light_adaptation_s, rod_dark_adaptation_s));
}
