// Light scattered in the eye, and how it is shared out over the levels of a pyramid.
//
// The spread of a point of light is the CIE's (Vos and van den Berg 1999, CIE 135/1-6, eq. 8: optics, cornea, lens,
// iris and wall, from 0 to 100 degrees). Its terms but the last two have the form A / (1 + (theta/a)^2)^beta, and each is a
// sum of Gaussians of all widths: (q)^-beta = 1/Gamma(beta) int t^(beta-1) exp(-t q) dt. One Gaussian an octave of
// width, a trapezoidal rule in log t with the step log 4, stays within 2 % of the integral (its error is
// 2 |Gamma(beta + 2 pi i / log 4)| / Gamma(beta), worst for beta = 3/2).
//
// Split: a smooth far part, which is a function of the true angle, and Gaussians narrower than `softness` b, which are
// drawn in the picture. The Gaussian exp(-t theta^2) is far by (1 + t b^2) exp(-t b^2); that sums to
// q^-beta (1 + beta b^2/q), q = theta^2 + a^2 + b^2.

// Angles are in degrees, values per steradian; energies are taken over the plane.
struct EyeScatter {
  Real narrow;    // beta 3/2, a 0.0046: optics
  Real wide;      // beta 3/2, a 0.045: optics
  Real pigmented; // beta 3/2, a 0.1: iris
  Real skirt;     // beta 1, a 0.1: cornea and lens
  Real iris;      // beta 1/2, a 0.1
  Real parabola;  // of theta squared
  Real wall;      // constant
};

CONSTANT Real eye_narrow_deg = Real(0.0046);
CONSTANT Real eye_wide_deg = Real(0.045);
CONSTANT Real eye_skirt_deg = Real(0.1);
CONSTANT Real sr_per_square_degree = Real(3.0461741978670857e-4);

// age_years: 0 to 100; pigmentation: of the iris, 0 (very dark), 0.5 (brown), 1 (blue-green), 1.2 (light blue).
FN EyeScatter eye_scatter(Real age_years, Real pigmentation) {
  Real ratio = age_years / Real(70.0);
  Real aged = ratio * ratio * ratio * ratio;
  Real optics = Real(1.0) - Real(0.08) * aged;
  Real media = Real(1.0) + Real(1.6) * aged;
  EyeScatter eye;
  eye.narrow = optics * Real(9.2e6);
  eye.wide = optics * Real(1.5e5);
  eye.pigmented = media * pigmentation * Real(1300.0);
  eye.skirt = media * Real(400.0);
  eye.iris = media * pigmentation * Real(0.8);
  eye.parabola = media * Real(3.0e-8);
  eye.wall = pigmentation * Real(2.5e-3);
  return eye;
}

FN EyeScatter eye_scatter_times(EyeScatter eye, Real factor) {
  EyeScatter scaled;
  scaled.narrow = factor * eye.narrow;
  scaled.wide = factor * eye.wide;
  scaled.pigmented = factor * eye.pigmented;
  scaled.skirt = factor * eye.skirt;
  scaled.iris = factor * eye.iris;
  scaled.parabola = factor * eye.parabola;
  scaled.wall = factor * eye.wall;
  return scaled;
}

// Luminance at an angle from a source of 1 lux, 1/sr.
FN Real eye_spread(Real squared_deg, EyeScatter eye) {
  Real narrow = Real(1.0) / (Real(1.0) + squared_deg / (eye_narrow_deg * eye_narrow_deg));
  Real wide = Real(1.0) / (Real(1.0) + squared_deg / (eye_wide_deg * eye_wide_deg));
  Real skirt = Real(1.0) / (Real(1.0) + squared_deg / (eye_skirt_deg * eye_skirt_deg));
  return eye.narrow * narrow * sqrt(narrow) + eye.wide * wide * sqrt(wide) +
         sqrt(skirt) * (eye.pigmented * skirt + eye.iris) + eye.skirt * skirt + eye.parabola * squared_deg + eye.wall;
}

// Its far part.
FN Real eye_spread_far(Real squared_deg, Real softness_deg, EyeScatter eye) {
  Real b = softness_deg * softness_deg;
  Real base = squared_deg + b;
  Real narrow = Real(1.0) / (base + eye_narrow_deg * eye_narrow_deg);
  Real wide = Real(1.0) / (base + eye_wide_deg * eye_wide_deg);
  Real skirt = Real(1.0) / (base + eye_skirt_deg * eye_skirt_deg);
  Real narrow_cube = eye_narrow_deg * eye_narrow_deg * eye_narrow_deg;
  Real wide_cube = eye_wide_deg * eye_wide_deg * eye_wide_deg;
  return eye.narrow * narrow_cube * narrow * sqrt(narrow) * (Real(1.0) + Real(1.5) * b * narrow) +
         eye.wide * wide_cube * wide * sqrt(wide) * (Real(1.0) + Real(1.5) * b * wide) +
         eye_skirt_deg * sqrt(skirt) *
             (eye.pigmented * eye_skirt_deg * eye_skirt_deg * skirt * (Real(1.0) + Real(1.5) * b * skirt) +
              eye.iris * (Real(1.0) + Real(0.5) * b * skirt)) +
         eye.skirt * eye_skirt_deg * eye_skirt_deg * skirt * (Real(1.0) + b * skirt) + eye.parabola * squared_deg +
         eye.wall;
}

// The light that is not in the far part: of a term with beta = 3/2 and of all.
FN Real eye_near_light_of(Real a, Real b) {
  Real far = sqrt(a * a + b * b);
  return Real(2.0) * pi * a * a * (Real(1.0) - a / far * (Real(1.0) + Real(0.5) * b * b / (far * far)));
}

FN Real eye_near_light(Real softness_deg, EyeScatter eye) {
  Real b = softness_deg * softness_deg;
  Real a = eye_skirt_deg;
  Real far = a * a + b;
  Real skirt = pi * a * a * (log(far / (a * a)) - b / far);
  Real iris = Real(2.0) * pi * a * (sqrt(far) - a - Real(0.5) * b / sqrt(far));
  return sr_per_square_degree *
         (eye.narrow * eye_near_light_of(eye_narrow_deg, softness_deg) +
          eye.wide * eye_near_light_of(eye_wide_deg, softness_deg) + eye.pigmented * eye_near_light_of(a, softness_deg) +
          eye.skirt * skirt + eye.iris * iris);
}

// The light in the Gaussian of one octave's middle, of standard deviation sigma.
FN Real eye_octave_light(Real sigma_deg, Real softness_deg, EyeScatter eye) {
  Real t = Real(0.5) / (sigma_deg * sigma_deg);
  Real y = t * softness_deg * softness_deg;
  Real near = Real(1.0) - (Real(1.0) + y) * exp(-y);
  Real narrow = t * eye_narrow_deg * eye_narrow_deg;
  Real wide = t * eye_wide_deg * eye_wide_deg;
  Real skirt = t * eye_skirt_deg * eye_skirt_deg;
  Real gamma_half = Real(1.772453850905516);
  Real gamma_three_halves = Real(0.886226925452758);
  Real octave = Real(1.3862943611198906); // log 4
  Real optics = eye.narrow * eye_narrow_deg * eye_narrow_deg * sqrt(narrow) * exp(-narrow) +
                eye.wide * eye_wide_deg * eye_wide_deg * sqrt(wide) * exp(-wide);
  Real media = eye_skirt_deg * eye_skirt_deg * exp(-skirt) *
               (eye.pigmented * sqrt(skirt) / gamma_three_halves + eye.skirt + eye.iris / (gamma_half * sqrt(skirt)));
  return octave * pi * sr_per_square_degree * near * (optics / gamma_three_halves + media);
}

// The square of the angle between unit vectors, from the square of their distance; within 0.4 % up to 100 degrees.
FN Real squared_angle(vec3 a, vec3 b) {
  vec3 between = a - b;
  Real c = dot(between, between);
  return c * (Real(1.0) +
              c * (Real(1.0 / 12.0) +
                   c * (Real(1.0 / 90.0) + c * (Real(1.0 / 560.0) + c * (Real(1.0 / 3150.0) + c * Real(1.0 / 16632.0))))));
}

// Degrees that a pixel is wide, the square root of its solid angle. In the map of longitude and latitude it is its height,
// and past 110 degrees of a fisheye it does not shrink with the circles of latitude.
FN Real eye_degrees_per_pixel(vec2 pixel, PixelFrame frame) {
  Real degree = Real(180.0) / pi;
  if (frame.kind == projection_equirectangular) {
    return Real(180.0) / frame.size.y;
  }
  if (frame.kind == projection_fisheye) {
    Real angle = length(pixel - Real(0.5) * frame.size) / frame.focal;
    Real shrink = angle > Real(1.0e-3) ? sin(min(angle, Real(2.0))) / angle : Real(1.0);
    return degree / frame.focal * sqrt(max(shrink, Real(0.4)));
  }
  return degree * inversesqrt(pixels_per_steradian(pixel, frame));
}

// Standard deviation of what a level of the pyramid draws, in its texels: spread by a quadratic B-spline (variance 1/4),
// binomial weights (1/2), and linear interpolation level by level (3/16 each, a quarter of it from level to level).
CONSTANT Real eye_level_sigma = Real(1.0);

// Quadratic B-spline: its piecewise parabolas sum to 1 over whole steps and keep the centre of what they spread.
FN Real b_spline(Real x) {
  Real d = abs(x);
  Real edge = max(Real(1.5) - d, Real(0.0));
  return d < Real(0.5) ? Real(0.75) - d * d : Real(0.5) * edge * edge;
}

// How extended light is pooled: standard deviation in degrees of a Gaussian through which the finest grating that is seen
// keeps a tenth of its contrast, exp(-2 pi^2 sigma^2 f^2) = 0.1, beyond what the same eye loses by day.
// finest: cycles per degree that are seen at the luminance of the place, finest_by_day: in the brightest light.
FN Real eye_pooling_variance_deg2(Real finest, Real finest_by_day) {
  return Real(0.11665) * max(Real(1.0) / (finest * finest) - Real(1.0) / (finest_by_day * finest_by_day), Real(0.0));
}
