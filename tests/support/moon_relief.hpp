// A Moon of formulas: plains and mountains that a map and an integral can both be made of.
#pragma once

#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/moon_map.hpp"
#include "vesper/base/vector.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace vesper::test {

struct SurfacePlace {
  double albedo;
  Vec3 normal;
};

/// Waves of albedo, a quarter of the mean, and of height, whose slopes are 4 degrees rms.
inline SurfacePlace waved_surface(const Vec3& at) {
  struct Wave {
    Vec3 vector;
    double phase;
  };
  static const std::array<Wave, 4> bright{
      {{{2.1, -1.3, 0.7}, 0.3}, {{-1.1, 3.0, 2.2}, 1.9}, {{5.0, 4.0, -3.0}, 4.0}, {{-7.0, 2.0, 9.0}, 2.2}}};
  static const std::array<Wave, 4> high{
      {{{23.0, -11.0, 8.0}, 0.7}, {{-9.0, 31.0, 14.0}, 2.0}, {{17.0, 13.0, -37.0}, 5.1}, {{41.0, -29.0, 5.0}, 3.3}}};
  double albedo = 1.0;
  for (const Wave& wave : bright) {
    albedo += 0.12 * std::sin(glm::dot(wave.vector, at) + wave.phase);
  }
  Vec3 slope(0.0);
  for (const Wave& wave : high) {
    slope += 0.05 / glm::length(wave.vector) * std::cos(glm::dot(wave.vector, at) + wave.phase) * wave.vector;
  }
  return {0.12 * albedo, glm::normalize(at - (slope - glm::dot(slope, at) * at))};
}

/// An even sphere.
inline SurfacePlace even_surface(const Vec3& at) { return {0.12, at}; }

/// A map of such a surface.
template <class Surface> MoonMap map_of(const Surface& surface, int face_size) {
  MoonMap map;
  map.face_size = face_size;
  for (std::size_t i = 0; i < cube_texel_count(face_size); ++i) {
    const SurfacePlace place = surface(cube_texel(face_size, i).direction);
    for (const double value : {place.albedo, place.normal.x, place.normal.y, place.normal.z}) {
      map.texels.push_back(static_cast<float>(value));
    }
  }
  return map;
}

} // namespace vesper::test
