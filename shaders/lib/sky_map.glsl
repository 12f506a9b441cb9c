// The map of a frame's sky: a direction's place in it and back. Algebraic, because every pixel asks.
//
// Directions as they are seen, in the horizon frame. The map has two halves, the views that meet the ground and the
// others. In each, rows run from the horizon to where the half ends: the nadir, or the zenith; for an observer above the
// air, the top of the limb.

struct SkyMapFrame { // sines of half the angles
  Real nadir_to_horizon;
  Real zenith_to_horizon;
  Real zenith_to_end;
};

// Columns: from east over north, 0 to 1, even along the four sides of a square. Nodes stand on its corners, so that its
// kinks do not show; the last is the first again.
FN Real sky_map_column(vec2 level) {
  Real around = level.x / max(abs(level.x) + abs(level.y), Real(1.0e-30));
  return level.y >= Real(0.0) ? Real(0.25) * (Real(1.0) - around) : Real(0.25) * (Real(3.0) + around);
}

FN vec2 sky_map_level(Real column) {
  Real around = column <= Real(0.5) ? Real(1.0) - Real(4.0) * column : Real(4.0) * column - Real(3.0);
  Real across = Real(1.0) - abs(around);
  return normalize(vec2(around, column <= Real(0.5) ? across : -across));
}

// Sine of half the angle from the zenith, or from the nadir: as even as the angle itself.
FN Real sky_map_half_sine(Real sin_altitude, bool below) {
  return sqrt(max(Real(0.5) * (Real(1.0) + (below ? sin_altitude : -sin_altitude)), Real(0.0)));
}

FN SkyMapFrame sky_map_frame(Real sin_horizon, Real sin_highest) {
  SkyMapFrame frame;
  frame.nadir_to_horizon = sky_map_half_sine(sin_horizon, true);
  frame.zenith_to_horizon = sky_map_half_sine(sin_horizon, false);
  frame.zenith_to_end = sky_map_half_sine(sin_highest, false);
  return frame;
}

// Rows: 0 at the horizon, where they crowd, to 1. More than 1 above the limb.
FN Real sky_map_row(Real sin_altitude, bool below, SkyMapFrame frame) {
  Real horizon = below ? frame.nadir_to_horizon : frame.zenith_to_horizon;
  Real end = below ? Real(0.0) : frame.zenith_to_end;
  return sqrt(max((horizon - sky_map_half_sine(sin_altitude, below)) / (horizon - end), Real(0.0)));
}

FN Real sky_map_altitude_rad(Real row, bool below, SkyMapFrame frame) {
  Real horizon = below ? frame.nadir_to_horizon : frame.zenith_to_horizon;
  Real end = below ? Real(0.0) : frame.zenith_to_end;
  Real from_end = Real(2.0) * sky_arc_sine(mix(horizon, end, row * row));
  return below ? from_end - Real(1.5707963267948966) : Real(1.5707963267948966) - from_end;
}

// Where the texels of a map or table with `rows` below the horizon and above it hold a row: those below come first, the
// horizon lies between.
FN Real sky_map_row_texel(Real row, bool below, vec2 rows) {
  return rows.x + (below ? -Real(0.5) - row * (rows.x - Real(1.0))
                         : Real(0.5) + min(row, Real(1.0)) * (rows.y - Real(1.0)));
}

// Where the map's texels hold a direction, which lies `depth` below the horizon's sine of altitude: rows of the half that
// meets the ground come first, the halves meet at the horizon, and a pixel there has its share of both. `cover`: share of
// the pixel below the horizon, less than 0 or more than 1 away from it. `row` tells of views above the limb.
FN vec2 sky_map_texel(vec3 direction, Real depth, Real cover, vec2 rows, Real columns, SkyMapFrame frame,
                      OUT(Real) row) {
  bool below = depth > Real(0.0);
  row = sky_map_row(direction.z, below, frame);
  Real place = sky_map_row_texel(row, below, rows);
  place = cover > Real(0.0) && cover < Real(1.0) ? rows.x + Real(0.5) - cover : place;
  return vec2(Real(0.5) + sky_map_column(vec2(direction)) * (columns - Real(1.0)), place);
}

// Light that aerosol scattered once is in the map as if its phase function rose less steeply at small angles; what this
// leaves out, the peak, each pixel near the light adds.
CONSTANT Real sky_peak_cos = Real(0.94);

// Place of an angle in the phase function's texels, 0 to 1: the root of the sine of half the angle. The peak's own
// reaches from 0 to the angle at which it begins.
FN Real sky_phase_place(Real cos_angle) { return sqrt(sqrt(max(Real(0.5) - Real(0.5) * cos_angle, Real(0.0)))); }
FN Real sky_peak_place(Real cos_angle) {
  return sqrt(sqrt(max((Real(1.0) - cos_angle) / (Real(1.0) - sky_peak_cos), Real(0.0))));
}
