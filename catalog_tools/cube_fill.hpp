// Holes of a cube map filled from their surroundings.
#pragma once

#include "vesper/catalog_tools/cube_sum.hpp"
#include "vesper/catalog_tools/panorama_resampling.hpp"

namespace vesper {

struct CubeFillReport {
  LightTotal filled;     ///< light and solid angle that holes and partly covered texels gained
  LightTotal overlapped; ///< light and solid angle that came twice, where a picture covers a place more than once
  double dark_sr = 0.0;  ///< solid angle of what was left dark
  std::size_t holes = 0; ///< filled ones that touch each other count as one
};

/// Makes of sums a whole map: each texel's light over its solid angle becomes its mean brightness times the texel's own
/// solid angle. Texels without light take the brightness around them, smoothly, if their hole (texels that touch by
/// their sides) is not larger than `largest_hole_sr`; others stay dark, and what the texels at their border hold is not
/// completed.
CubeFillReport fill_cube(CubeSum& cube, double largest_hole_sr);

/// Smooths what is fainter than `faint`, for pictures whose few bits leave contours and coloured grains there: a texel
/// takes the mean over the wider surroundings, up to 32 texels, the fainter these are. Moves light by that much, and
/// changes its sum by less than a percent of what is faint.
///
/// \param y_of_channels weights whose sum over channels is the brightness that `faint` means
void soften_faint(CubeSum& cube, const Vec3& y_of_channels, double faint);

} // namespace vesper
