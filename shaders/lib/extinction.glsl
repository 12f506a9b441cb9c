// Extinction along an optical path through a spherical shell of constant density (Buchholz in Mueller et al. 2012,
// eq. 11 and 12), in the form that holds at the zenith, below the horizon and at any height.

const Real earth_radius_km = Real(6371.0);
const Real air_scale_height_km = Real(8.0);

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

// Share of the light that is left in X, Y, Z, S after the optical path, from the optical depth of one zenith column.
FN vec4 extinction(vec4 optical_depth, Real path) { return exp(-path * optical_depth); }
