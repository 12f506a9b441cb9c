// Every file of shaders/lib in dependency order, for the C++ side (vesper/base/shader_math.hpp).
#include "vesper/shaders/lib/hash.glsl"
#include "vesper/shaders/lib/star_place.glsl"
#include "vesper/shaders/lib/projection.glsl"
#include "vesper/shaders/lib/star_psf.glsl"
#include "vesper/shaders/lib/refraction.glsl"
#include "vesper/shaders/lib/extinction.glsl"
#include "vesper/shaders/lib/phase.glsl"
#include "vesper/shaders/lib/sky_table.glsl"
#include "vesper/shaders/lib/small_sky.glsl"
#include "vesper/shaders/lib/scintillation.glsl"
#include "vesper/shaders/lib/eclipse.glsl"
#include "vesper/shaders/lib/display.glsl"

