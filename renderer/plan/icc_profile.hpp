// ICC profiles of displays.
#pragma once

#include "vesper/base/files.hpp"
#include "vesper/plan/display.hpp"

namespace vesper {

/// An ICC profile (ICC.1:2010, version 4.3) with the display's primaries and transfer, adapted to D50 as the format
/// asks (Bradford), and its luminance. It says nothing of black and ambient light. As PQ codes are absolute and ICC
/// components are not, its white is then the display's.
[[nodiscard]] Bytes icc_profile(const Display& display);

} // namespace vesper
