// Hillaire's sky (2020, Computer Graphics Forum 39, 13): light scattered once is summed along each view ray, all other
// light is taken from a small table of what an evenly lit, evenly scattering neighbourhood would hold. Nothing large is
// precomputed, so that the air may change at any moment. Four wavelengths at a time.
//
// Radiance stands above an irradiance of 1. The transmittance table is laid out as that of sky_table.glsl and holds the
// four wavelengths.

struct SmallSkyFrame {
  Real ground_km; // radii
  Real top_km;
  Real light_radius_rad;
  Real depolarization; // of molecules
  int levels;          // of the table of the air
  int multiple_nodes;  // of the table of light scattered many times, both ways
  int steps;           // along a view ray
};

// What a kilometre of air takes and scatters.
struct SmallSkyAir {
  vec4 extinction_per_km;
  vec4 molecules_per_km;
  vec4 aerosol_per_km;
};

// air: x level, crowded at the ground; y extinction, scattering by molecules, by aerosol.
FN SmallSkyAir small_sky_air(sampler2D air, Real height_km, SmallSkyFrame frame) {
  Real share = clamp(height_km / (frame.top_km - frame.ground_km), Real(0.0), Real(1.0));
  Real place = sqrt(share) * Real(frame.levels - 1);
  int i = min(int(place), frame.levels - 2);
  Real t = place - Real(i);
  SmallSkyAir result;
  result.extinction_per_km = mix(texelFetch(air, ivec2(i, 0), 0), texelFetch(air, ivec2(i + 1, 0), 0), t);
  result.molecules_per_km = mix(texelFetch(air, ivec2(i, 1), 0), texelFetch(air, ivec2(i + 1, 1), 0), t);
  result.aerosol_per_km = mix(texelFetch(air, ivec2(i, 2), 0), texelFetch(air, ivec2(i + 1, 2), 0), t);
  return result;
}

// The light that reaches a place, the ground in the way included.
FN vec4 small_sky_light(sampler2D transmittance, Real height_km, Real sin_light, SkyTransmittanceFrame nodes,
                        SmallSkyFrame frame) {
  Real altitude = asin(clamp(sin_light, Real(-1.0), Real(1.0)));
  Real h = max(height_km, Real(0.0));
  Real dip = atan(sqrt(h * (Real(2.0) * frame.ground_km + h)), frame.ground_km);
  Real visible = sky_disc_visible(altitude, dip, frame.light_radius_rad);
  if (visible <= Real(0.0)) {
    return vec4(Real(0.0));
  }
  Real over = clamp((altitude + dip) / (Real(0.5) * pi + dip), Real(0.0), Real(1.0));
  Real share = clamp(h / (frame.top_km - frame.ground_km), Real(0.0), Real(1.0));
  Real x = sqrt(over) * Real(nodes.altitudes - 1);
  Real y = sqrt(share) * Real(nodes.heights - 1);
  int i = min(int(x), nodes.altitudes - 2);
  int j = min(int(y), nodes.heights - 2);
  Real s = x - Real(i);
  vec4 low = mix(texelFetch(transmittance, ivec2(i, j), 0), texelFetch(transmittance, ivec2(i + 1, j), 0), s);
  vec4 high = mix(texelFetch(transmittance, ivec2(i, j + 1), 0), texelFetch(transmittance, ivec2(i + 1, j + 1), 0), s);
  return visible * exp2(mix(low, high, y - Real(j)));
}

// Radiance of all light scattered more than once, the same in all directions. x: sine of the light's altitude, y: height.
FN vec4 small_sky_multiple(sampler2D multiple, Real height_km, Real sin_light, SmallSkyFrame frame) {
  Real last = Real(frame.multiple_nodes - 1);
  Real x = clamp(Real(0.5) + Real(0.5) * sin_light, Real(0.0), Real(1.0)) * last;
  Real y = clamp(height_km / (frame.top_km - frame.ground_km), Real(0.0), Real(1.0)) * last;
  int i = min(int(x), frame.multiple_nodes - 2);
  int j = min(int(y), frame.multiple_nodes - 2);
  Real s = x - Real(i);
  vec4 low = mix(texelFetch(multiple, ivec2(i, j), 0), texelFetch(multiple, ivec2(i + 1, j), 0), s);
  vec4 high = mix(texelFetch(multiple, ivec2(i, j + 1), 0), texelFetch(multiple, ivec2(i + 1, j + 1), 0), s);
  return mix(low, high, y - Real(j));
}

// A view ray from a place inside the air.
struct SmallSkyRay {
  Real height_km;
  Real sin_altitude;
  Real length_km; // to the ground or the top of the air
  bool meets_ground;
};

FN SmallSkyRay small_sky_ray(Real height_km, Real sin_altitude, bool meets_ground, SmallSkyFrame frame) {
  SmallSkyRay ray;
  ray.height_km = max(height_km, Real(0.0));
  ray.sin_altitude = sin_altitude;
  ray.meets_ground = meets_ground;
  Real rise = (frame.ground_km + ray.height_km) * sin_altitude;
  // Squares of radii differ by this, without cancellation.
  Real over_ground = ray.height_km * (Real(2.0) * frame.ground_km + ray.height_km);
  Real depth = max(frame.top_km - frame.ground_km - ray.height_km, Real(0.0));
  Real under_top = depth * (frame.top_km + frame.ground_km + ray.height_km);
  if (meets_ground) {
    Real root = sqrt(max(rise * rise - over_ground, Real(0.0)));
    ray.length_km = over_ground / max(root - rise, Real(1.0e-6));
  } else {
    Real root = sqrt(rise * rise + under_top);
    ray.length_km = rise > Real(0.0) ? under_top / max(root + rise, Real(1.0e-6)) : root - rise;
  }
  return ray;
}

// A point on it: height, and sine of the light's altitude there.
FN vec2 small_sky_point(SmallSkyRay ray, Real along_km, Real sin_light, Real cos_angle, SmallSkyFrame frame) {
  Real origin = frame.ground_km + ray.height_km;
  Real over = ray.height_km * (Real(2.0) * frame.ground_km + ray.height_km) +
              along_km * (along_km + Real(2.0) * origin * ray.sin_altitude);
  Real radius = sqrt(max(frame.ground_km * frame.ground_km + over, Real(1.0)));
  Real height = over / (radius + frame.ground_km);
  return vec2(height, (origin * sin_light + along_km * cos_angle) / radius);
}

struct SmallSkyLight {
  vec4 aerosol; // scattered once by aerosol, over its phase function
  vec4 other;
};

// Light from the air along a ray. cos_angle: of the angle between the view and the light.
FN SmallSkyLight small_sky_radiance(SmallSkyRay ray, Real sin_light, Real cos_angle, sampler2D air,
                                    sampler2D transmittance, sampler2D multiple, SkyTransmittanceFrame nodes,
                                    SmallSkyFrame frame) {
  SmallSkyLight light;
  light.aerosol = vec4(Real(0.0));
  light.other = vec4(Real(0.0));
  vec4 left = vec4(Real(1.0));
  Real molecules = rayleigh_phase(cos_angle, frame.depolarization);
  for (int i = 0; i < frame.steps; ++i) {
    // Steps grow with the distance.
    Real from = Real(i) / Real(frame.steps);
    Real to = Real(i + 1) / Real(frame.steps);
    Real step_km = ray.length_km * (to * to - from * from);
    vec2 point = small_sky_point(ray, ray.length_km * Real(0.5) * (from * from + to * to), sin_light, cos_angle, frame);
    SmallSkyAir here = small_sky_air(air, point.x, frame);
    vec4 direct = small_sky_light(transmittance, point.x, point.y, nodes, frame);
    vec4 others = small_sky_multiple(multiple, point.x, point.y, frame);
    vec4 passed = exp(-step_km * here.extinction_per_km);
    // Light from all of the step, dimmed by the part of it that lies before.
    vec4 reach = left * (vec4(Real(1.0)) - passed) / max(here.extinction_per_km, vec4(Real(1.0e-9)));
    light.aerosol += reach * here.aerosol_per_km * direct;
    light.other += reach * (here.molecules_per_km * (molecules * direct + others) + here.aerosol_per_km * others);
    left *= passed;
  }
  return light;
}

// The table of light scattered many times: what is scattered once from all sides, by 64 directions and as if evenly,
// times the sum of the geometric series of all further orders.
FN vec4 small_sky_multiple_texel(int column, int row, vec4 albedo, sampler2D air, sampler2D transmittance,
                                 SkyTransmittanceFrame nodes, SmallSkyFrame frame) {
  Real last = Real(frame.multiple_nodes - 1);
  Real sin_light = Real(2.0) * Real(column) / last - Real(1.0);
  Real cos_light = sqrt(max(Real(1.0) - sin_light * sin_light, Real(0.0)));
  Real thickness = frame.top_km - frame.ground_km;
  Real height = clamp(thickness * Real(row) / last, sky_least_height_km, thickness - sky_least_depth_km);
  Real radius = frame.ground_km + height;
  Real sin_horizon = -sqrt(height * (Real(2.0) * frame.ground_km + height)) / radius;
  vec4 second = vec4(Real(0.0));
  vec4 again = vec4(Real(0.0));
  int side = 8;
  for (int d = 0; d < side * side; ++d) {
    Real sin_altitude = Real(1.0) - Real(2.0) * (Real(d / side) + Real(0.5)) / Real(side);
    Real azimuth = Real(2.0) * pi * (Real(d % side) + Real(0.5)) / Real(side);
    Real level = sqrt(Real(1.0) - sin_altitude * sin_altitude);
    Real cos_angle = sin_altitude * sin_light + level * cos_light * cos(azimuth);
    SmallSkyRay ray = small_sky_ray(height, sin_altitude, sin_altitude < sin_horizon, frame);
    vec4 left = vec4(Real(1.0));
    for (int i = 0; i < frame.steps; ++i) {
      Real from = Real(i) / Real(frame.steps);
      Real to = Real(i + 1) / Real(frame.steps);
      Real step_km = ray.length_km * (to * to - from * from);
      vec2 point =
          small_sky_point(ray, ray.length_km * Real(0.5) * (from * from + to * to), sin_light, cos_angle, frame);
      SmallSkyAir here = small_sky_air(air, point.x, frame);
      vec4 passed = exp(-step_km * here.extinction_per_km);
      vec4 scattered = left * (vec4(Real(1.0)) - passed) / max(here.extinction_per_km, vec4(Real(1.0e-9))) *
                       (here.molecules_per_km + here.aerosol_per_km);
      second += scattered * small_sky_light(transmittance, point.x, point.y, nodes, frame) / sphere_sr;
      again += scattered;
      left *= passed;
    }
    if (ray.meets_ground) {
      vec2 ground = small_sky_point(ray, ray.length_km, sin_light, cos_angle, frame);
      second += left * albedo * max(ground.y, Real(0.0)) *
                small_sky_light(transmittance, Real(0.0), ground.y, nodes, frame) / pi;
    }
  }
  vec4 count = vec4(Real(side * side));
  return second / count / (vec4(Real(1.0)) - min(again / count, vec4(Real(0.99))));
}
