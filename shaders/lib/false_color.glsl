// Luminance told by colours, and their legend.

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
