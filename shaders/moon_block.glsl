// What all pixels of the Moon share; the C++ twin is MoonBlock in renderer/gpu/moon_pass.cpp.
layout(std140, binding = 1) uniform MoonBlock {
  mat3 fixed_from_disc; // mean-Earth axes from those of places on the disc
  MoonLighting lighting;
  vec4 from_earth_km; // the Moon's centre, from the Earth's; w: the Moon's radius
  EarthShadow shadow;
  LunarEclipseFrame eclipse;
  float map_level;      // of the map's mipmaps
  float crescent_cells; // a radian of the sphere, in which a crescent's sunlight is added up
} moon;
