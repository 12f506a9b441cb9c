#include "vesper/astro/local_solar_eclipse.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/crossings.hpp"
#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/rotation.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/astro/star_frame.hpp"
#include "vesper/astro/star_place.hpp"

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

// Of the Earth-fixed axes against the true equinox, over UT1 (IAU 2000 Earth rotation angle).
constexpr double rotation_rad_s = 2.0 * std::numbers::pi * 1.00273781191135448 / seconds_per_day;

/// Sun and Moon over one place as functions of the seconds of TT since an instant. Over the hours of an eclipse the
/// Earth only turns: its axis moves by 0.02", Delta-T by microseconds.
class Sky {
public:
  Sky(const Instant& origin, const Observer& observer) : earth_(earth_state(origin, observer)) {}

  [[nodiscard]] Instant instant(double seconds) const { return later(earth_.instant, seconds); }

  /// Along equatorial axes of date.
  [[nodiscard]] ApparentSunMoon seen(double seconds) const {
    const Mat3& equator_from_icrs = earth_.equator_of_date_from_icrs;
    const Vec3 start_km = equator_from_icrs * earth_.earth_to_observer_au * astronomical_unit.to(kilometre);
    const Vec3 place_km = turn_z(rotation_rad_s * seconds) * start_km;
    const ApparentSunMoon icrs = apparent_sun_moon(earth_.instant.tt.plus_days(seconds / seconds_per_day),
                                                   glm::transpose(equator_from_icrs) * place_km);
    return {equator_from_icrs * icrs.sun_km, equator_from_icrs * icrs.moon_km};
  }
  [[nodiscard]] SolarEclipseState state(double seconds, double radius_ratio = moon_radius_ratio) const {
    const ApparentSunMoon now = seen(seconds);
    return solar_eclipse_state(now.sun_km, now.moon_km, radius_ratio);
  }
  [[nodiscard]] SolarMoment moment(double seconds) const {
    const Mat3 horizon =
        horizon_from_equator(earth_.observer.latitude, earth_.local_sidereal_time_rad + rotation_rad_s * seconds);
    const Horizontal sun = horizontal_of(horizon * seen(seconds).sun_km);
    return {instant(seconds), sun.altitude, sun.azimuth};
  }

private:
  EarthState earth_;
};

/// Seconds of the least separation.
double least_separation(const Sky& sky) {
  const auto squared = [&](double seconds) {
    const double separation = sky.state(seconds).separation.to(rad);
    return separation * separation;
  };
  // The penumbra is on the Earth for at most 3.2 h before and after the greatest eclipse.
  constexpr double step_s = 1200.0;
  constexpr int steps = 12;
  double best = 0.0;
  double least = squared(best);
  for (int i = -steps; i <= steps; ++i) {
    const double value = squared(i * step_s);
    if (value < least) {
      best = i * step_s;
      least = value;
    }
  }
  constexpr double last_step_s = 20.0;
  return minimum_near(squared, best, step_s, last_step_s);
}

bool sun_up_between(const Sky& sky, double begin, double end) {
  // A few minutes apart: what a step could miss is a Sun that grazes the horizon from below.
  constexpr int steps = 30;
  for (int i = 0; i <= steps; ++i) {
    if (sky.moment(std::lerp(begin, end, static_cast<double>(i) / steps)).sun_altitude > almanac_sunrise_altitude) {
      return true;
    }
  }
  return false;
}

} // namespace

LocalSolarEclipse local_solar_eclipse(const Instant& greatest, const Observer& observer, double umbral_radius_ratio) {
  const Sky sky(greatest, observer);
  const double maximum = least_separation(sky);
  LocalSolarEclipse local;
  local.maximum = sky.moment(maximum);
  local.state = sky.state(maximum);
  local.ratio = local.state.moon_semidiameter / local.state.sun_semidiameter;
  const ApparentSunMoon seen = sky.seen(maximum);
  local.position_angle = position_angle(glm::normalize(seen.sun_km), glm::normalize(seen.moon_km));
  if (local.state.magnitude <= 0.0) {
    return local;
  }

  const SolarEclipseState umbral = sky.state(maximum, umbral_radius_ratio);
  const bool larger_moon = umbral.moon_semidiameter >= umbral.sun_semidiameter;
  // How far the limbs have to go: outer contacts by the mean limb, inner ones by the umbra's.
  const auto outer_gap = [&](double seconds) {
    const SolarEclipseState s = sky.state(seconds);
    return (s.separation - s.sun_semidiameter - s.moon_semidiameter).to(rad);
  };
  const auto inner_gap = [&](double seconds) {
    const SolarEclipseState s = sky.state(seconds, umbral_radius_ratio);
    const Angle excess = s.moon_semidiameter - s.sun_semidiameter;
    return (s.separation - (larger_moon ? excess : -excess)).to(rad);
  };
  local.type = inner_gap(maximum) >= 0.0 ? SolarEclipseType::partial
               : larger_moon             ? SolarEclipseType::total
                                         : SolarEclipseType::annular;
  constexpr double outer_step_s = 900.0;
  constexpr double inner_step_s = 120.0;
  constexpr double limit_s = 4.0 * 3600.0;
  const std::array<std::optional<double>, solar_contact_count> seconds{
      first_crossing(outer_gap, maximum, -outer_step_s, limit_s),
      first_crossing(inner_gap, maximum, -inner_step_s, limit_s),
      first_crossing(inner_gap, maximum, inner_step_s, limit_s),
      first_crossing(outer_gap, maximum, outer_step_s, limit_s)};
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    if (seconds[i]) {
      local.contacts[i] = sky.moment(*seconds[i]);
    }
  }
  local.sun_up = sun_up_between(sky, seconds.front().value_or(maximum), seconds.back().value_or(maximum));
  return local;
}

} // namespace vesper
