// What the light that was gathered amounts to: an invocation (x) for the moments, and one for each of aerosol's sources.
#include "light_blocks.glsl"
#include "prelude.glsl"
#include "lib/phase.glsl"
#include "lib/light_field.glsl"
#include "light_nodes.glsl"

layout(location = 3) uniform int source_nodes; // from the first on, those where aerosol counts

layout(std430, binding = 2) writeonly buffer Moments { LightSums moments[]; };     // by node
layout(std430, binding = 3) writeonly buffer Sources { vec4 sources[]; };          // by node, direction
layout(std430, binding = 4) readonly buffer PhaseMatrix { vec4 phase_matrix[]; }; // by height, toward, direction

void main() {
  int node = int(gl_GlobalInvocationID.y);
  int toward = int(gl_GlobalInvocationID.x) - 1;
  int first = node * directions;
  int height = node / angles;
  if (toward < 0) {
    LightSums sums = LightSums(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    for (int k = 0; k < directions; ++k) {
      add_light(radiances[(first + k) * blocks + block()], directions_from[height * directions + k], sums);
    }
    moments[node * blocks + block()] = sums;
    return;
  }
  int all = source_zeniths * source_azimuths;
  if (toward >= all || node >= source_nodes) {
    return;
  }
  vec4 source = vec4(0.0);
  int row = (height * all + toward) * directions;
  for (int k = 0; k < directions; ++k) {
    source += phase_matrix[(row + k) * blocks + block()] * radiances[(first + k) * blocks + block()];
  }
  sources[(node * all + toward) * blocks + block()] = source;
}
