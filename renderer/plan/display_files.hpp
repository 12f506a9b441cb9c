// What picture files say of the display that their numbers are for.
#pragma once

#include "vesper/assets/image_file.hpp"
#include "vesper/plan/display.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace vesper {

/// The colour tags of a PNG for the display: none for sRGB, else a profile; for transfers of ITU-T H.273 also its code
/// points (cICP), and for PQ the display's gamut and luminance (mDCV).
[[nodiscard]] ColorTags color_tags(const Display& display);

/// What an EXR of display_signals() holds.
[[nodiscard]] LinearColors linear_colors(const Display& display);

/// Linear R, G, B, 3 a pixel, of 1 at the display's white, that code values of 16 bits (4 a pixel) stand for.
[[nodiscard]] std::vector<float> display_signals(std::span<const std::uint16_t> rgba, const Display& display);

} // namespace vesper
