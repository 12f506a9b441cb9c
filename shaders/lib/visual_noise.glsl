// The grain that an eye sees in the dark, as a pure function of direction, time and seed: frames may be drawn in any
// order. Its strength is vision.glsl's.
//
// Grains have the size over which rods pool light and last as long as they do, so that it looks the same in pictures of
// any size: a lattice on the sphere, or, where pixels are larger than grains, an independent value for each pixel that is
// weaker as more grains average out in it.

CONSTANT Real grain_deg = Real(0.2);     // across a grain of the lattice
CONSTANT Real grain_seconds = Real(0.1); // rods sum light over this time (Barlow 1958)
// Root of the power of the lattice's noise at low frequencies over that of white noise in squares of its cells:
// (integral of a node's weight along an axis) = sqrt(2) asinh(1), for lattices along the picture.
CONSTANT Real grain_power = Real(1.2465);

// Uniform, mean 0, variance 1.
FN Real grain_value(uint key) { return Real(3.4641016151377544) * (hash_unit(key) - Real(0.5)); }

// Mean 0 and variance 1 everywhere; place in cells of the lattice.
FN Real lattice_noise(vec3 place, uint key) {
  vec3 low = floor(place);
  vec3 f = place - low;
  Real sum = Real(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    vec3 at = vec3(Real(corner % 2), Real(corner / 2 % 2), Real(corner / 4));
    vec3 weight = vec3(Real(1.0), Real(1.0), Real(1.0)) - abs(at - f);
    vec3 node = low + at;
    uint hashed = hash_pair(uint(int(node.x)), hash_pair(uint(int(node.y)), hash_pair(uint(int(node.z)), key)));
    sum += weight.x * weight.y * weight.z * grain_value(hashed);
  }
  vec3 g = vec3(Real(1.0), Real(1.0), Real(1.0)) - f;
  return sum * inversesqrt((f.x * f.x + g.x * g.x) * (f.y * f.y + g.y * g.y) * (f.z * f.z + g.z * g.z));
}

// direction: unit vector of the pixel in any axes that do not move against the sky; column, row: of the pixel;
// degrees_per_pixel: as seen. Mean 0; variance 1 where pixels are smaller than grains.
FN Real visual_noise(vec3 direction, int column, int row, Real degrees_per_pixel, Real seconds, uint seed) {
  Real moments = seconds / grain_seconds;
  Real moment = floor(moments);
  Real f = moments - moment;
  Real g = Real(1.0) - f;
  uint now = hash_pair(uint(int(moment)), seed);
  uint next = hash_pair(uint(int(moment) + 1), seed);
  Real both = inversesqrt(f * f + g * g);
  if (degrees_per_pixel > grain_deg) {
    uint pixel = hash_pair(uint(column), uint(row));
    return both * grain_power * grain_deg / degrees_per_pixel *
           (g * grain_value(hash_pair(pixel, now)) + f * grain_value(hash_pair(pixel, next)));
  }
  vec3 place = direction * (Real(180.0) / (pi * grain_deg));
  return both * (g * lattice_noise(place, now) + f * lattice_noise(place, next));
}
