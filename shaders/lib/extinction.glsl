// Extinction of starlight: from a table made for the observer, or along the path through a shell of constant density.
//
// The table holds logarithms of the shares of X, Y, Z and S that are left, over the apparent altitude and the colour.
// Rows stand at equal steps of arc_sinh((sin(altitude) - horizon) / width), so that they crowd where the lowest layers
// of the air come in; columns at equal steps of ln(Z/Y) of the light above the air, from the reddest black body on.
struct StarExtinctionFrame {
  int rows;    // at least 2 of each
  int columns;
  Real sin_horizon; // of the apparent altitude of the horizon
  Real width;
  Real rows_per_x; // 0 for a table that is the same everywhere
  Real reddest;    // ln(Z/Y) of the first column
  Real columns_per_hue;
};

// The shares that are left, between rows and columns in a straight line of their logarithms. Below the horizon, where
// the ground stops all light, those of the mirrored altitude, so that the sky can also be drawn without a ground.
FN vec4 star_extinction(Real sin_altitude, vec4 light, StarExtinctionFrame frame, sampler2D table) {
  Real off = abs(sin_altitude - frame.sin_horizon);
  Real row = clamp(frame.rows_per_x * arc_sinh(off / frame.width), Real(0.0), Real(frame.rows - 1));
  // Light without any Y or Z has the colour of the nearest end.
  Real hue = log(max(light.z, Real(1.0e-30)) / max(light.y, Real(1.0e-30)));
  Real column = clamp(frame.columns_per_hue * (hue - frame.reddest), Real(0.0), Real(frame.columns - 1));
  int i = min(int(column), frame.columns - 2);
  int j = min(int(row), frame.rows - 2);
  Real across = column - Real(i);
  vec4 low = mix(texelFetch(table, ivec2(i, j), 0), texelFetch(table, ivec2(i + 1, j), 0), across);
  vec4 high = mix(texelFetch(table, ivec2(i, j + 1), 0), texelFetch(table, ivec2(i + 1, j + 1), 0), across);
  return exp(mix(low, high, row - Real(j)));
}

// The cheap tier: a shell of constant density (Buchholz in Mueller et al. 2012, eq. 11 and 12), in the form that holds
// at the zenith, below the horizon and at any height. Rays are straight: with refraction, the apparent altitude is the
// one to take, along which they run through the densest air.

CONSTANT Real earth_radius_km = Real(6371.0);
CONSTANT Real air_scale_height_km = Real(8.0);

// Path to the top of the homogeneous shell above a point at radius r, over the shell's thickness, for a sine of
// altitude >= 0: 1 at the zenith, about 40 at the horizon.
FN Real shell_path(Real sin_altitude, Real radius_km) {
  Real b = radius_km * sin_altitude;
  Real c = air_scale_height_km * (Real(2.0) * radius_km + air_scale_height_km);
  // c / (b + sqrt(b^2 + c)) is the root without cancellation.
  return c / ((b + sqrt(b * b + c)) * air_scale_height_km);
}

// Optical path from space to an observer at the height (km, >= -1), in zenith columns of sea level. Below the
// horizontal it runs through the tangent point; where the ground would stop it, the path of the mirrored altitude
// is given, so that the sky can also be drawn without a ground.
FN Real optical_path(Real sin_altitude, Real height_km) {
  Real radius = earth_radius_km + height_km;
  Real density = exp(-height_km / air_scale_height_km);
  Real upward = density * shell_path(abs(sin_altitude), radius);
  Real tangent_radius = radius * sqrt(max(Real(1.0) - sin_altitude * sin_altitude, Real(0.0)));
  if (sin_altitude >= Real(0.0) || tangent_radius <= earth_radius_km) {
    return upward;
  }
  Real tangent_density = exp(-(tangent_radius - earth_radius_km) / air_scale_height_km);
  return max(Real(2.0) * tangent_density * shell_path(Real(0.0), tangent_radius) - upward, upward);
}

// The response X has two lobes: its blue one is this share of Z (CIE 1931: 0.348 at 442 nm against 1.78).
CONSTANT Real short_lobe_of_x = Real(0.1955);

// Light in X, Y, Z, S times factors that were found for one wavelength each (about 600, 555, 450 and 507 nm). The blue
// lobe of X goes with Z: without that a reddened star would turn pink.
FN vec4 modulate_xyzs(vec4 light, vec4 factor) {
  Real blue = short_lobe_of_x * light.z;
  return vec4(max(light.x - blue, Real(0.0)) * factor.x + blue * factor.z, light.y * factor.y, light.z * factor.z,
              light.w * factor.w);
}

// Share of the light that is left after the optical path at the wavelengths of modulate_xyzs, from the optical depth of
// one zenith column there.
FN vec4 extinction(vec4 optical_depth, Real path) { return exp(-path * optical_depth); }
