// Adds light to the map of a frame's sky (sky_map.comp), whose layer 0 holds logarithms of all light.
#include "prelude.glsl"
#include "sky_net.glsl"

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (is_in_layer(texel)) {
    imageStore(map, texel, log2(exp2(imageLoad(map, texel)) + net_at(texel, 0)));
  }
}
