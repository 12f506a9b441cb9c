// What the stages of the sky share; the C++ twin is SkyBlock in renderer/gpu/sky_map.cpp.
const int sky_most_lights = 2;

struct SkyBlockLight {
  mat4 xyzs_from_sunlight;
  vec4 direction; // without refraction, horizon frame; w: angular radius
  vec4 apparent;  // where its disc is seen
};

layout(std140, binding = 1) uniform SkyBlock {
  SkyBlockLight lights[sky_most_lights];
  vec4 sunlight;   // X, Y, Z, S of 1 lux, which the tables are made for
  vec4 albedo;     // of the ground; zero where no ground is drawn
  float ground_km; // SkyTableFrame
  float top_km;
  int heights;
  int views_below;
  int views_above;
  int table_lights;
  int transmittance_altitudes; // SkyTransmittanceFrame
  int transmittance_heights;
  float height_km;    // of the observer
  int light_count;
  float share;        // of these tables in the map; the rest stays as it is
  int map_rows_below; // rows of each layer of the map that meet the ground, and the others
  int map_rows_above;
  float sin_horizon;  // of the altitudes, as they are seen, of the horizon and of where the map ends
  float sin_highest;
  vec4 map_half_sines; // SkyMapFrame
} block;

SkyTableFrame table_frame() {
  return SkyTableFrame(block.ground_km, block.top_km, block.heights, block.views_below, block.views_above,
                       block.table_lights);
}

SkyTransmittanceFrame transmittance_frame() {
  return SkyTransmittanceFrame(block.transmittance_altitudes, block.transmittance_heights);
}

SkyMapFrame map_frame() {
  return SkyMapFrame(block.map_half_sines.x, block.map_half_sines.y, block.map_half_sines.z);
}
