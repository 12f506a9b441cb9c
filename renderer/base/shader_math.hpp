// shaders/lib compiled as C++: `vesper::f32` computes as the GPU does, `vesper::f64` is the reference.
//
// The GLSL side of the contract is shaders/prelude.glsl; the rules for lib files stand there.
#pragma once

#include "vesper/base/lanes.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <numbers>
#include <type_traits>

#define CONSTANT inline constexpr
#define FN inline
#define OUT(T) T&
#define INOUT(T) T&

namespace vesper::f32 {
using Real = float;
#include "vesper/base/shader_math_types.inl"
#include "vesper/shaders/lib/all.inl"
} // namespace vesper::f32

namespace vesper::f64 {
using Real = double;
#include "vesper/base/shader_math_types.inl" // NOLINT(readability-duplicate-include)
#include "vesper/shaders/lib/all.inl"        // NOLINT(readability-duplicate-include)
} // namespace vesper::f64

#undef CONSTANT
#undef FN
#undef OUT
#undef INOUT
