// Sun and Moon together as they are seen, without the Earth's turning: what eclipses and phases are reckoned from.
#pragma once

#include "vesper/astro/ephemeris.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// Apparent places along ICRS axes, km: light time and annual aberration applied to both, the length being the distance
/// from the observer now to the body when the light left it.
struct ApparentSunMoon {
  Vec3 sun_km{};
  Vec3 moon_km{};
};

/// \param earth_to_observer_km of an observer away from the Earth's centre, along ICRS axes; his diurnal aberration,
///        0.3" and alike for both, is left out
[[nodiscard]] ApparentSunMoon apparent_sun_moon(const SunEarthMoon& bodies, const Vec3& earth_to_observer_km = {});
[[nodiscard]] ApparentSunMoon apparent_sun_moon(JulianDate<TT> tt, const Vec3& earth_to_observer_km = {});

} // namespace vesper
