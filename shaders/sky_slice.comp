// What a frame needs of a table of the sky's light: an observer's height and an altitude of the light are fixed in it.
// SMALL makes it without a large table.
#include "prelude.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#include "sky_block.glsl"
#ifdef SMALL
#include "lib/phase.glsl"
#include "lib/small_sky.glsl"
#include "small_sky_block.glsl"
#endif

layout(local_size_x = sky_azimuths, local_size_y = 8) in;
#ifndef SMALL
layout(binding = 0) uniform sampler3D table;
#endif
layout(binding = 0, rgba32f) uniform writeonly image2D slices; // side by side
layout(location = 0) uniform int light;
layout(location = 1) uniform int slice;

// The row's nodes over the azimuth, gathered once for all numbers of the series.
shared vec4 nodes[8][sky_azimuths];

void main() {
  SkyTableFrame frame = table_frame();
  int row = int(gl_GlobalInvocationID.y);
  int m = int(gl_LocalInvocationID.x);
  bool inside = row < frame.views_below + frame.views_above;
  if (inside) {
    float altitude = sky_arc_sine(block.lights[light].direction.z);
#ifdef SMALL
    float dip = sky_dip(block.height_km, frame);
    float view = sky_node_altitude_rad(row, dip, frame);
    bool below = row < frame.views_below;
    vec4 other;
    vec4 aerosol;
    small_sky_log2(block.height_km, view, below, altitude, cos(pi * float(m) / float(sky_azimuths - 1)),
                   sky_path_share(block.height_km, view, below, frame), other, aerosol);
    nodes[gl_LocalInvocationID.y][m] = slice % 2 == 0 ? other : aerosol;
#else
    nodes[gl_LocalInvocationID.y][m] =
        sky_table_between(table, sky_nodes(sky_height_place(block.height_km, frame), frame.heights),
                          sky_nodes(sky_light_place(altitude, frame), frame.lights), row, m, frame);
#endif
  }
  barrier();
  if (inside) {
    vec4 sum = vec4(0.0);
    for (int k = 0; k < sky_azimuths; ++k) {
      sum += sky_series_weight(m, k) * nodes[gl_LocalInvocationID.y][k];
    }
    imageStore(slices, ivec2(sky_azimuths * slice + m, row), sum);
  }
}
