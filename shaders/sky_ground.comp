// Illuminance of the ground under each light of a frame, over the light's altitude there: sky_light_share. Under 1 lux of
// sunlight above the air, X, Y, Z and S.
#include "prelude.glsl"
#include "lib/refraction.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_map.glsl"
#include "sky_block.glsl"

layout(local_size_x = 64) in;
layout(binding = 0, rgba32f) uniform writeonly image2D illuminance;
layout(binding = 0) uniform sampler2D transmittance;
layout(binding = 1) uniform sampler1D ground;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  float altitude = sky_light_rad(float(texel.x) / float(imageSize(illuminance).x - 1));
  imageStore(illuminance, texel,
             sky_ground_illuminance(ground, transmittance, block.sunlight, altitude,
                                    block.lights[texel.y].direction.w, transmittance_frame(), table_frame()));
}
