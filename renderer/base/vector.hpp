// Double-precision vectors and matrices of the CPU side.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace vesper {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
/// Column-major; `Mat3 * Vec3` transforms a column vector. Names read right to left: `horizon_from_icrs`.
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

} // namespace vesper
