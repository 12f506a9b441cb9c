// The C++ prelude of shaders/lib, included once per precision by shader_math.hpp.
using vec2 = glm::vec<2, Real>;
using vec3 = glm::vec<3, Real>;
using vec4 = glm::vec<4, Real>;
using ivec2 = glm::ivec2;
using ivec3 = glm::ivec3;
using mat3 = glm::mat<3, 3, Real>;
using mat4 = glm::mat<4, 4, Real>;
using uint = unsigned int;
/// Light at four wavelengths.
using Light = std::conditional_t<std::is_same_v<Real, float>, Lanes, vec4>;
using PReal = Real;
using PVec2 = vec2;
using PVec3 = vec3;
using PMat3 = mat3;
CONSTANT Real pi = std::numbers::pi_v<Real>;

using glm::abs;
using glm::acos;
using glm::asin;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::exp2;
using glm::floor;
using glm::fract;
using glm::inverse;
using glm::inversesqrt;
using glm::length;
using glm::log;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::mod;
using glm::normalize;
using glm::pow;
using glm::sign;
using glm::sin;
using glm::smoothstep;
using glm::sqrt;
using glm::step;
using glm::tan;
using glm::transpose;

/// A one-dimensional texture of RGBA texels in memory.
struct sampler1D { // NOLINT(readability-identifier-naming)
  const vec4* texels = nullptr;
  int width = 0;
};
inline vec4 texelFetch(sampler1D texture, int texel, int /*level*/) { // NOLINT(readability-identifier-naming)
  return texel >= 0 && texel < texture.width ? texture.texels[texel] : vec4(Real(0));
}

/// A two-dimensional one, row by row.
struct sampler2D { // NOLINT(readability-identifier-naming)
  const vec4* texels = nullptr;
  int width = 0;
  int height = 0;
};
inline vec4 texelFetch(sampler2D texture, ivec2 texel, int /*level*/) { // NOLINT(readability-identifier-naming)
  return texel.x >= 0 && texel.x < texture.width && texel.y >= 0 && texel.y < texture.height
             ? texture.texels[texel.y * texture.width + texel.x]
             : vec4(Real(0));
}

/// A three-dimensional one, layer by layer.
struct sampler3D { // NOLINT(readability-identifier-naming)
  const vec4* texels = nullptr;
  int width = 0;
  int height = 0;
  int depth = 0;
};
inline vec4 texelFetch(sampler3D texture, ivec3 texel, int /*level*/) { // NOLINT(readability-identifier-naming)
  const bool inside = texel.x >= 0 && texel.x < texture.width && texel.y >= 0 && texel.y < texture.height &&
                      texel.z >= 0 && texel.z < texture.depth;
  const auto row = static_cast<std::ptrdiff_t>(texel.z) * texture.height + texel.y;
  return inside ? texture.texels[row * texture.width + texel.x] : vec4(Real(0));
}

/// Lights in memory, `stride` apart: tables of more wavelengths than four hold a place's together.
struct LightTable {
  const Light* lights = nullptr;
  std::ptrdiff_t stride = 1;
};
inline Light fetch_light(LightTable table, int i) { return table.lights[i * table.stride]; }

struct RealTable {
  const Real* numbers = nullptr;
};
inline Real fetch_real(RealTable table, int i) { return table.numbers[i]; }
