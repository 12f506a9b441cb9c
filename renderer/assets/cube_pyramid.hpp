// A cube map at all its sizes, as a GPU reads it between texels, faces and sizes.
#pragma once

#include "vesper/base/vector.hpp"

#include <cstddef>
#include <vector>

namespace vesper {

/// Each size holds the same light: a texel is the mean of those that it covers, by the solid angle that it covers of
/// each.
class CubePyramid {
public:
  struct Level {
    int face_size = 0;         ///< texels along a face's side: floor(face_size / 2) of the level before, down to 1
    std::vector<float> texels; ///< 4 floats each, in the order of cube_texel (assets/cube_texels.hpp)
  };

  /// Throws Error(argument) for another number of texels than the size says.
  /// \param face_size >= 1 \param texels 4 floats each, in the order of cube_texel
  CubePyramid(int face_size, std::vector<float> texels);

  /// The map itself first.
  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }

  /// Trilinear, without seams between faces: what textureLod finds, OpenGL's rounding of weights apart.
  /// \param direction of any length but 0, in the cube's axes
  /// \param level 0 for the map itself, 1 for the next; clamped to those there are
  [[nodiscard]] Vec4 at(const Vec3& direction, double level) const;

private:
  std::vector<Level> levels_;
};

/// Solid angle of a part of a face, from its lower left corner to its upper right one, places as in cube_map.glsl, sr.
/// Exact.
[[nodiscard]] double cube_solid_angle_sr(const Vec2& low, const Vec2& high);

} // namespace vesper
