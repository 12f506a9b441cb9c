// The Moon's disc as one observer sees it, ready to be drawn.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/sky/moon_illumination.hpp"
#include "vesper/sky/moon_samples.hpp"

#include <vector>

namespace vesper {

struct MoonDisc {
  Vec3 direction;               ///< towards its centre, airless, horizon frame
  Length distance;              ///< of its centre from the observer
  Angle angular_radius;         ///< of the sphere: asin(radius / distance)
  Mat3 moon_fixed_from_horizon; ///< mean-Earth axes; takes -direction to the libration's point, exactly
  Mat3 fixed_from_disc;         ///< the same from the axes of horizon_from_disc
  Vec3 to_observer;             ///< from the Moon's centre, mean-Earth axes
  /// For moon_luminance (shaders/lib/moon_surface.glsl), scaled so that the luminance of map and relief over the disc
  /// adds up to `irradiance`. Without the eclipse: that is another share at each place.
  f64::MoonLighting lighting;
  std::vector<MoonCell> cells; ///< of MoonLightSums, of the same scale

  Spectrum irradiance;      ///< of the whole disc above the air, W/(m2 nm); eclipses dim it
  Xyzs illuminance;         ///< the same in lux
  double v_magnitude;       ///< of the whole disc above the air
  Luminance mean_luminance; ///< over the whole disc, lit or not, above the air
};

/// \param globe that is drawn
/// \param moon moon_illumination() of the sky
/// With Tier::cheap the surface is Hapke, Lommel and Seeliger's and earthshine Mueller's; else they follow measurements
/// (lunar_surface.hpp, earthshine.hpp).
/// Within 12 degrees of new Moon, where the model's light falls faster than that of real relief, the disc is drawn with
/// at most 4 times its law's light, and is `irradiance` what it then gives.
[[nodiscard]] MoonDisc moon_disc(const SkyState& sky, const MoonGlobe& globe, MoonIllumination moon);
[[nodiscard]] MoonDisc moon_disc(const SkyState& sky, const MoonGlobe& globe);

} // namespace vesper
