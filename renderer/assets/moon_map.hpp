// The Moon's surface as a cube map.
#pragma once

#include <vector>

namespace vesper {

/// Six faces stacked in OpenEXR's cube order (+X -X +Y -Y +Z -Z), row 0 on top; the cube's axes are the mean-Earth axes.
struct MoonMap {
  int face_size = 0;
  std::vector<float> texels; ///< four a texel: albedo, and the surface's unit normal in mean-Earth axes
};

} // namespace vesper
