#include "vesper/astro/lunar_eclipse.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/crossings.hpp"
#include "vesper/astro/eclipse_search.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/astro/syzygy.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace vesper {
namespace {

constexpr double danjon_enlargement = 1.01;
constexpr double sun_radius_km = sun_radius.to(kilometre);

/// Umbral and penumbral radii, rad.
Vec2 shadow_radii_rad(double moon_parallax, double sun_parallax, double sun_semidiameter, ShadowModel model) {
  const Vec2 sun(sun_parallax - sun_semidiameter, sun_parallax + sun_semidiameter);
  return model == ShadowModel::danjon ? danjon_enlargement * moon_parallax + sun
                                      : 1.02 * (0.998340 * moon_parallax + sun);
}

/// The Moon and the shadow as functions of the seconds of TT since an instant.
class ShadowPass {
public:
  ShadowPass(Instant origin, ShadowModel model) : origin_(std::move(origin)), model_(model) {}

  [[nodiscard]] Instant instant(double seconds) const { return later(origin_, seconds); }
  [[nodiscard]] ApparentSunMoon seen(double seconds) const {
    return apparent_sun_moon(origin_.tt.plus_days(seconds / seconds_per_day));
  }
  [[nodiscard]] LunarEclipseState state(double seconds) const { return lunar_eclipse_state(seen(seconds), model_); }

  /// Seconds of the least distance from the axis, in length as catalogues have it.
  [[nodiscard]] double greatest(int lunation) const {
    const auto squared_distance = [&](double seconds) {
      const ApparentSunMoon now = seen(seconds);
      const Vec3 off_km = glm::cross(glm::normalize(now.sun_km), now.moon_km);
      return glm::dot(off_km, off_km);
    };
    return nearest_pass(squared_distance, Syzygy::full_moon, lunation, origin_.tt);
  }

private:
  Instant origin_;
  ShadowModel model_;
};

/// How far the Moon's limb has to go to the edge of each contact: negative between the contacts that belong together.
double gap_rad(const LunarEclipseState& state, LunarContact contact) {
  const double distance = state.axis_distance.to(rad);
  const double moon = state.moon_semidiameter.to(rad);
  switch (contact) {
  case LunarContact::p1:
  case LunarContact::p4:
    return distance - moon - state.penumbra_radius.to(rad);
  case LunarContact::u1:
  case LunarContact::u4:
    return distance - moon - state.umbra_radius.to(rad);
  case LunarContact::u2:
  case LunarContact::u3:
    break;
  }
  return distance + moon - state.umbra_radius.to(rad);
}

LunarEclipseType type_of(double umbral_magnitude, double penumbral_magnitude) {
  return umbral_magnitude >= 1.0      ? LunarEclipseType::total
         : umbral_magnitude > 0.0     ? LunarEclipseType::partial
         : penumbral_magnitude >= 1.0 ? LunarEclipseType::total_penumbral
         : penumbral_magnitude > 0.0  ? LunarEclipseType::penumbral
                                      : LunarEclipseType::none;
}

LunarEclipse eclipse_of_lunation(const Instant& origin, int lunation, ShadowModel model) {
  const ShadowPass pass(origin, model);
  const double greatest = pass.greatest(lunation);
  const LunarEclipseState state = pass.state(greatest);
  LunarEclipse eclipse;
  eclipse.greatest = pass.instant(greatest);
  eclipse.umbral_magnitude = state.umbral_magnitude;
  eclipse.penumbral_magnitude = state.penumbral_magnitude;
  eclipse.type = type_of(state.umbral_magnitude, state.penumbral_magnitude);
  const double miss_km = glm::length(state.moon_km) * std::sin(state.axis_distance.to(rad));
  eclipse.gamma = std::copysign(miss_km / earth_equatorial_radius_km,
                                glm::dot(glm::normalize(state.moon_km) - state.axis, ecliptic_north_icrs));
  if (eclipse.type == LunarEclipseType::none) {
    return eclipse;
  }
  for (int i = 0; i < lunar_contact_count; ++i) {
    const auto contact = static_cast<LunarContact>(i);
    constexpr double step_s = 3600.0;
    constexpr double limit_s = 6.0 * 3600.0; // the longest eclipse lasts 6.3 h in all
    const double direction = contact <= LunarContact::u2 ? -1.0 : 1.0;
    const std::optional<double> seconds = first_crossing([&](double s) { return gap_rad(pass.state(s), contact); },
                                                         greatest, direction * step_s, limit_s);
    if (seconds) {
      eclipse.contacts[static_cast<std::size_t>(i)] = pass.instant(*seconds);
    }
  }
  return eclipse;
}

} // namespace

LunarEclipseState lunar_eclipse_state(const ApparentSunMoon& seen, ShadowModel model) {
  const double sun_km = glm::length(seen.sun_km);
  const double moon_km = glm::length(seen.moon_km);
  const double moon_parallax = std::asin(earth_equatorial_radius_km / moon_km);
  const Vec2 radii = shadow_radii_rad(moon_parallax, std::asin(earth_equatorial_radius_km / sun_km),
                                      std::asin(sun_radius_km / sun_km), model);
  const double moon = std::asin(moon_radius_ratio * earth_equatorial_radius_km / moon_km);
  const double distance = angle_between(-seen.sun_km, seen.moon_km).to(rad);
  LunarEclipseState state;
  state.umbral_magnitude = (radii.x + moon - distance) / (2.0 * moon);
  state.penumbral_magnitude = (radii.y + moon - distance) / (2.0 * moon);
  state.axis_distance = distance * rad;
  state.umbra_radius = radii.x * rad;
  state.penumbra_radius = radii.y * rad;
  state.moon_semidiameter = moon * rad;
  state.axis = -seen.sun_km / sun_km;
  state.moon_km = seen.moon_km;
  state.sun_distance = sun_km * kilometre;
  return state;
}

f64::EarthShadow earth_shadow(const LunarEclipseState& state, const Mat3& to_frame) {
  return {to_frame * state.axis, state.sun_distance.to(kilometre), sun_radius_km,
          danjon_enlargement * earth_equatorial_radius_km};
}

std::string_view name_of(LunarEclipseType type) {
  switch (type) {
  case LunarEclipseType::none:
    return "none";
  case LunarEclipseType::penumbral:
    return "penumbral";
  case LunarEclipseType::total_penumbral:
    return "total penumbral";
  case LunarEclipseType::partial:
    return "partial";
  case LunarEclipseType::total:
    break;
  }
  return "total";
}

LunarEclipse lunar_eclipse_near(const Instant& instant, ShadowModel model) {
  return eclipse_of_lunation(instant, nearest_lunation(Syzygy::full_moon, instant.tt), model);
}

std::vector<LunarEclipse> lunar_eclipses(const Instant& from, const Instant& to, ShadowModel model) {
  return eclipses_between(from, to, Syzygy::full_moon, [model](const Instant& origin, int lunation) {
    return eclipse_of_lunation(origin, lunation, model);
  });
}

} // namespace vesper
