// A cube map at all its sizes, as a GPU reads it between texels, faces and sizes.
#pragma once

#include "vesper/base/vector.hpp"

#include <cstddef>
#include <vector>

namespace vesper {

/// Read between its texels, each size holds the same light, and what is even stays even: a texel of one size gives its
/// light to those of the next in the shares by which they are mixed at its middle.
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

} // namespace vesper
