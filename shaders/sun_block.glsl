// What all pixels of the Sun share; the C++ twin is SunBlock in renderer/gpu/sun_pass.cpp.
layout(std140, binding = 1) uniform SunBlock {
  SunShading shading;
  vec4 moon; // along the disc's axes; w: distance of its limb on the unit sphere, 0 where it hides nothing
  vec4 turn; // rows of the matrix from places on the disc to those of shading
} sun;
