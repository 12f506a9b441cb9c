// Tables of light that hold all blocks of four wavelengths together: an invocation reads those of its own block (z).
// Comes before the prelude.
layout(location = 0) uniform int blocks;
int block() { return int(gl_GlobalInvocationID.z); }
#define LIGHT_TEXEL(i) ((i) * blocks + block())
