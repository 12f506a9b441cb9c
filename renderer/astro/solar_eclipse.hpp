// Eclipses of the Sun for the Earth as a whole: what kind, when, how central; and the discs at any instant.
#pragma once

#include "vesper/astro/apparent_sun_moon.hpp"
#include "vesper/astro/constants.hpp"
#include "vesper/astro/observer.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/units.hpp"

#include <string_view>
#include <vector>

namespace vesper {

/// The discs of Sun and Moon for one observer, wherever they stand.
struct SolarEclipseState {
  Angle separation; ///< of the centres, 0 to 180 degrees
  Angle sun_semidiameter;
  Angle moon_semidiameter;
  double magnitude = 0.0;   ///< share of the Sun's diameter covered along the line of centres: negative outside, never
                            ///< clipped; (s + m - separation) / 2s
  double obscuration = 0.0; ///< share of the Sun's area covered, 0 to 1
};

/// \param sun_km, moon_km from the observer along any axes
/// \param radius_ratio of the Moon over the Earth's equatorial radius
[[nodiscard]] SolarEclipseState solar_eclipse_state(const Vec3& sun_km, const Vec3& moon_km,
                                                    double radius_ratio = moon_radius_ratio);

enum class SolarEclipseType {
  none,
  partial,
  annular,
  total,
  hybrid, ///< total in the middle of its path, annular at one end or both
};
/// "none", "partial", "annular", "total", "hybrid".
[[nodiscard]] std::string_view name_of(SolarEclipseType type);

struct SolarEclipse {
  SolarEclipseType type = SolarEclipseType::none;
  bool central = false; ///< whether the axis of the shadow meets the Earth (WGS84)
  Instant greatest;     ///< least distance of that axis from the Earth's centre
  double gamma = 0.0;   ///< that distance in equatorial radii, positive where the axis passes north
  Observer place;       ///< on the ellipsoid: where the axis meets it at that instant, or comes nearest to it
};

/// The new Moon nearest to an instant (within a week), eclipse or not. The umbra is that of k = 0.272281, the penumbra
/// that of k = 0.2725076. `greatest` keeps the given instant's difference to the Delta-T table.
[[nodiscard]] SolarEclipse solar_eclipse_near(const Instant& instant);

/// All eclipses whose greatest phase lies in [from, to), in order.
[[nodiscard]] std::vector<SolarEclipse> solar_eclipses(const Instant& from, const Instant& to);

} // namespace vesper
