// What the passes share that follow rays from a light field's nodes: an invocation per direction (x), node (y) and block
// of four wavelengths (z).
layout(location = 3) uniform int zeniths; // of the directions
layout(location = 4) uniform int scatterers;
layout(location = 5) uniform float ground_km;
layout(location = 6) uniform float top_km;

struct LightRay {
  LightStep ground;
  int first_step;
  int steps;
  int meets_ground;
  float cos_zenith;
};

layout(std430, binding = 2) readonly buffer Rays { LightRay rays[]; }; // by height, zenith
layout(std430, binding = 3) readonly buffer Steps { LightStep steps[]; };
layout(std430, binding = 4) readonly buffer Weights { vec4 weights[]; }; // by step, scatterer
layout(std430, binding = 5) readonly buffer GroundWeights { vec4 ground_weights[]; };
layout(std430, binding = 6) readonly buffer Cosines { float light_cosines[]; }; // by angle

LightShell light_shell() { return LightShell(ground_km, top_km, angles); }

int ray_of(int node, int direction) { return node / angles * zeniths + direction / (directions / zeniths); }

LightPlace light_place(LightRay ray, int node, int direction) {
  float vertical = light_cosines[node % angles];
  float level = sqrt(max((1.0 - vertical) * (1.0 + vertical), 0.0)) *
                directions_from[node / angles * directions + direction].cos_azimuth;
  float sin_zenith = sqrt(max((1.0 - ray.cos_zenith) * (1.0 + ray.cos_zenith), 0.0));
  return LightPlace(vertical, level, ray.cos_zenith * vertical + sin_zenith * level);
}
