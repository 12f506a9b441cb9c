// The texels of a cube map in memory, counted as its picture stands (shaders/lib/cube_map.glsl): row by row, face below
// face.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"

#include <cmath>
#include <cstddef>

namespace vesper {

[[nodiscard]] constexpr std::size_t cube_texel_count(int face_size) {
  return 6 * static_cast<std::size_t>(face_size) * static_cast<std::size_t>(face_size);
}

struct CubeTexel {
  Vec3 direction;        ///< of the centre, unit vector in the cube's axes
  double solid_angle_sr; ///< to second order in the texel's size; all sum to 4 pi within 0.6 / face_size^2 of it
};

/// \param index of the texel, below cube_texel_count
[[nodiscard]] inline CubeTexel cube_texel(int face_size, std::size_t index) {
  const auto n = static_cast<std::size_t>(face_size);
  const std::size_t row = index / n;
  const auto place = [&](std::size_t i) { return static_cast<double>(2 * i + 1) / static_cast<double>(n) - 1.0; };
  const Vec3 point = f64::cube_direction(static_cast<int>(row / n), {place(index % n), -place(row % n)});
  const double length = glm::length(point);
  const double side = 2.0 / static_cast<double>(n);
  return {point / length, side * side / (length * length * length)};
}

} // namespace vesper
