// Hillaire's tier: sources along a view as the large tables hold them, found by a march along the ray. The C++ twin of
// the block is SmallSkyBlock in renderer/gpu/sky_textures.cpp.
layout(std140, binding = 2) uniform SmallSkyBlock {
  mat4 responses; // X, Y, Z, S from the four wavelengths
  float ground_km; // SmallSkyFrame
  float top_km;
  float light_radius_rad;
  float depolarization;
  int levels;
  int multiple_nodes;
  int steps;
  int transmittance_altitudes; // SkyTransmittanceFrame
  int transmittance_heights;
} small_block;

layout(binding = 5) uniform sampler2D small_air;
layout(binding = 6) uniform sampler2D small_transmittance;
layout(binding = 7) uniform sampler2D small_multiple;

// Logarithms to base 2 of the mean sources of a view.
void small_sky_log2(float height_km, float altitude_rad, bool below, float light_altitude_rad, float cos_azimuth,
                    float path_share, out vec4 other, out vec4 aerosol) {
  SmallSkyFrame frame =
      SmallSkyFrame(small_block.ground_km, small_block.top_km, small_block.light_radius_rad, small_block.depolarization,
                    small_block.levels, small_block.multiple_nodes, small_block.steps);
  SkyTransmittanceFrame nodes =
      SkyTransmittanceFrame(small_block.transmittance_altitudes, small_block.transmittance_heights);
  SmallSkyRay ray = small_sky_ray(height_km, sin(altitude_rad), below, frame);
  float sin_light = sin(light_altitude_rad);
  float cos_angle = ray.sin_altitude * sin_light + cos(altitude_rad) * cos(light_altitude_rad) * cos_azimuth;
  SmallSkyLight light = small_sky_radiance(ray, sin_light, cos_angle, small_air, small_transmittance, small_multiple,
                                           nodes, frame);
  const float darkest = 7.9e-31; // 2^-100
  float share = max(path_share, 1.0e-20);
  other = log2(max(small_block.responses * light.other / share, vec4(darkest)));
  aerosol = log2(max(small_block.responses * light.aerosol / share, vec4(darkest)));
}
