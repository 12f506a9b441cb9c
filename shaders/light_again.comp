// A later order of a light field: what was scattered or reflected before, once more toward the nodes.
#include "light_blocks.glsl"
#include "prelude.glsl"
#include "lib/phase.glsl"
#include "lib/light_field.glsl"
#include "light_nodes.glsl"
#include "light_rays.glsl"

layout(binding = 0) uniform samplerBuffer places;
layout(binding = 2) uniform samplerBuffer field;
layout(binding = 3) uniform samplerBuffer sources;
layout(binding = 4) uniform samplerBuffer ground;

layout(std430, binding = 7) readonly buffer SecondMoments { vec4 second_moments[]; };

void main() {
  int direction = int(gl_GlobalInvocationID.x);
  int node = int(gl_GlobalInvocationID.y);
  if (direction >= directions) {
    return;
  }
  LightRay ray = rays[ray_of(node, direction)];
  LightPlace light = light_place(ray, node, direction);
  LightShell shell = light_shell();
  vec4 second_moment = second_moments[block()];
  vec4 radiance = vec4(0.0);
  for (int i = ray.first_step; i < ray.first_step + ray.steps; ++i) {
    FieldPlace place = field_place(steps[i], light_cosine(steps[i], light), light, shell, places);
    int weight = i * scatterers * blocks + block();
    radiance += weights[weight] * scattered_by_molecules(place, second_moment, field, shell.angles);
    if (place.source >= 0) {
      vec4 aerosol = vec4(0.0);
      for (int s = 1; s < scatterers; ++s) {
        aerosol += weights[weight + s * blocks];
      }
      radiance += aerosol * scattered_by_aerosol(place, sources, shell.angles);
    }
  }
  if (ray.meets_ground != 0) {
    radiance += ground_weights[ray_of(node, direction) * blocks + block()] *
                ground_light(light_cosine(ray.ground, light), ground, places, shell.angles);
  }
  radiances[(node * directions + direction) * blocks + block()] = radiance;
}
