// From a cosine to its sine.
#pragma once

#include <algorithm>
#include <cmath>

namespace vesper {

/// The sine of an angle from 0 to 180 degrees by its cosine, or the cosine of one from -90 to 90 by its sine: without
/// loss near +-1. Rounding beyond +-1 counts as +-1.
inline double sine_of(double cosine) { return std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine))); }

} // namespace vesper
