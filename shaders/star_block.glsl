// What all stars of a frame share; the C++ twin is StarBlock in renderer/gpu/star_pass.cpp.
layout(std140, binding = 0) uniform StarBlock {
  dmat3 horizon_from_icrs;
  dmat3 view_from_horizon;
  dvec3 observer_au;
  double years;
  dvec3 velocity_c;
  double lorentz_inverse;
  dvec3 sun_to_observer;
  double solar_potential;
  dvec2 size;
  double focal;
  double seconds;
  vec4 optical_depth;       // of one zenith column, of the cheap tier, in X, Y, Z, S; zero for no air
  float observer_height_km;
  float exposure_s;         // scintillation is averaged over it
  float pupil_m;            // 0 for no scintillation
  float sun_sin_altitude;
  float control_magnitude;  // of the cheap tier
  int copies;               // billboards per star: 1, 2 where the picture wraps round, 3 for the cube map's faces
  uint seed;
  uint frame_number;        // of the cheap tier's scintillation
  uint star_count;
  vec2 strip;               // first row and number of rows that the framebuffer holds
  vec4 refraction_scales;   // RefractionFrame: scale_apparent, scale_true
  vec2 refraction_horizons; // horizon_apparent, horizon_true
  int refraction_kind;
  float refraction_strength;
  int extinction_rows;      // StarExtinctionFrame
  int extinction_columns;
  float extinction_horizon;
  float extinction_width;
  float extinction_rows_per_x;
  float extinction_reddest;
  float extinction_columns_per_hue;
} block;
