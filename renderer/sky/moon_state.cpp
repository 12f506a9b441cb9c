#include "vesper/sky/moon_state.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/planet_appearance.hpp"
#include "vesper/astro/spherical.hpp"

namespace vesper {
namespace {

Vec3 zenith_equatorial(const StarFrame& frame) {
  const Mat3 icrs_from_horizon = glm::transpose(frame.horizon_from_icrs);
  return frame.equator_of_date_from_icrs * icrs_from_horizon[2];
}

// The Moon carries its surface along at 30 km/s: against its own axes light comes and goes aberrated, by 20 arcsec. For
// light on its way to the Earth, which moves along, this undoes what the light time adds.

/// Direction from which light comes that travels from `source` in ICRS axes, as the moving globe sees it.
Vec3 arriving(const Vec3& source, const Vec3& velocity_c) { return glm::normalize(source) + velocity_c; }
/// Direction into which the moving globe sends light that travels towards `target` in ICRS axes.
Vec3 departing(const Vec3& target, const Vec3& velocity_c) { return glm::normalize(target) - velocity_c; }

Angle half_turns(Angle angle) { return angle > 180.0 * deg ? angle - 360.0 * deg : angle; }

Angle colongitude_of(Angle subsolar_longitude) {
  const Angle colongitude = 90.0 * deg - subsolar_longitude;
  return colongitude < 0.0 * deg ? colongitude + 360.0 * deg : colongitude;
}

} // namespace

MoonState moon_state(const EarthState& earth, const StarFrame& frame, const Vec3& moon_au, const Vec3& sun_au) {
  MoonState moon;
  moon.place = apparent_place(moon_au, frame);
  const Vec3 to_sun = sun_au - moon_au;
  const Vec3 to_observer = -moon_au;
  moon.phase_angle = angle_between(to_sun, to_observer);
  moon.illuminated_fraction = illuminated_fraction(moon.phase_angle);
  moon.bright_limb = position_angle(moon.place.direction_equatorial, apparent_equatorial(sun_au, frame));

  const double light_days = glm::length(moon_au) * light_time_d_per_au;
  moon.moon_fixed_from_icrs = moon_fixed_from_icrs(earth.tdb.plus_days(-light_days), earth.tier);
  const Vec3 velocity_c = light_time_d_per_au * (earth.bodies.earth.velocity_au_d + earth.bodies.moon.velocity_au_d);
  moon.libration = selenographic_of(moon.moon_fixed_from_icrs * departing(to_observer, velocity_c));
  moon.geocentric_libration =
      selenographic_of(moon.moon_fixed_from_icrs * departing(to_observer - earth.earth_to_observer_au, velocity_c));
  moon.subsolar = selenographic_of(moon.moon_fixed_from_icrs * arriving(to_sun, velocity_c));
  moon.colongitude = colongitude_of(moon.subsolar.longitude);

  const Vec3 pole_icrs = glm::transpose(moon.moon_fixed_from_icrs)[2];
  const Vec3 pole_au = moon_au + moon_mean_radius.to(astronomical_unit) * pole_icrs;
  moon.axis = position_angle(moon.place.direction_equatorial, apparent_equatorial(pole_au, frame));
  moon.parallactic = half_turns(position_angle(moon.place.direction_equatorial, zenith_equatorial(frame)));
  return moon;
}

} // namespace vesper
