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

// A curve's texel at a luminance: x: log2 of the luminance that the display adds to its own floor, y: log2 of that of a
// point over the luminance that the eye gets of it, z and w as the curve's maker says. Linear between nodes.
FN vec4 tone_curve(Real luminance_cd_m2, sampler1D curve) {
  Real octave = log2(max(luminance_cd_m2, Real(1.0e-30))) - Real(tone_lowest_octave);
  Real at = clamp(Real(tone_nodes_per_octave) * octave, Real(0.0), Real(tone_nodes - 1));
  int node = min(int(at), tone_nodes - 2);
  return mix(texelFetch(curve, node, 0), texelFetch(curve, node + 1, 0), at - Real(node));
}

// Share of the cones in what is seen at one place, which adapts to itself: two steps of the iteration of CIE 191:2010
// (mesopic.glsl). Within 0.03 of its solution for light of S/P above 0.5.
FN Real local_cone_share(Real photopic_cd_m2, Real scotopic_cd_m2) {
  Real m = Real(0.5);
  for (int i = 0; i < 2; ++i) {
    Real seen = mesopic_luminance(photopic_cd_m2, scotopic_cd_m2, m);
    m = clamp(Real(0.7670) + Real(0.10036340) * log2(max(seen, Real(1.0e-30))), Real(0.0), Real(1.0));
  }
  return m;
}

// A display luminance with a point's light on top: as much more where there is room, ever less towards the ceiling.
FN Real under_ceiling(Real luminance, Real more, Real ceiling) {
  Real room = max(ceiling - luminance, Real(1.0e-6) * ceiling);
  return luminance + room * (Real(1.0) - exp(-more / room));
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

// Steepest rise of the display's over the scene's logarithm of luminance at which what cannot be told apart in the scene is not
// told apart on the display (Larson, Rushmeier and Piatko 1997, eq. 9, the ceiling by human contrast sensitivity), and no
// contrast is exaggerated. Steps that can just be seen, over the luminance: of display and scene.
FN Real steepest_rise(Real display_step, Real scene_step) { return min(display_step / scene_step, Real(1.0)); }

// Colours of luminance, one hue every two decades from 1e-6 to 1e10 cd/m2: linear components, 0 to 1. Brightness grows along
// with luminance.
CONSTANT Real false_color_lowest = Real(-6.0); // log10
CONSTANT Real false_color_highest = Real(10.0);
FN vec3 false_color_stop(int i) {
  if (i <= 0) return vec3(Real(0.0), Real(0.0), Real(0.0));
  if (i == 1) return vec3(Real(0.060), Real(0.005), Real(0.120));
  if (i == 2) return vec3(Real(0.020), Real(0.040), Real(0.600));
  if (i == 3) return vec3(Real(0.000), Real(0.280), Real(0.420));
  if (i == 4) return vec3(Real(0.010), Real(0.450), Real(0.060));
  if (i == 5) return vec3(Real(0.650), Real(0.560), Real(0.000));
  if (i == 6) return vec3(Real(0.950), Real(0.250), Real(0.010));
  if (i == 7) return vec3(Real(1.000), Real(0.400), Real(0.550));
  return vec3(Real(1.0), Real(1.0), Real(1.0));
}
// place: 0 to 1 over the decades
FN vec3 false_color_at(Real place) {
  Real at = Real(8.0) * clamp(place, Real(0.0), Real(1.0));
  int stop = min(int(at), 7);
  return mix(false_color_stop(stop), false_color_stop(stop + 1), at - Real(stop));
}
FN vec3 false_color(Real luminance_cd_m2) {
  Real decade = Real(0.30102999566398120) * log2(max(luminance_cd_m2, Real(1.0e-30)));
  return false_color_at((decade - false_color_lowest) / (false_color_highest - false_color_lowest));
}

// Letters of three by five dots: digits, then the minus sign (10). Bit 14 is the top left dot, bit 0 the bottom right one.
FN int letter_dots(int letter) {
  if (letter == 0) return 31599;
  if (letter == 1) return 11415;
  if (letter == 2) return 29671;
  if (letter == 3) return 29647;
  if (letter == 4) return 23497;
  if (letter == 5) return 31183;
  if (letter == 6) return 31215;
  if (letter == 7) return 29257;
  if (letter == 8) return 31727;
  if (letter == 9) return 31695;
  return letter == 10 ? 448 : 0;
}
FN bool letter_dot(int letter, int column, int row) {
  bool inside = column >= 0 && column < 3 && row >= 0 && row < 5;
  return inside && ((letter_dots(letter) >> (14 - 3 * row - column)) & 1) == 1;
}

// The legend of false colours: a bar at the foot of the picture with the powers of ten of cd/m2 written over it. Colour and, in
// w, 1 where it covers the picture.
// column, row: of the pixel in the picture
FN vec4 false_color_legend(int column, int row, int width, int height) {
  int dot = max(min(width / 160, height / 60), 1);
  int left = width / 16;
  int length_px = width - 2 * left;
  int bar_top = height - 5 * dot;
  int text_top = bar_top - 7 * dot;
  if (row < text_top - dot || row >= height) {
    return vec4(Real(0.0));
  }
  const int decades = 16;
  if (row >= bar_top) {
    if (column < left || column >= left + length_px) {
      return vec4(Real(0.0), Real(0.0), Real(0.0), Real(1.0));
    }
    vec3 color = false_color_at((Real(column - left) + Real(0.5)) / Real(length_px));
    return vec4(color.x, color.y, color.z, Real(1.0));
  }
  // Every other power of ten, centred over its place.
  int nearest = (2 * decades * (column - left) + length_px) / (2 * length_px);
  nearest = 2 * ((clamp(nearest, 0, decades) + 1) / 2);
  for (int i = 0; i < 2; ++i) {
    int step = nearest - 2 * i;
    int power = step + int(false_color_lowest);
    int letters = (power < 0 ? 1 : 0) + (power > 9 ? 2 : 1);
    int first = left + (length_px * step) / decades - (4 * letters - 1) * dot / 2;
    int x = column - first;
    int y = row - text_top;
    if (x >= 0 && y >= 0) {
      int at = x / (4 * dot);
      int magnitude = power < 0 ? -power : power;
      int letter = -1;
      if (at < letters) {
        letter = power < 0 ? (at == 0 ? 10 : magnitude) : (letters == 2 && at == 0 ? magnitude / 10 : magnitude % 10);
      }
      if (letter_dot(letter, (x - 4 * dot * at) / dot, y / dot)) {
        return vec4(Real(0.8), Real(0.8), Real(0.8), Real(1.0));
      }
    }
  }
  return vec4(Real(0.0), Real(0.0), Real(0.0), Real(1.0));
}
