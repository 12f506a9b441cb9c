// The first order of a light field: the light itself, scattered or reflected toward the nodes.
#include "light_blocks.glsl"
#include "prelude.glsl"
#include "lib/phase.glsl"
#include "lib/light_field.glsl"
#include "light_nodes.glsl"
#include "light_rays.glsl"

const int most_scatterers = 8;

layout(location = 7) uniform float light_radius_rad;
layout(location = 8) uniform int kinds[most_scatterers]; // of phase functions
layout(binding = 1) uniform samplerBuffer depths;

layout(std430, binding = 7) readonly buffer Parameters { vec4 parameters[]; }; // of phase functions, by scatterer

float phase_function(int kind, float cos_angle, float parameter) {
  switch (kind) {
  case 0:
    return rayleigh_phase(cos_angle, parameter);
  case 1:
    return henyey_greenstein_phase(cos_angle, parameter);
  case 2:
    return cornette_shanks_phase(cos_angle, parameter);
  default:
    return schlick_phase(cos_angle, parameter);
  }
}

void main() {
  int direction = int(gl_GlobalInvocationID.x);
  int node = int(gl_GlobalInvocationID.y);
  if (direction >= directions) {
    return;
  }
  LightRay ray = rays[ray_of(node, direction)];
  LightPlace light = light_place(ray, node, direction);
  LightShell shell = light_shell();
  vec4 phase[most_scatterers];
  for (int s = 0; s < scatterers; ++s) {
    vec4 parameter = parameters[s * blocks + block()];
    for (int i = 0; i < 4; ++i) {
      phase[s][i] = phase_function(kinds[s], light.cos_angle, parameter[i]);
    }
  }
  vec4 radiance = vec4(0.0);
  for (int i = ray.first_step; i < ray.first_step + ray.steps; ++i) {
    float cosine = light_cosine(steps[i], light);
    float visible = visible_light(cosine, steps[i].height_km, shell.ground_km, light_radius_rad);
    if (visible <= 0.0) {
      continue;
    }
    vec4 arriving = visible * light_transmittance(depth_place(steps[i], cosine, shell), depths);
    for (int s = 0; s < scatterers; ++s) {
      radiance += phase[s] * weights[(i * scatterers + s) * blocks + block()] * arriving;
    }
  }
  if (ray.meets_ground != 0) {
    float cosine = light_cosine(ray.ground, light);
    float visible = max(0.0, cosine) * visible_light(cosine, 0.0, shell.ground_km, light_radius_rad);
    if (visible > 0.0) {
      radiance += visible * ground_weights[ray_of(node, direction) * blocks + block()] *
                  light_transmittance(depth_place(ray.ground, cosine, shell), depths);
    }
  }
  radiances[(node * directions + direction) * blocks + block()] = radiance;
}
