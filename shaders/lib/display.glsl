// From the frame's tristimulus values to the display.

// CIE XYZ to linear sRGB (IEC 61966-2-1 primaries, D65 white).
FN vec3 srgb_from_xyz(vec3 xyz) {
  return vec3(Real(3.2404542) * xyz.x - Real(1.5371385) * xyz.y - Real(0.4985314) * xyz.z,
              Real(-0.9692660) * xyz.x + Real(1.8760108) * xyz.y + Real(0.0415560) * xyz.z,
              Real(0.0556434) * xyz.x - Real(0.2040259) * xyz.y + Real(1.0572252) * xyz.z);
}

// sRGB transfer function (IEC 61966-2-1), linear 0 to 1 in, code value 0 to 1 out.
FN Real srgb_encode(Real linear) {
  Real v = clamp(linear, Real(0.0), Real(1.0));
  return v <= Real(0.0031308) ? Real(12.92) * v : Real(1.055) * pow(v, Real(1.0 / 2.4)) - Real(0.055);
}

// Brings a colour into the display's range: its largest component is left as it is up to a half and approaches 1 above,
// the others keep their ratio to it, so that neither a star's core nor a bright sky is bleached and no edge shows where
// a component would be clipped. Negative components (outside the gamut) are cut.
FN vec3 fit_to_display(vec3 linear) {
  vec3 positive = max(linear, vec3(Real(0.0), Real(0.0), Real(0.0)));
  Real largest = max(positive.x, max(positive.y, positive.z));
  return largest > Real(0.5) ? positive * ((Real(1.0) - Real(0.5) * exp(Real(1.0) - Real(2.0) * largest)) / largest)
                             : positive;
}

// Plain exposure: the luminance that becomes the display's white, in cd/m2, divides the frame.
FN vec3 plain_exposure(vec3 xyz, Real white_cd_m2) {
  vec3 linear = fit_to_display(srgb_from_xyz(xyz / white_cd_m2));
  return vec3(srgb_encode(linear.x), srgb_encode(linear.y), srgb_encode(linear.z));
}

// A code value, 0 to 1, with noise before its quantisation, so that no contour shows and the mean is kept: triangular over
// -1 to 1 steps (Lipshitz, Wannamaker and Vanderkooy 1992, J. Audio Eng. Soc. 40, 355), and within half a step of black
// and white as much narrower as keeps it from being cut there. Black and white themselves stay.
// column, row: of the pixel in the picture. steps: between black and white.
FN Real dithered(Real code, uint column, uint row, uint channel, Real steps) {
  uint key = hash_pair(column, hash_pair(row, channel));
  Real room = min(code, Real(1.0) - code) * steps;
  Real noise = Real(0.9999) * (hash_unit(key) - Real(0.5)) +
               clamp(Real(2.0) * room, Real(0.0), Real(1.0)) * (hash_unit(hash_uint(key)) - Real(0.5));
  return code + noise / steps;
}
