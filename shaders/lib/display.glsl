// From the light that should reach the viewer to the code values of the display, and back.

CONSTANT int primaries_srgb = 0;       // IEC 61966-2-1, the same as ITU-R BT.709
CONSTANT int primaries_display_p3 = 1; // SMPTE EG 432-1
CONSTANT int primaries_rec2020 = 2;    // ITU-R BT.2020

CONSTANT int transfer_srgb = 0;  // IEC 61966-2-1
CONSTANT int transfer_gamma = 1; // a power
CONSTANT int transfer_pq = 2;    // SMPTE ST 2084: codes of absolute luminance

// CIE 1931 x, y of a display's red, green, blue and white.
struct Chromaticities {
  vec2 red;
  vec2 green;
  vec2 blue;
  vec2 white;
};

// As the standards above publish them; all have the white of D65.
FN Chromaticities chromaticities_of(int primaries) {
  Chromaticities c;
  c.red = vec2(Real(0.640), Real(0.330));
  c.green = vec2(Real(0.300), Real(0.600));
  c.blue = vec2(Real(0.150), Real(0.060));
  c.white = vec2(Real(0.3127), Real(0.3290));
  if (primaries == primaries_display_p3) {
    c.red = vec2(Real(0.680), Real(0.320));
    c.green = vec2(Real(0.265), Real(0.690));
  } else if (primaries == primaries_rec2020) {
    c.red = vec2(Real(0.708), Real(0.292));
    c.green = vec2(Real(0.170), Real(0.797));
    c.blue = vec2(Real(0.131), Real(0.046));
  }
  return c;
}

// X, Y, Z of unit luminance.
FN vec3 xyz_of_chromaticity(vec2 xy) { return vec3(xy.x / xy.y, Real(1.0), (Real(1.0) - xy.x - xy.y) / xy.y); }

// From linear components to X, Y, Z; 1, 1, 1 is the white of unit luminance (SMPTE RP 177).
FN mat3 xyz_from_rgb(Chromaticities c) {
  vec3 red = xyz_of_chromaticity(c.red);
  vec3 green = xyz_of_chromaticity(c.green);
  vec3 blue = xyz_of_chromaticity(c.blue);
  vec3 luminance = inverse(mat3(red, green, blue)) * xyz_of_chromaticity(c.white);
  return mat3(red * luminance.x, green * luminance.y, blue * luminance.z);
}

// Linear 0 to 1 in, code value 0 to 1 out.
FN Real srgb_encode(Real linear) {
  Real v = clamp(linear, Real(0.0), Real(1.0));
  return v <= Real(0.0031308) ? Real(12.92) * v : Real(1.055) * pow(v, Real(1.0 / 2.4)) - Real(0.055);
}

// The same within 1.5e-6, a tenth of a step of 16 bits, without a power: a polynomial of the fourth root (minimax over its
// range, exact at 1).
// linear: 0 to 1
FN Real quick_srgb_encode(Real linear) {
  Real q = sqrt(sqrt(max(linear, Real(0.0))));
  Real square = q * q;
  Real low = (Real(-0.0595898443) + q * Real(0.1401665628)) + square * (Real(1.36302318) - q * Real(0.84538134));
  Real high = (Real(0.646562603) - q * Real(0.310809615)) + square * Real(0.0660284535);
  Real root = low + square * square * high;
  return linear <= Real(0.0031308) ? Real(12.92) * linear : root;
}

FN Real srgb_decode(Real code) {
  Real v = clamp(code, Real(0.0), Real(1.0));
  return v <= Real(0.04045) ? v / Real(12.92) : pow((v + Real(0.055)) / Real(1.055), Real(2.4));
}

CONSTANT Real pq_peak_cd_m2 = Real(10000.0);
CONSTANT Real pq_m1 = Real(2610.0 / 16384.0);
CONSTANT Real pq_m2 = Real(2523.0 / 32.0);
CONSTANT Real pq_c1 = Real(3424.0 / 4096.0);
CONSTANT Real pq_c2 = Real(2413.0 / 128.0);
CONSTANT Real pq_c3 = Real(2392.0 / 128.0);

// 0 to 10000 cd/m2 in, code value 0 to 1 out.
FN Real pq_encode(Real luminance_cd_m2) {
  Real y = pow(clamp(luminance_cd_m2 / pq_peak_cd_m2, Real(0.0), Real(1.0)), pq_m1);
  return pow((pq_c1 + pq_c2 * y) / (Real(1.0) + pq_c3 * y), pq_m2);
}

FN Real pq_decode(Real code) {
  Real p = pow(clamp(code, Real(0.0), Real(1.0)), Real(1.0) / pq_m2);
  return pq_peak_cd_m2 * pow(max(p - pq_c1, Real(0.0)) / (pq_c2 - pq_c3 * p), Real(1.0) / pq_m1);
}

// A display, and the light that falls on it. Its own light is black + range * signal, of each primary alike; to it come
// what it reflects of the room and, in a dome, of itself. vesper/plan/display.hpp makes one of what a person knows.
struct DisplayModel {
  mat3 rgb_from_xyz;     // its linear components
  int transfer;          // from signal to code value
  Real gamma;            // of transfer_gamma
  Real black_cd_m2;      // of code value 0 in the dark, > 0 or 0
  Real range_cd_m2;      // from black to white, > 0
  Real ambient_cd_m2;    // of the room's light that it reflects
  Real cross_reflection; // share of its mean light that reaches every place of it again, 0 to 1
  Real pixel_sr;         // solid angle of a pixel as the viewer sees it
};

// The least luminance that it can show while its mean is `mean_cd_m2`, as the viewer sees it. All parts of a sphere
// light each other alike (Jacquez and Kuppenheim 1955, J. Opt. Soc. Am. 45, 460), so a dome adds an even veil.
FN Real display_floor_cd_m2(DisplayModel display, Real mean_cd_m2) {
  return display.black_cd_m2 + display.ambient_cd_m2 +
         display.cross_reflection * max(mean_cd_m2 - display.ambient_cd_m2, Real(0.0));
}

// The largest luminance: that of its white.
FN Real display_ceiling_cd_m2(DisplayModel display, Real mean_cd_m2) {
  return display_floor_cd_m2(display, mean_cd_m2) + display.range_cd_m2;
}

// Linear components within 0 to 1, but for rounding at 1, of the same luminance and, towards grey, the same hue. Clipping
// would change both. grey: their luminance, 0 to 1; highest: the largest of them. What is within stays.
FN vec3 towards_grey(vec3 rgb, Real grey, Real highest) {
  const Real least = Real(1.0e-30);
  Real rest = max(Real(1.0) - grey, Real(0.0));
  vec3 chroma = rgb - vec3(grey);
  Real lowest = min(chroma.x, min(chroma.y, chroma.z));
  Real share = min(grey / max(-lowest, max(grey, least)), rest / max(highest - grey, max(rest, least)));
  return max(vec3(grey) + share * chroma, vec3(Real(0.0)));
}

// The same of any luminance.
FN vec3 fit_to_gamut(vec3 rgb, Real grey) {
  Real highest = max(rgb.x, max(rgb.y, rgb.z));
  return min(towards_grey(rgb, clamp(grey, Real(0.0), Real(1.0)), highest), vec3(Real(1.0)));
}

// Linear signal, 0 to 1, that has the display show X, Y, Z (cd/m2, all that leaves it), as nearly as it can.
// mean_cd_m2: mean luminance of the picture as shown; only a dome needs it.
FN vec3 display_signal(vec3 xyz, DisplayModel display, Real mean_cd_m2) {
  vec3 finite = clamp(xyz, vec3(Real(-1.0e20)), vec3(Real(1.0e20)));
  Real floor_cd_m2 = display_floor_cd_m2(display, mean_cd_m2);
  return fit_to_gamut((display.rgb_from_xyz * finite - vec3(floor_cd_m2)) / display.range_cd_m2,
                      (finite.y - floor_cd_m2) / display.range_cd_m2);
}

FN Real transfer_encode(Real signal, DisplayModel display) {
  if (display.transfer == transfer_pq) {
    return pq_encode(signal * display.range_cd_m2);
  }
  return display.transfer == transfer_gamma ? pow(signal, Real(1.0) / display.gamma) : srgb_encode(signal);
}

FN Real transfer_decode(Real code, DisplayModel display) {
  if (display.transfer == transfer_pq) {
    return min(pq_decode(code) / display.range_cd_m2, Real(1.0));
  }
  return display.transfer == transfer_gamma ? pow(clamp(code, Real(0.0), Real(1.0)), display.gamma) : srgb_decode(code);
}

// The same as code values, 0 to 1, before they are rounded to steps.
FN vec3 display_codes(vec3 xyz, DisplayModel display, Real mean_cd_m2) {
  vec3 signal = display_signal(xyz, display, mean_cd_m2);
  return vec3(transfer_encode(signal.x, display), transfer_encode(signal.y, display),
              transfer_encode(signal.z, display));
}

// X, Y, Z that leave the display for code values: the inverse within its gamut.
FN vec3 display_light(vec3 codes, DisplayModel display, Real mean_cd_m2) {
  vec3 signal =
      vec3(transfer_decode(codes.x, display), transfer_decode(codes.y, display), transfer_decode(codes.z, display));
  return inverse(display.rgb_from_xyz) *
         (vec3(display_floor_cd_m2(display, mean_cd_m2)) + display.range_cd_m2 * signal);
}

// Code values, 0 to 1, with noise before their rounding, so that no contour shows and the mean is kept: triangular over
// -1 to 1 steps (Lipshitz, Wannamaker and Vanderkooy 1992, J. Audio Eng. Soc. 40, 355), and within half a step of black
// and white as much narrower as keeps it from being cut there. Black and white themselves stay.
// It is the sum of two uniform sequences that fill their range evenly over any few neighbours, channels and frames
// (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"), so that little of it is left at the low
// frequencies that the eye sees; a quarter of one is hashed, which breaks up their lattice.
// column, row: of the pixel in the picture. seed: of the noise, the number of the frame in a sequence. steps: between
// black and white.
FN vec3 dithered(vec3 codes, uint column, uint row, uint seed, Real steps) {
  // Shares of 2^32: powers of 0.7548776662 (of the plane's sequence), 0.6180339887 (of the line's) and a third. Read as
  // signed numbers they lie about 0.
  uint frame = seed * 2654435769u;
  uint first = column * 3242174889u + row * 2447445414u + frame;
  uint second = column * 2447445414u - row * 3242174889u - frame;
  uint third = 1431655765u;
  uint hashed = hash_uint((row * 16384u + column) ^ frame);
  uint quarter = 1073740800u; // 1023 of 4096
  vec3 wide = vec3(Real(int(first)), Real(int(first + third)), Real(int(first - third)));
  vec3 narrow = vec3(Real(int(second + ((hashed << 20u) & quarter))),
                     Real(int(second + third + ((hashed << 10u) & quarter))),
                     Real(int(second - third + (hashed & quarter))));
  vec3 room = clamp(min(codes, vec3(Real(1.0)) - codes) * (Real(2.0) * steps), vec3(Real(0.0)), vec3(Real(1.0)));
  Real unit = Real(2.3281e-10) / steps; // 0.9999 of 2^-32 of a step
  return codes + unit * (wide + room * narrow);
}
