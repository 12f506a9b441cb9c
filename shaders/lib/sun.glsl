// The Sun's disc and corona in cd/m2 above the air. Places are those of an orthographic picture from infinitely far
// away, in units of the Sun's radius, seen along the line to the Sun's centre: at distance r from the centre of the
// disc the cosine of the angle to the surface's normal is sqrt(1 - r^2), exactly, from any distance.

CONSTANT int sun_terms = 6;
CONSTANT int sun_streamers = 6;

// C++ fills it from vesper::SunDisc; the order is that of a std140 block.
struct SunShading {
  vec3 direction; // unit vectors: to the centre, without refraction
  Real sin_radius;
  vec3 upward; // to the Sun's north pole, square to the direction
  Real lowest_power;
  vec3 aside; // square to both
  Real power_step;
  vec3 moon_direction;
  Real moon_chord;               // distance on the unit sphere between the Moon's centre and its limb
  vec4 limb[sun_terms];          // X, Y, Z, S of the disc: sum of limb[k] mu^(lowest_power + k power_step)
  vec4 k_corona;                 // luminance, over the numbers of the laws below
  vec4 f_corona;
  vec4 streamers[sun_streamers]; // x, y: direction times sharpness; z: height at its foot; w: mean around the Sun
};

// Luminance of the disc at 0 <= r <= 1 from its centre.
FN vec4 sun_disc_luminance(Real r, SunShading sun) {
  Real mu = sqrt(max((Real(1.0) - r) * (Real(1.0) + r), Real(0.0)));
  Real x = pow(mu, sun.power_step);
  vec4 sum = sun.limb[sun_terms - 1];
  for (int k = sun_terms - 2; k >= 0; --k) {
    sum = sun.limb[k] + x * sum;
  }
  // 0 to the power of 0 is nothing that a GPU must know.
  return sun.lowest_power > Real(0.0) ? pow(mu, sun.lowest_power) * sum : sum;
}

// Baumbach 1937 (Astronomische Nachrichten 263, 121), in 1e-6 of the brightness at the disc's centre (some who quote it
// take the disc's mean, 0.8 of that): light that free electrons (K) and dust (F) scatter, at r >= 1.
CONSTANT Real k_corona_inner = Real(2.565); // r^-17
CONSTANT Real k_corona_outer = Real(1.425); // r^-7
CONSTANT Real f_corona_all = Real(0.0532);  // r^-2.5
// Where the corona ends here: 16 degrees, beyond which the dust is called zodiacal light.
CONSTANT Real corona_edge = Real(60.0);

FN Real k_corona(Real r) {
  Real x = Real(1.0) / r;
  Real x2 = x * x;
  Real x4 = x2 * x2;
  Real x8 = x4 * x4;
  return k_corona_outer * x4 * x2 * x + k_corona_inner * x8 * x8 * x;
}

FN Real f_corona(Real r) {
  Real x = Real(1.0) / r;
  return f_corona_all * x * x * sqrt(x);
}

// Streamers over the corona without them, >= 0: a mean of 1 on every circle about the Sun, without contrast at its limb
// and with all of it from 2 radii on.
FN Real streamer_pattern(vec2 place, Real r, SunShading sun) {
  vec2 toward = place / r;
  Real sum = Real(0.0);
  for (int k = 0; k < sun_streamers; ++k) {
    vec4 streamer = sun.streamers[k];
    sum += streamer.z * exp(streamer.x * toward.x + streamer.y * toward.y) - streamer.w;
  }
  return max(Real(1.0) + smoothstep(Real(1.0), Real(2.0), r) * sum, Real(0.0));
}

// Luminance of the corona; black before the disc and beyond corona_edge.
FN vec4 corona_luminance(vec2 place, SunShading sun) {
  Real r = length(place);
  if (r < Real(1.0) || r > corona_edge) {
    return vec4(Real(0.0));
  }
  return k_corona(r) * streamer_pattern(place, r, sun) * sun.k_corona + f_corona(r) * sun.f_corona;
}
