#include "vesper/astro/apparent_sun_moon.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/base/units.hpp"

#include <cmath>

namespace vesper {
namespace {

constexpr double km_per_au = astronomical_unit.to(kilometre);
constexpr double light_speed_au_d = 173.1446326742403;

} // namespace

ApparentSunMoon apparent_sun_moon(const SunEarthMoon& bodies, const Vec3& earth_to_observer_km) {
  f64::StarPlaceFrame motion{};
  motion.velocity_c = bodies.earth.velocity_au_d / light_speed_au_d;
  motion.lorentz_inverse = std::sqrt(1.0 - glm::dot(motion.velocity_c, motion.velocity_c));
  const auto seen_km = [&](const Vec3& from_observer_au) {
    const double distance_au = glm::length(from_observer_au);
    return distance_au * km_per_au * f64::star_aberration(from_observer_au / distance_au, motion);
  };
  const Vec3 observer_au = earth_to_observer_km / km_per_au;
  return {seen_km(sun_from_observer_au(bodies, observer_au)), seen_km(moon_from_observer_au(bodies, observer_au))};
}

ApparentSunMoon apparent_sun_moon(JulianDate<TT> tt, const Vec3& earth_to_observer_km) {
  return apparent_sun_moon(sun_earth_moon(tdb_from_tt(tt)), earth_to_observer_km);
}

double angle_between_rad(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace vesper
