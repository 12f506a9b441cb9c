#include "vesper/astro/apparent_sun_moon.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/constants.hpp"
#include "vesper/base/units.hpp"

#include <cmath>

namespace vesper {

ApparentSunMoon apparent_sun_moon(const SunEarthMoon& bodies, const Vec3& earth_to_observer_km) {
  constexpr double km_per_au = astronomical_unit.to(kilometre);
  StarFrame motion;
  motion.observer_velocity_c = light_time_d_per_au * bodies.earth.velocity_au_d;
  motion.lorentz_inverse = std::sqrt(1.0 - glm::dot(motion.observer_velocity_c, motion.observer_velocity_c));
  const auto seen_km = [&](const Vec3& from_observer_au) {
    return glm::length(from_observer_au) * km_per_au * apparent_direction_icrs(from_observer_au, motion);
  };
  const Vec3 observer_au = earth_to_observer_km / km_per_au;
  return {seen_km(sun_from_observer_au(bodies, observer_au)), seen_km(moon_from_observer_au(bodies, observer_au))};
}

ApparentSunMoon apparent_sun_moon(JulianDate<TT> tt, const Vec3& earth_to_observer_km) {
  return apparent_sun_moon(sun_earth_moon(tdb_from_tt(tt)), earth_to_observer_km);
}

} // namespace vesper
