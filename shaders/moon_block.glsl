// What all pixels of the Moon share; the C++ twin is MoonBlock in renderer/gpu/moon_pass.cpp.
layout(std140, binding = 1) uniform MoonBlock {
  mat3 fixed_from_disc; // mean-Earth axes from those of places on the disc
  MoonLighting lighting;
} moon;
