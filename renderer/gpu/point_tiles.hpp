// Where a picture has points of light.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace vesper::gpu {

/// The tiles of a picture, 16 x 4 pixels, in which points of light may be: so that what reads points reads them there
/// only, and all else goes by without them.
class PointTiles {
public:
  /// Pixels of the picture: low x, low y, high x, high y, high excluded. Whole numbers of 0 or more.
  using Box = std::array<float, 4>;

  /// The library must outlive this.
  explicit PointTiles(const ShaderLibrary& library);

  /// Begins a picture: no tile has points.
  void start(int width, int height);

  /// Marks the tiles that boxes touch; empty boxes touch none.
  void mark(std::span<const Box> boxes);
  /// Likewise for boxes in a buffer, `stride` of their own sizes apart.
  void mark(const Buffer& buffer, std::size_t count, std::size_t first, std::size_t stride);

  /// Lists a strip's tiles, for dispatch().
  void list(const Strip& strip);

  /// Runs the current program, which has shaders/listed_tile.glsl, over the tiles of the listed strip that have points,
  /// or over those that have none.
  void dispatch(bool with_points) const;

private:
  ProgramHandle mark_;
  ProgramHandle list_;
  Buffer marks_;
  Buffer lists_;
  int columns_ = 0;
  int rows_ = 0;
};

} // namespace vesper::gpu
