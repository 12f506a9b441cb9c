#include "vesper/astro/star_frame.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/rotation.hpp"

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

/// Mueller, Engel and Doellner 2012, eq. 7 and 8 (after Jensen et al. 2001).
StarFrame cheap_star_frame(const Instant& instant, const Observer& observer) {
  const double t = centuries_since_j2000(instant.tt);
  const double t_ut1 = centuries_since_j2000(instant.ut1);
  const double sidereal = 4.894961 + 230121.675315 * t_ut1 + observer.longitude.to(rad);
  const double turn = 2.0 * std::numbers::pi;
  StarFrame frame;
  frame.sidereal_time_rad = sidereal - turn * std::floor(sidereal / turn);
  frame.equator_of_date_from_icrs = cheap_equator_of_date_from_icrs(t);
  frame.horizon_from_icrs =
      horizon_from_equator(observer.latitude, frame.sidereal_time_rad) * frame.equator_of_date_from_icrs;
  frame.sun_to_observer = Vec3(1.0, 0.0, 0.0);
  frame.solar_deflection = false;
  return frame;
}

} // namespace

Mat3 cheap_equator_of_date_from_icrs(double centuries) {
  return turn_z(0.01118 * centuries) * turn_y(-0.00972 * centuries) * turn_z(0.01118 * centuries);
}

Mat3 horizon_from_equator(Angle latitude, double sidereal_time_rad) {
  const double c = std::cos(latitude.to(rad));
  const double s = std::sin(latitude.to(rad));
  // Columns: the meridian point of the equator, the east point and the celestial pole in horizon axes.
  const Mat3 horizon_from_meridian(Vec3(0.0, -s, c), Vec3(1.0, 0.0, 0.0), Vec3(0.0, c, s));
  return horizon_from_meridian * turn_z(-sidereal_time_rad);
}

StarFrame star_frame(const EarthState& earth) {
  StarFrame frame;
  frame.years_since_j2000 = earth.instant.tt.days_since(j2000<TT>) / days_per_julian_year;
  frame.observer_barycentric_au = earth.bodies.earth.position_au + earth.earth_to_observer_au;
  frame.observer_velocity_c = light_time_d_per_au * (earth.bodies.earth.velocity_au_d + earth.observer_velocity_au_d);
  frame.lorentz_inverse = std::sqrt(1.0 - glm::dot(frame.observer_velocity_c, frame.observer_velocity_c));
  const Vec3 sun_to_observer =
      earth.bodies.earth.position_au - earth.bodies.sun.position_au + earth.earth_to_observer_au;
  frame.sun_distance_au = glm::length(sun_to_observer);
  frame.sun_to_observer = sun_to_observer / frame.sun_distance_au;
  frame.solar_deflection = true;
  frame.equator_of_date_from_icrs = earth.equator_of_date_from_icrs;
  frame.sidereal_time_rad = earth.local_sidereal_time_rad;
  frame.horizon_from_icrs =
      horizon_from_equator(earth.observer.latitude, frame.sidereal_time_rad) * frame.equator_of_date_from_icrs;
  return frame;
}

StarFrame star_frame(const Instant& instant, const Observer& observer, Tier tier) {
  return tier == Tier::cheap ? cheap_star_frame(instant, observer) : star_frame(earth_state(instant, observer));
}

} // namespace vesper
