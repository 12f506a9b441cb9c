// Dims the map of a frame's sky (sky_map.comp) by what an eclipse of the Sun leaves of it: layer 0 of all light, layer 1 of
// what aerosol scatters once of the first light, the Sun's. All are logarithms.
#include "prelude.glsl"
#include "sky_net.glsl"

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (!is_in_layer(texel)) {
    return;
  }
  for (int layer = 0; layer < 2; ++layer) {
    ivec2 at = in_layer(texel, layer);
    imageStore(map, at, imageLoad(map, at) + net_at(texel, layer));
  }
}
