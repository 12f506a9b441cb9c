// The air between an observer and a point: how much of the point's light it lets through and what light it adds.
//
// L(way) = L(observer) - T(way) L(point), with L the light of the air along the whole ray (sky_table.glsl) as it is seen
// from both ends. Where the observer stands outside the air, the way begins where the ray enters.

// A place on a ray and the light as it stands there.
struct SkyRayPlace {
  Real height_km;
  Real altitude_rad;  // of the ray
  vec3 to_light;      // unit vector: along the ray's level direction, aside, up
  bool meets_ground;  // the ray, farther on
};

// The same ray some way farther on.
FN SkyRayPlace sky_ray_place(SkyRayPlace from, Real distance_km, SkyTableFrame frame) {
  Real radius = frame.ground_km + from.height_km;
  Real rise = radius * sin(from.altitude_rad);
  Real level = radius * cos(from.altitude_rad);
  Real along = rise + distance_km;
  // The height gained, without cancellation.
  Real gain = distance_km * (rise + along) / (radius + sqrt(level * level + along * along));
  Real turn = atan(level * distance_km, radius * radius + rise * distance_km); // from vertical to vertical
  SkyRayPlace place;
  place.height_km = max(from.height_km + gain, Real(0.0));
  place.altitude_rad = from.altitude_rad + turn;
  place.to_light = vec3(cos(turn) * from.to_light.x - sin(turn) * from.to_light.z, from.to_light.y,
                        cos(turn) * from.to_light.z + sin(turn) * from.to_light.x);
  place.meets_ground = from.meets_ground;
  return place;
}

// Way to where the ray leaves the air, by the ground or at the top.
FN Real sky_way_in_air_km(SkyRayPlace from, SkyTableFrame frame) {
  if (from.meets_ground) {
    return sky_ground_distance_km(from.height_km, from.altitude_rad, frame);
  }
  Real radius = frame.ground_km + from.height_km;
  Real rise = radius * sin(from.altitude_rad);
  Real under_top = max((frame.top_km - radius) * (frame.top_km + radius), Real(0.0));
  Real root = sqrt(rise * rise + under_top);
  return rise > Real(0.0) ? under_top / (root + rise) : root - rise;
}

// Light from the air along the whole ray above 1 lux of sunlight, cd/m2. phase: of the aerosol, per steradian
// (sky_aerosol_phase), which does not change on the way.
FN vec4 sky_air_light(sampler3D other, sampler3D aerosol, SkyRayPlace at, Real phase, SkyTableFrame frame) {
  Real level = sqrt(at.to_light.x * at.to_light.x + at.to_light.y * at.to_light.y);
  Real light_altitude = atan(at.to_light.z, level);
  Real cos_azimuth = level > Real(1.0e-6) ? clamp(at.to_light.x / level, Real(-1.0), Real(1.0)) : Real(1.0);
  SkyViewPlace view = sky_view_place(at.altitude_rad, sky_dip(at.height_km, frame), at.meets_ground, frame);
  return sky_path_share(at.height_km, at.altitude_rad, at.meets_ground, frame) *
         (exp2(sky_table_log2(other, at.height_km, view, light_altitude, cos_azimuth, frame)) +
          phase * exp2(sky_table_log2(aerosol, at.height_km, view, light_altitude, cos_azimuth, frame)));
}

// How much the extinction varies over each of X, Y, Z and S: its variance over the square of its mean. With optical depths
// in a gamma distribution over the band the share that passes over a mean depth t is (1 + v t)^(-1/v); of a light with
// the blueness b, whose spectrum is the sunlight's times the extinction's power b, (1 + v t)^(-1/v - b). The figures are
// those of a few that were tried on clear air (tests/accuracy/sky_to_point_test.cpp).
FN vec4 sky_band_variance() { return vec4(Real(0.15), Real(0.07), Real(0.025), Real(0.065)); }

// From Z over Y, in which molecules differ by their extinction at 450 and 560 nm.
FN Real sky_blueness(vec4 light, vec4 sunlight) {
  Real least = Real(1.0e-30);
  return log(max(light.z, least) * sunlight.y / (max(light.y, least) * sunlight.z)) / Real(0.875);
}

FN vec4 sky_passed(vec4 depth, Real blueness) {
  vec4 variance = sky_band_variance();
  vec4 power = max(vec4(Real(1.0)) / variance + vec4(blueness), Real(0.25) / variance);
  return exp2(-power * log2(vec4(Real(1.0)) + variance * depth));
}

// Mean optical depth of the air above a height.
FN vec4 sky_zenith_depth(sampler2D transmittance, Real height_km, SkyTransmittanceFrame nodes, SkyTableFrame frame) {
  vec4 variance = sky_band_variance();
  vec4 zenith = sky_transmittance_log2(transmittance, height_km, Real(0.5) * pi, nodes, frame);
  return (exp2(-variance * zenith) - vec4(Real(1.0))) / variance;
}

// Mean optical depth of a way. The quotient of what passes from both ends toward space would not do: what has lost its
// blue loses less, and along low rays all but a little of both is common. So the way's own extinction is summed up, from
// that of the layers it crosses, in steps that crowd where the way is lowest.
CONSTANT int sky_way_steps = 12;

FN vec4 sky_way_depth(sampler2D transmittance, SkyRayPlace from, Real way_km, SkyTransmittanceFrame nodes,
                     SkyTableFrame frame) {
  Real least_layer_km = Real(0.1);
  Real lowest_km = clamp(-(frame.ground_km + from.height_km) * sin(from.altitude_rad), Real(0.0), way_km);
  Real first = -sqrt(lowest_km);
  Real last = sqrt(way_km - lowest_km);
  Real start_km = Real(0.0);
  Real start_height = from.height_km;
  vec4 depth = vec4(Real(0.0));
  for (int i = 1; i <= sky_way_steps; ++i) {
    Real place = mix(first, last, Real(i) / Real(sky_way_steps));
    Real end_km = lowest_km + place * abs(place);
    Real end_height = sky_ray_place(from, end_km, frame).height_km;
    Real middle = Real(0.5) * (start_height + end_height);
    Real half_layer = Real(0.5) * max(abs(end_height - start_height), least_layer_km);
    Real low = max(middle - half_layer, Real(0.0));
    Real high = middle + half_layer;
    depth += (sky_zenith_depth(transmittance, low, nodes, frame) - sky_zenith_depth(transmittance, high, nodes, frame)) *
             ((end_km - start_km) / (high - low));
    start_km = end_km;
    start_height = end_height;
  }
  return max(depth, vec4(Real(0.0)));
}

// Interpolation and rounding would show in the difference over shorter ways, which get their share of this one.
CONSTANT Real sky_least_way_km = Real(0.25);

struct SkyWay {
  vec4 light;         // that the air between adds, above 1 lux of sunlight: cd/m2
  vec4 transmittance; // of sunlight
};

// sunlight: X, Y, Z and S of 1 lux of it. distance_km: from where the ray begins or enters the air; what lies behind the air or the ground is as far as they are.
FN SkyWay sky_way(sampler3D other, sampler3D aerosol, sampler2D transmittance, vec4 sunlight, SkyRayPlace from,
                  Real phase, Real distance_km, SkyTransmittanceFrame nodes, SkyTableFrame frame) {
  Real whole_km = sky_way_in_air_km(from, frame);
  Real way_km = clamp(distance_km, Real(0.0), whole_km);
  Real taken_km = min(max(way_km, sky_least_way_km), whole_km);
  Real share = taken_km > Real(0.0) ? way_km / taken_km : Real(0.0);
  SkyRayPlace to = sky_ray_place(from, taken_km, frame);
  vec4 depth = sky_way_depth(transmittance, from, taken_km, nodes, frame);
  vec4 all = sky_air_light(other, aerosol, from, phase, frame);
  SkyWay way;
  way.light = all;
  if (taken_km < whole_km) {
    vec4 behind = sky_air_light(other, aerosol, to, phase, frame);
    way.light = clamp(all - sky_passed(depth, sky_blueness(behind, sunlight)) * behind, vec4(Real(0.0)), all);
  }
  way.light = share * way.light;
  way.transmittance = sky_passed(share * depth, Real(0.0));
  return way;
}
