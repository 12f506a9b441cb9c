// Point-spread functions of stars in the frame.
//
// The default one is a Gaussian sampled at pixel centres, the only profile that is both round and separable. The
// weights are divided by their own sum, axis by axis, so that they add up to 1 for every sub-pixel position.

// Relative weight of a pixel at the offset from the star, both axes scaled by psf_scale(sigma).
FN Real psf_profile(vec2 scaled_offset) { return exp2(-dot(scaled_offset, scaled_offset)); }

// Turns an offset in pixels into the argument of psf_profile: 1 / (sigma sqrt(2 ln 2)).
FN Real psf_scale(Real sigma) { return Real(0.849321800288) / sigma; }

// Sum of the profile along one axis over the pixels [low, high), which are whole numbers, for a star at `centre`.
FN Real psf_axis_sum(Real centre, Real low, Real high, Real sigma) {
  Real scale = psf_scale(sigma);
  Real sum = Real(0.0);
  for (Real pixel = low; pixel < high; pixel += Real(1.0)) {
    Real offset = (pixel + Real(0.5) - centre) * scale;
    sum += exp2(-offset * offset);
  }
  return sum;
}

// Illuminance above the atmosphere of an A0 star (B-V = 0) of V = 0, lux (Allen, Astrophysical Quantities; authors differ
// from 2.52e-6 to 2.65e-6).
CONSTANT Real zero_magnitude_lux = Real(2.54e-6);

FN Real magnitude_of(Real illuminance_lux) {
  return Real(-2.5 / 2.302585092994046) * log(max(illuminance_lux, Real(1.0e-30)) / zero_magnitude_lux);
}

// Standard deviation of the spread, pixels: the brightest pixel then changes by no more than a factor of 1.5 while a star
// moves across the grid. All stars have it; bright ones look larger once they saturate a display or a film.
CONSTANT Real psf_sigma = Real(0.8);

// Where the spread is cut, in standard deviations: at the same luminance for all stars, that of the peak of one of
// V = 10, so that bright ones show no edge; between 3.3 (which leaves out 0.1 % an axis) and 5.
FN Real psf_cut(Real illuminance_lux) {
  return clamp(sqrt(Real(1.842) * max(Real(10.0) - magnitude_of(illuminance_lux), Real(0.0))), Real(3.3), Real(5.0));
}

// Mueller et al. 2012, sec. 4.2 (cheap tier). T(l) on the unit disc; its volume is 0.3 pi, not the 1.167 printed there,
// which belongs to the curve turned about the other axis.
CONSTANT Real mueller_volume = Real(0.942477796076938);
// Radius of its billboard, pixels: the least that does not flicker, as recommended there.
CONSTANT Real mueller_radius = Real(2.0);

FN Real mueller_intensity_psf(Real l) {
  Real u = clamp(l, Real(0.0), Real(1.0));
  return (Real(2.0) * u - Real(3.0)) * u * u + Real(1.0);
}

// The glare profile, one minus the 64th root of the distance.
FN Real mueller_glare_psf(Real l) { return Real(1.0) - pow(clamp(l, Real(0.0), Real(1.0)), Real(0.015625)); }

// Relative brightness over the control magnitude, Delta m.
FN Real mueller_brightness(Real magnitude, Real control_magnitude) {
  return pow(Real(2.512), control_magnitude - magnitude);
}

// Intensity of the glare billboard, 0 for stars fainter than the control magnitude.
FN Real mueller_glare_intensity(Real magnitude, Real control_magnitude) {
  Real shifted = magnitude + (mueller_volume - Real(1.0));
  return max(mueller_brightness(shifted, control_magnitude) - Real(1.0), Real(0.0));
}

// Visibility of stars against the day, from the sine of the Sun's altitude (Mueller et al. 2012, sec. 5).
FN Real mueller_day_fade(Real sun_sin_altitude) {
  return inversesqrt(Real(1.0) + pow(max(sun_sin_altitude + Real(1.14), Real(0.0)), Real(32.0)));
}
