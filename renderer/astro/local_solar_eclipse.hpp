// An eclipse of the Sun from one place.
#pragma once

#include "vesper/astro/solar_eclipse.hpp"

#include <array>
#include <optional>

namespace vesper {

/// When the limbs touch, from outside (1, 4) or inside (2, 3).
enum class SolarContact { c1, c2, c3, c4 };
inline constexpr int solar_contact_count = 4;

struct SolarMoment {
  Instant instant;
  Angle sun_altitude; ///< of the centre, airless
  Angle sun_azimuth;  ///< north through east
};

/// Circumstances at a place, smooth limb. Given wherever the Sun stands, also below the horizon: see `sun_up`.
struct LocalSolarEclipse {
  SolarEclipseType type = SolarEclipseType::none; ///< as seen there: none, partial, annular, total
  SolarMoment maximum;                            ///< least separation of the centres
  std::array<std::optional<SolarMoment>, solar_contact_count> contacts; ///< by SolarContact; empty where there is none
  SolarEclipseState state;                                              ///< at maximum
  double ratio = 0.0;   ///< the Moon's diameter over the Sun's, at maximum
  Angle position_angle; ///< of the Moon's centre at the Sun's, north through east, 0 to 360 degrees, at maximum
  bool sun_up = false;  ///< whether the Sun's centre stands above -50', where refraction lifts its limb over the
                        ///< horizon, at some time between the first and the last contact

  [[nodiscard]] const std::optional<SolarMoment>& contact(SolarContact c) const {
    return contacts[static_cast<std::size_t>(c)];
  }
};

/// \param greatest of the eclipse, within an hour; its difference to the Delta-T table is kept
/// \param umbral_radius_ratio k of the second and third contacts and of the type: the mean limb or, as some almanacs
///        have it, moon_valley_radius_ratio. First and last contacts, magnitude and obscuration are the mean limb's
[[nodiscard]] LocalSolarEclipse local_solar_eclipse(const Instant& greatest, const Observer& observer,
                                                    double umbral_radius_ratio = moon_radius_ratio);

} // namespace vesper
