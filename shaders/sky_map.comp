// The sky of a frame over azimuth and view, so that a pixel costs a look-up (Hillaire 2020, "A scalable and production
// ready sky and atmosphere rendering technique").
//
// Layer 0 holds all light but what aerosol scattered once, the ground's included; layer 1 and 2 that of one light each,
// over its phase function, which is too steep to be kept in a map. All are logarithms to base 2 of X, Y, Z and S: linear
// interpolation of them is better near the horizon and in dusk than that of the light itself. Columns: azimuth. Rows
// crowd at the horizon on both of its sides, the ground's first, each side from the horizon outwards.
// OUTSIDE is for an observer above the air: each ray enters it at a place with its own altitude of the light.
#include "prelude.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "sky_block.glsl"

layout(local_size_x = 64) in; // a group makes a row
layout(binding = 0, rgba32f) uniform image2DArray map;
layout(binding = 0) uniform sampler2D transmittance;
layout(binding = 1) uniform sampler1D ground;
#ifdef OUTSIDE
layout(binding = 2) uniform sampler3D other_table;
layout(binding = 3) uniform sampler3D aerosol_table;
#else
layout(binding = 2) uniform sampler2D slices; // side by side: first light's other and aerosol, second light's
#endif

const float least_light = 7.5e-37; // 2^-120

// A ray of the map, in the horizon frame.
struct Ray {
  SkyViewPlace view; // where it enters the air, or at the observer's place
  float height_km;
  float altitude_rad;
  vec3 up;      // there
  vec3 forward; // level, along the ray
};

Ray ray_of(int row, float azimuth, SkyTableFrame frame) {
  bool below = row < block.map_rows_below;
  int rows = imageSize(map).y;
  float share = below ? float(row) / float(block.map_rows_below - 1)
                      : float(row - block.map_rows_below) / float(rows - block.map_rows_below - 1);
  float dip = sky_dip(block.height_km, frame);
  vec3 level = vec3(sin(azimuth), cos(azimuth), 0.0);
  vec3 zenith = vec3(0.0, 0.0, 1.0);
  Ray ray = Ray(sky_view_place(-dip, dip, below, frame), block.height_km, 0.0, zenith, level);
#ifdef OUTSIDE
  float range = below ? dip - 0.5 * sky_half_turn : dip - sky_limb_dip(block.height_km, frame);
  float altitude = range * share * share - dip;
  // The ray's altitude rises on its way by the angle between the verticals.
  float radius = block.ground_km + block.height_km;
  float nearest = radius * cos(altitude);
  ray.altitude_rad = -atan(sqrt(max((frame.top_km - nearest) * (frame.top_km + nearest), 0.0)), nearest);
  float turn = ray.altitude_rad - altitude;
  ray.up = cos(turn) * zenith + sin(turn) * level;
  ray.forward = cos(turn) * level - sin(turn) * zenith;
  ray.height_km = frame.top_km - frame.ground_km;
  ray.view = sky_view_place(ray.altitude_rad, sky_dip(ray.height_km, frame), below, frame);
#else
  ray.view.place = share * float(ray.view.rows - 1);
  ray.altitude_rad = (below ? dip - 0.5 * sky_half_turn : 0.5 * sky_half_turn + dip) * share * share - dip;
#endif
  return ray;
}

// Luminance of the ground through the air, under 1 lux of sunlight from the light's direction.
vec4 ground_light(Ray ray, int light, SkyTableFrame frame) {
  float h = ray.height_km;
  float rise = (frame.ground_km + h) * sin(ray.altitude_rad);
  float above = h * (2.0 * frame.ground_km + h);
  float distance_km = above / max(sqrt(max(rise * rise - above, 0.0)) - rise, 1.0e-3);
  vec3 at = (frame.ground_km + h) * ray.up +
            distance_km * (cos(ray.altitude_rad) * ray.forward + sin(ray.altitude_rad) * ray.up);
  float light_altitude = asin(clamp(dot(normalize(at), block.lights[light].direction.xyz), -1.0, 1.0));
  vec4 lux = sky_ground_illuminance(ground, transmittance, block.sunlight, light_altitude,
                                    block.lights[light].direction.w, transmittance_frame(), frame);
  return block.albedo / sky_half_turn * lux *
         exp2(sky_ground_view_log2(transmittance, h, ray.altitude_rad, transmittance_frame(), frame));
}

void store(ivec3 texel, vec4 light) {
  vec4 value = log2(max(light, vec4(least_light)));
  imageStore(map, texel, block.share == 1.0 ? value : mix(imageLoad(map, texel), value, block.share));
}

#ifndef OUTSIDE
// The cosine series over the azimuth that a row has of each slice.
shared vec4 series[2 * sky_most_lights][sky_azimuths];

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

void fill(ivec2 texel, SkyTableFrame frame) {
  Ray ray = ray_of(texel.y, 2.0 * sky_half_turn * (float(texel.x) + 0.5) / float(imageSize(map).x), frame);
  float path_share = sky_path_share(ray.height_km, ray.altitude_rad, ray.view.meets_ground, frame);
  vec4 sum = vec4(0.0);
  for (int light = 0; light < block.light_count; ++light) {
    vec3 direction = block.lights[light].direction.xyz;
    float along = dot(direction, ray.forward);
    float aside = dot(direction, cross(ray.up, ray.forward));
    float cos_azimuth = along * inversesqrt(max(along * along + aside * aside, 1.0e-20));
#ifdef OUTSIDE
    float light_altitude = asin(clamp(dot(direction, ray.up), -1.0, 1.0));
    vec4 other = sky_table_log2(other_table, ray.height_km, ray.view, light_altitude, cos_azimuth, frame);
    vec4 aerosol = sky_table_log2(aerosol_table, ray.height_km, ray.view, light_altitude, cos_azimuth, frame);
#else
    vec4 other = series_log2(2 * light, cos_azimuth);
    vec4 aerosol = series_log2(2 * light + 1, cos_azimuth);
#endif
    vec4 seen = path_share * exp2(other);
    if (ray.view.meets_ground && block.albedo != vec4(0.0)) {
      seen += ground_light(ray, light, frame);
    }
    mat4 calibrated = block.lights[light].xyzs_from_sunlight;
    sum += calibrated * seen;
    store(ivec3(texel, 1 + light), calibrated * (path_share * exp2(aerosol)));
  }
  store(ivec3(texel, 0), sum);
}

void main() {
  SkyTableFrame frame = table_frame();
  int row = int(gl_WorkGroupID.x);
#ifndef OUTSIDE
  int slice = int(gl_LocalInvocationID.x) / sky_azimuths;
  int m = int(gl_LocalInvocationID.x) % sky_azimuths;
  if (slice < 2 * block.light_count) {
    series[slice][m] = sky_slice_between(slices, sky_azimuths * slice, ray_of(row, 0.0, frame).view, m);
  }
  barrier();
#endif
  for (int column = int(gl_LocalInvocationID.x); column < imageSize(map).x; column += int(gl_WorkGroupSize.x)) {
    fill(ivec2(column, row), frame);
  }
}
