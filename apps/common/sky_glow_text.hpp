// Artificial sky glow as people give it.
#pragma once

#include "vesper/base/units.hpp"

#include <optional>
#include <string_view>

namespace vesper {

/// Luminance of artificial light at the zenith:
/// - "off";
/// - a number, 0 to 1: the luminance itself, cd/m2;
/// - "20.5mag", 10 to 22: the whole zenith's brightness in V mag/arcsec2 as a meter gives it on a moonless night, of
///   which a natural night of 22.0 is taken off;
/// - "bortle4", 1 to 9: the middle of the brightness that goes with a class of Bortle's scale (2001, Sky and Telescope
///   101, 126; brightnesses as meters' makers assign them): 22.0, 21.9, 21.8, 21.1, 20.0, 19.2, 18.7, 18.1 and 17.5.
/// Nothing for another text.
[[nodiscard]] std::optional<Luminance> sky_glow_from_text(std::string_view text);

inline constexpr std::string_view sky_glow_texts =
    "off, 0 to 1 (cd/m2), 10mag to 22mag (of the whole zenith, per square arcsecond) or bortle1 to bortle9";

} // namespace vesper
