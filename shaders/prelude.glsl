// The GLSL prelude of shaders/lib; renderer/base/shader_math.hpp is its C++ twin.
//
// Rules for files in lib, so that both compilers accept them:
// - constants, structs and pure functions only; no uniforms, no stage variables; textures are parameters
// - constants start with CONSTANT, functions with FN; output parameters are written OUT(vec3) name
// - literals are written Real(2.0), integers are converted explicitly, no swizzles (vec2(v), v.x)
// - no includes: a stage, and all.inl for C++, name the files in dependency order
// - Light is light at four wavelengths; a LightTable holds Lights by number (fetch_light), a RealTable numbers
//   (fetch_real)
// - PReal, PVec and PMat hold places on the sphere, where a float would cost 0.03 arcsec
#define Real float
#define PReal double
#define PVec2 dvec2
#define PVec3 dvec3
#define PMat3 dmat3
#define CONSTANT const
#define FN
#define OUT(T) out T
#define INOUT(T) inout T
#define Light vec4
#define LightTable samplerBuffer
#define RealTable samplerBuffer
#ifndef LIGHT_TEXEL
#define LIGHT_TEXEL(i) (i)
#endif
#define fetch_light(table, i) texelFetch(table, LIGHT_TEXEL(i))
#define fetch_real(table, i) texelFetch(table, i).x
CONSTANT Real pi = 3.141592653589793;
