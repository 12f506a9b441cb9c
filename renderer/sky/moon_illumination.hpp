// What lights the Moon, and the light that it gives an observer.
#pragma once

#include "vesper/light/earthshine.hpp"
#include "vesper/light/lunar_surface.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectrum.hpp"
#include "vesper/sky/sky_state.hpp"

#include <optional>

namespace vesper {

struct MoonIllumination {
  Length sun_distance;    ///< from the Moon
  Length earth_distance;  ///< between the centres of Earth and Moon
  Angle earth_phase;      ///< Sun-Earth-Moon, 0 to 180 degrees: about 180 less the Moon's
  Angle earthlight_phase; ///< of earthlight on the Moon for the observer (earthlight_phase() in earthshine.hpp)
  Spectrum earthlight;    ///< on the Moon, W/(m2 nm)
  Spectrum sunlit_moon;   ///< what the observer gets of the Sun's light from the Moon, no eclipse, W/(m2 nm)
  Spectrum earthlit_moon; ///< what the observer gets of the Earth's light from the Moon, W/(m2 nm)
  /// What the Earth's shadow leaves of the sunlight, by wavelength, averaged over what the observer sees of the
  /// built-in map's Moon (eclipse_light.hpp). None outside an eclipse, which leaves all.
  std::optional<Spectrum> past_earth;
};

/// Of the observer's own phase angle and distance. The sky's tier says by which law the Earth shines.
[[nodiscard]] MoonIllumination moon_illumination(const SkyState& sky);

/// Spectral irradiance of the whole Moon at the observer above the air, W/(m2 nm): sunlight, dimmed in an eclipse, and
/// earthlight. The one number that disc, air and ground are lit by.
[[nodiscard]] Spectrum moonlight_of(const MoonIllumination& illumination);
[[nodiscard]] Spectrum moonlight_of(const SkyState& sky);

struct MoonBrightness {
  Xyzs illuminance;         ///< of the whole disc above the air, lux
  double v_magnitude = 0.0; ///< of the whole disc above the air; +infinity without light
  Luminance mean_luminance; ///< over the whole disc, lit or not, above the air
};
/// \param irradiance as moonlight_of() gives it
/// \param distance of the Moon's centre from the observer
[[nodiscard]] MoonBrightness moon_brightness(const Spectrum& irradiance, Length distance);

} // namespace vesper
