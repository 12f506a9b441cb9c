// Phase functions: the share of scattered light that goes into a unit of solid angle, per steradian. Each integrates to
// 1 over the sphere.
//
// cos_angle: cosine of the angle between the light's old and new direction, 1 forward, -1 backward.
// g: asymmetry, -0.99 to 0.99, positive forward.

CONSTANT Real sphere_sr = Real(12.566370614359172);

// Molecules: Chandrasekhar 1960 (Radiative Transfer, sec. 18). depolarization: of natural light scattered at a right
// angle, 0 (isotropic molecules) to 6/7; 0.0279 for air in the visible.
FN Real rayleigh_phase(Real cos_angle, Real depolarization) {
  Real gamma = depolarization / (Real(2.0) - depolarization);
  Real shape = Real(1.0) + Real(3.0) * gamma + (Real(1.0) - gamma) * cos_angle * cos_angle;
  return Real(0.75) * shape / ((Real(1.0) + Real(2.0) * gamma) * sphere_sr);
}

// 1 + g^2 - 2 g cos as a sum of what is positive: exact in single precision also in the peak.
FN Real phase_distance2(Real cos_angle, Real g) {
  Real forward = abs(g);
  Real towards = g < Real(0.0) ? -cos_angle : cos_angle;
  return (Real(1.0) - forward) * (Real(1.0) - forward) + Real(2.0) * forward * (Real(1.0) - towards);
}

// Henyey and Greenstein 1941 (ApJ 93, 70). The mean cosine is g.
FN Real henyey_greenstein_phase(Real cos_angle, Real g) {
  Real d2 = phase_distance2(cos_angle, g);
  return (Real(1.0) - g * g) / (sphere_sr * d2 * sqrt(d2));
}

// Cornette and Shanks 1992 (Appl. Opt. 31, 3152, eq. 8): Rayleigh's for g = 0. The mean cosine is
// 3 g (4 + g^2) / (5 (2 + g^2)).
FN Real cornette_shanks_phase(Real cos_angle, Real g) {
  Real polar = Real(1.5) * (Real(1.0) + cos_angle * cos_angle) / (Real(2.0) + g * g);
  return polar * henyey_greenstein_phase(cos_angle, g);
}

// Schlick's k for an asymmetry: 1.55 g - 0.55 g^3 up to |g| = 0.9, where k is 0.994. Beyond, k would reach 1 at 0.938
// and the phase function a pole; it stays at its value there.
FN Real schlick_asymmetry(Real g) {
  Real bounded = clamp(g, Real(-0.9), Real(0.9));
  return bounded * (Real(1.55) - Real(0.55) * bounded * bounded);
}

// Blasi, Le Saec and Schlick 1993 (Computer Graphics Forum 12, 201): near Henyey and Greenstein's without a power of
// 3/2. With the sign that scatters forward for g > 0. The mean cosine is not g but
// 1/k - (1 - k^2) / (2 k^2) ln((1 + k) / (1 - k)).
FN Real schlick_phase(Real cos_angle, Real g) {
  Real k = schlick_asymmetry(g);
  Real d = Real(1.0) - abs(k) + abs(k) * (Real(1.0) - (k < Real(0.0) ? -cos_angle : cos_angle));
  return (Real(1.0) - k * k) / (sphere_sr * d * d);
}
