// The dark sky's sources as the air and the ground are lit by them.
#pragma once

#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/sky/dark_sky.hpp"

#include <cstddef>

namespace vesper {

/// A source all over the sky, and what turns the light that the air's tables scatter, which are made for sunlight, into
/// its own.
struct SpreadSource {
  SpreadLight light;
  Mat4 from_sunlight{1.0};

  /// X, Y, Z, S in cd/m2 of what the air scatters of it: SpreadLightViews::luminance.
  [[nodiscard]] Vec4 scattered(const SpreadLightViews& views, std::size_t view, Angle azimuth) const {
    return from_sunlight * views.luminance(view, azimuth, light);
  }
};

/// \param lowest of the views that are asked for: SpreadLightViews::lowest
[[nodiscard]] SpreadSource spread_airglow(const DarkSky& sky, Angle lowest);
[[nodiscard]] SpreadSource spread_zodiacal_light(const DarkSky& sky, Angle lowest);
[[nodiscard]] SpreadSource spread_starlight(const DarkSky& sky, Angle lowest);

/// X, Y, Z and S of sky glow of 1 cd/m2.
[[nodiscard]] const Vec4& sky_glow_color();

} // namespace vesper
