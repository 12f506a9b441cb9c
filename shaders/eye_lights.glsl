// The far lights: the cells of the picture and, after them, unseen sources.
struct EyeLight {
  vec4 light;       // lux, X, Y, Z and S
  vec4 direction;   // unit vector in view axes; softness in degrees
  vec4 solid_angle; // sr
};
layout(std430, binding = 0) buffer EyeLights {
  vec4 beyond; // luminance that the sphere is taken to have past the picture
  EyeLight lights[];
};
