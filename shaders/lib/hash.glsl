// Random numbers as a pure function of their keys.

// PCG output permutation of one step (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering").
FN uint hash_uint(uint key) {
  uint state = key * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

FN uint hash_pair(uint a, uint b) { return hash_uint(a ^ hash_uint(b)); }

// Uniform in [0, 1), 24 bits.
FN Real hash_unit(uint key) { return Real(key >> 8u) * Real(5.9604644775390625e-8); }
