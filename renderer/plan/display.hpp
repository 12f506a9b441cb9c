// What a picture is shown on, and from where it is looked at.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/plan/view.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace vesper {

/// Red, green and blue of a display, white D65. Numbered as shaders/lib/display.glsl numbers them.
enum class Primaries {
  srgb = 0,       ///< IEC 61966-2-1, as ITU-R BT.709
  display_p3 = 1, ///< SMPTE EG 432-1 with D65
  rec2020 = 2,    ///< ITU-R BT.2020
};

/// From linear light to code values. Numbered likewise.
enum class Transfer {
  srgb = 0,  ///< IEC 61966-2-1
  gamma = 1, ///< a power
  pq = 2,    ///< SMPTE ST 2084, for absolute luminance
};

/// Names in the order of the enumerations.
[[nodiscard]] std::span<const std::string_view> primaries_names();
[[nodiscard]] std::optional<Primaries> primaries_from_name(std::string_view name);
[[nodiscard]] std::span<const std::string_view> transfer_names();
[[nodiscard]] std::optional<Transfer> transfer_from_name(std::string_view name);

/// Pixels of `pitch`, seen from `distance`, that one degree takes in the middle of the screen.
[[nodiscard]] double pixels_per_degree(Length pitch, Length distance);

/// Lowest and highest allowed value.
struct ValueRange {
  double lowest, highest;
};
inline constexpr ValueRange display_peak_range_cd_m2{0.001, 10000.0};
inline constexpr ValueRange display_black_range_cd_m2{0.0, 1000.0};
inline constexpr ValueRange display_ambient_range_cd_m2{0.0, 1000.0};
inline constexpr ValueRange display_gamma_range{1.0, 4.0};
inline constexpr ValueRange dome_gain_range{0.05, 10.0};
inline constexpr ValueRange dome_reflectance_range{0.0, 0.98};
inline constexpr ValueRange pixels_per_degree_range{0.1, 1000.0};

/// A display as it can be measured with a luminance meter. The default is a desktop monitor, 24 inches with 1920 x 1080
/// pixels, at 60 cm in a dim room: of a matt screen that reflects 3 % of what falls on it, some 50 lux make 0.5 cd/m2.
struct Display {
  Luminance peak = 200.0 * candela_per_m2;  ///< of its white in the dark; of a projector on a screen of gain 1
  Luminance black = 0.2 * candela_per_m2;   ///< of code value 0, likewise; at most half the peak
  Luminance ambient = 0.5 * candela_per_m2; ///< of the display switched off, in its room
  Primaries primaries = Primaries::srgb;
  Transfer transfer = Transfer::srgb;
  double gamma = 2.2;            ///< of Transfer::gamma
  double dome_gain = 1.0;        ///< luminance of a dome over that of a perfect white diffuser
  double dome_reflectance = 0.0; ///< of a hemispherical dome, which lights itself; 0 for a flat screen
  double pixels_per_degree = vesper::pixels_per_degree(0.2768e-3 * metre, 0.6 * metre); ///< 37.8
};

/// Throws Error(argument) naming the member, its value and the allowed range.
void validate(const Display& display);

/// Pixels that a degree takes of a picture as it is likely to be seen: filling the height of the default monitor, or,
/// in a dome, with angles as they are in the scene. So more pixels make a picture sharper and change nothing else.
[[nodiscard]] double usual_pixels_per_degree(const Display& display, const View& view);

/// The display in the form that shaders/lib/display.glsl takes, in double precision. Throws as validate does.
[[nodiscard]] f64::DisplayModel display_model(const Display& display);

} // namespace vesper
