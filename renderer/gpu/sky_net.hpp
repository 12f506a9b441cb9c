// Changes of a frame's sky map that are given on a coarser net over its columns and rows.
#pragma once

#include "vesper/gpu/objects.hpp"

namespace vesper::gpu {

/// Sizes of a layer of the sky's map, or of a net over it.
struct SkyMapSize {
  int columns; ///< the last is the first again
  int rows_below, rows_above;
};

/// Its layers stand below one another; interpolated.
struct SkyNet {
  const Texture& texels;
  int rows_below, rows_above;
};

/// Runs a stage that includes shaders/sky_net.glsl over all texels of a layer.
void run_over_map(const ProgramHandle& program, const Texture& map, const SkyMapSize& size, const SkyNet& net);

} // namespace vesper::gpu
