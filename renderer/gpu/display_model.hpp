// The display that a picture is mapped for, and who looks at it.
#pragma once

#include "vesper/base/units.hpp"

namespace vesper::gpu {

/// What a display shows and how it is seen. The default is a desktop monitor in a dim room.
struct Display {
  Luminance peak = 100.0 * candela_per_m2;  ///< of white
  Luminance black = 0.1 * candela_per_m2;   ///< of code value 0
  Luminance ambient = 0.0 * candela_per_m2; ///< of the room's light that it reflects
  double pixels_per_degree = 40.0;          ///< as the viewer sees them
};

} // namespace vesper::gpu
