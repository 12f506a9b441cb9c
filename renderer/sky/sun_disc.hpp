// The Sun as one observer sees it: its disc, its corona, and the Moon before them.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/light/solar_disc.hpp"
#include "vesper/light/spectrum.hpp"
#include "vesper/sky/sky_state.hpp"

#include <cstdint>
#include <optional>

namespace vesper {

struct SunOptions {
  LimbDarkening law = LimbDarkening::hestroffer_magnan;
  bool streamers = true;          ///< else the corona is the same all around
  std::optional<double> activity; ///< of the Sun, 0 (minimum) to 1 (maximum), which draws the streamers; without one,
                                  ///< solar_activity of the date
  std::uint32_t seed = 0;         ///< another one, other streamers
};

struct SunDisc {
  Vec3 direction; ///< to the centre, without refraction: horizon frame
  Length distance;
  Angle angular_radius;
  f64::SunShading shading; ///< along axes of the horizon frame
  Spectrum irradiance;     ///< of the disc without an eclipse, above the air, W/(m2 nm)
};

/// The disc's mean luminance is 1.96e9 cd/m2, at any distance. Throws Error(argument) for an activity that is not
/// between 0 and 1.
[[nodiscard]] SunDisc sun_disc(const SkyState& sky, const SunOptions& options = {});

/// What the GPU reads.
[[nodiscard]] f32::SunShading in_single(const f64::SunShading& shading);

/// Where in its cycle the Sun is: 0 in December 2019, a minimum, and every 11.0 years before and after, 1 halfway. Real
/// cycles differ from it by a year or two.
[[nodiscard]] double solar_activity(const Instant& instant);

} // namespace vesper
