// The sky of a frame over azimuth and view, so that a pixel costs a look-up (Hillaire 2020, "A scalable and production
// ready sky and atmosphere rendering technique").
//
// Layer 0 holds all light, the ground's included, but the peak of what aerosol scattered once; layers 1 and 2 hold what
// that peak is multiplied by, of one light each. All are logarithms to base 2 of X, Y, Z and S, which linear
// interpolation keeps better than the light itself where that falls steeply. Columns and rows: lib/sky_map.glsl, the
// rows that meet the ground first, from nadir to horizon to zenith. OUTSIDE is for an observer above the air: each ray enters it at a place with its own
// altitude of the light.
#include "prelude.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#include "sky_block.glsl"

layout(local_size_x = 56) in; // a group makes a row
layout(binding = 0, rgba32f) uniform image2D map; // its layers below one another
layout(binding = 0) uniform sampler2D transmittance;
layout(binding = 1) uniform sampler2D ground; // its illuminance, a row for each light: sky_ground.comp
layout(binding = 2) uniform sampler1D phase; // y: logarithm to base 2 of the phase function without its peak
#if defined(OUTSIDE) && defined(SMALL)
#include "lib/phase.glsl"
#include "lib/small_sky.glsl"
#include "small_sky_block.glsl"
#elif defined(OUTSIDE)
layout(binding = 3) uniform sampler3D other_table;
layout(binding = 4) uniform sampler3D aerosol_table;

#ifndef MANY_LIGHTS
// The row of both tables between their views, at the top of the air, where all rays enter: as x of the tables. Tables of
// more lights are read as they are: MANY_LIGHTS.
const int most_shared_lights = 64; // as in renderer/gpu/sky_map.cpp
shared vec4 other_row[most_shared_lights * sky_azimuths];
shared vec4 aerosol_row[most_shared_lights * sky_azimuths];
#endif
#else
layout(binding = 3) uniform sampler2D slices; // side by side: first light's other and aerosol, second light's

// The cosine series over the azimuth that the row has of each slice.
shared vec4 series[2 * sky_most_lights][sky_azimuths];
#endif

const float least_light = 7.5e-37; // 2^-120

// What all views of a row share.
struct Row {
  bool below;
  float seen_rad;     // altitude as it is seen
  float turn_rad;     // from the vertical of the observer to that where the ray enters the air
  float height_km;    // there
  float altitude_rad; // there
  SkyViewPlace view;  // there
  float path_share;
  float ground_turn_rad; // from there to the vertical where it meets the ground
  vec4 ground_share;     // of the ground's illuminance that is seen as luminance
};

Row row_of(int number, SkyTableFrame frame) {
  Row row;
  row.below = number < block.map_rows_below;
  int rows = row.below ? block.map_rows_below : block.map_rows_above;
  float place = float(row.below ? rows - 1 - number : number - block.map_rows_below) / float(rows - 1);
  row.seen_rad = sky_map_altitude_rad(place, row.below, map_frame());
  // The horizon that is seen falls on that of straight rays, zenith and nadir on themselves.
  float horizon = sky_arc_sine(block.sin_horizon);
  float dip = sky_dip(block.height_km, frame);
  float quarter = 0.5 * pi;
  row.turn_rad = 0.0;
  row.height_km = block.height_km;
#ifdef OUTSIDE
  float highest = sky_arc_sine(block.sin_highest);
  float share = row.below ? (horizon - row.seen_rad) / (horizon + quarter) : (row.seen_rad - horizon) / (highest - horizon);
  float range = row.below ? dip - quarter : dip - sky_limb_dip(block.height_km, frame);
  float altitude = range * clamp(share, 0.0, 1.0) - dip;
  float nearest = (block.ground_km + block.height_km) * cos(altitude);
  row.altitude_rad = -atan(sqrt(max((frame.top_km - nearest) * (frame.top_km + nearest), 0.0)), nearest);
  row.turn_rad = row.altitude_rad - altitude; // a straight ray's altitude rises by it
  row.height_km = frame.top_km - frame.ground_km;
  row.view = sky_view_place(row.altitude_rad, sky_dip(row.height_km, frame), row.below, frame);
#else
  float share = row.below ? (horizon - row.seen_rad) / (horizon + quarter) : (row.seen_rad - horizon) / (quarter - horizon);
  share = clamp(share, 0.0, 1.0);
  row.view = sky_view_place(-dip, dip, row.below, frame);
  row.view.place = sqrt(share) * float(row.view.rows - 1);
  row.altitude_rad = (row.below ? dip - quarter : quarter + dip) * share - dip;
#endif
  row.path_share = sky_path_share(row.height_km, row.altitude_rad, row.below, frame);
  row.ground_share = vec4(0.0);
  row.ground_turn_rad = 0.0;
  if (row.below && block.albedo != vec4(0.0)) {
    float rise = (frame.ground_km + row.height_km) * sin(row.altitude_rad);
    float root = sqrt(max(rise * rise - row.height_km * (2.0 * frame.ground_km + row.height_km), 0.0));
    row.ground_turn_rad = -atan(root, (frame.ground_km + row.height_km) * cos(row.altitude_rad)) - row.altitude_rad;
    row.ground_share =
        block.albedo / pi *
        exp2(sky_ground_view_log2(transmittance, row.height_km, row.altitude_rad, transmittance_frame(), frame));
  }
  return row;
}

#if defined(OUTSIDE) && !defined(MANY_LIGHTS) && !defined(SMALL)
void share_row(Row row, SkyTableFrame frame) {
  SkyNodes views = sky_nodes(row.view.place, row.view.rows);
  for (int x = int(gl_LocalInvocationID.x); x < frame.lights * sky_azimuths; x += int(gl_WorkGroupSize.x)) {
    vec4 other = vec4(0.0);
    vec4 aerosol = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
      ivec3 texel = ivec3(x, row.view.first_row + sky_node(views, k, row.view.rows), frame.heights - 1);
      other += views.weights[k] * texelFetch(other_table, texel, 0);
      aerosol += views.weights[k] * texelFetch(aerosol_table, texel, 0);
    }
    other_row[x] = other;
    aerosol_row[x] = aerosol;
  }
}

// sky_table_log2 from the rows.
void row_log2(float light_altitude, float cos_azimuth, SkyTableFrame frame, out vec4 other, out vec4 aerosol) {
  SkyNodes lights = sky_nodes(sky_light_place(light_altitude, frame), frame.lights);
  other = vec4(0.0);
  aerosol = vec4(0.0);
  float all = 0.0;
  for (int k = 0; k < sky_azimuths; ++k) {
    float apart = cos_azimuth - cos(pi * float(k) / float(sky_azimuths - 1));
    float share = (k == 0 || k == sky_azimuths - 1 ? 0.5 : 1.0) / (abs(apart) < 1.0e-6 ? 1.0e-6 : apart);
    share = k % 2 == 0 ? share : -share;
    all += share;
    for (int l = 0; l < 4; ++l) {
      int x = k + sky_azimuths * sky_node(lights, l, frame.lights);
      other += share * lights.weights[l] * other_row[x];
      aerosol += share * lights.weights[l] * aerosol_row[x];
    }
  }
  other /= all;
  aerosol /= all;
}
#endif

#ifndef OUTSIDE
vec4 series_log2(int slice, float cos_azimuth) {
  vec4 sum = vec4(0.0);
  float before = cos_azimuth; // cos((m - 1) azimuth)
  float now = 1.0;
  for (int m = 0; m < sky_azimuths; ++m) {
    sum += now * series[slice][m];
    float next = 2.0 * cos_azimuth * now - before;
    before = now;
    now = next;
  }
  return sum;
}
#endif

void store(ivec2 at, int layer, vec4 light) {
  ivec2 texel = at + ivec2(0, layer * (block.map_rows_below + block.map_rows_above));
  vec4 value = log2(max(light, vec4(least_light)));
  imageStore(map, texel, block.share == 1.0 ? value : mix(imageLoad(map, texel), value, block.share));
}

void fill(ivec2 texel, Row row, SkyTableFrame frame) {
  vec3 level = vec3(sky_map_level(float(texel.x) / float(imageSize(map).x - 1)), 0.0);
  vec3 zenith = vec3(0.0, 0.0, 1.0);
  vec3 seen = cos(row.seen_rad) * level + sin(row.seen_rad) * zenith;
  vec3 up = cos(row.turn_rad) * zenith + sin(row.turn_rad) * level;
  vec3 forward = cos(row.turn_rad) * level - sin(row.turn_rad) * zenith;
  vec3 ground_up = cos(row.ground_turn_rad) * up + sin(row.ground_turn_rad) * forward;
  vec4 sum = vec4(0.0);
  for (int light = 0; light < block.light_count; ++light) {
    vec3 direction = block.lights[light].direction.xyz;
    float along = dot(direction, forward);
    float aside = dot(direction, cross(up, forward));
    float cos_azimuth = along * inversesqrt(max(along * along + aside * aside, 1.0e-20));
#ifdef OUTSIDE
    float light_altitude = sky_arc_sine(dot(direction, up));
    vec4 other;
    vec4 aerosol;
#ifdef SMALL
    small_sky_log2(row.height_km, row.altitude_rad, row.below, light_altitude, cos_azimuth, row.path_share, other, aerosol);
#elif defined(MANY_LIGHTS)
    other = sky_table_log2(other_table, row.height_km, row.view, light_altitude, cos_azimuth, frame);
    aerosol = sky_table_log2(aerosol_table, row.height_km, row.view, light_altitude, cos_azimuth, frame);
#else
    row_log2(light_altitude, cos_azimuth, frame, other, aerosol);
#endif
#else
    vec4 other = series_log2(2 * light, cos_azimuth);
    vec4 aerosol = series_log2(2 * light + 1, cos_azimuth);
#endif
    float steps = float(textureSize(phase, 0) - 1);
    float lobe_place = sky_phase_place(dot(seen, block.lights[light].apparent.xyz));
    float lobe = textureLod(phase, (min(lobe_place, 1.0) * steps + 0.5) / (steps + 1.0), 0.0).y;
    vec4 arriving = row.path_share * (exp2(other) + exp2(aerosol + lobe));
    vec2 nodes = vec2(textureSize(ground, 0));
    float light_place = sky_light_share(sky_arc_sine(dot(ground_up, direction)));
    vec2 at = (vec2(light_place * (nodes.x - 1.0), float(light)) + 0.5) / nodes;
    arriving += row.ground_share * textureLod(ground, at, 0.0);
    mat4 calibrated = block.lights[light].xyzs_from_sunlight;
    sum += calibrated * arriving;
    store(texel, 1 + light, calibrated * (row.path_share * exp2(aerosol)));
  }
  store(texel, 0, sum);
}

void main() {
  SkyTableFrame frame = table_frame();
  int number = int(gl_WorkGroupID.x);
  Row row = row_of(number, frame);
#ifdef OUTSIDE
#if !defined(MANY_LIGHTS) && !defined(SMALL)
  share_row(row, frame);
#endif
#else
  int slice = int(gl_LocalInvocationID.x) / sky_azimuths;
  int m = int(gl_LocalInvocationID.x) % sky_azimuths;
  if (slice < 2 * block.light_count) {
    series[slice][m] = sky_slice_between(slices, sky_azimuths * slice, row.view, m);
  }
#endif
  barrier();
  for (int column = int(gl_LocalInvocationID.x); column < imageSize(map).x; column += int(gl_WorkGroupSize.x)) {
    fill(ivec2(column, number), row, frame);
  }
}
