#include "vesper/astro/solar_eclipse.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/crossings.hpp"
#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/eclipse_search.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/astro/syzygy.hpp"
#include "vesper/base/shader_math.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace vesper {
namespace {

constexpr double sun_radius_km = sun_radius.to(kilometre);

/// The axis of the Moon's shadow: a line through the Moon away from the Sun, km from the Earth's centre.
struct ShadowAxis {
  Vec3 direction;  ///< unit vector, with the light
  Vec3 nearest_km; ///< its point nearest to the Earth's centre
  Vec3 moon_km;
  double sun_moon_km;

  explicit ShadowAxis(const ApparentSunMoon& seen)
      : direction(seen.moon_km - seen.sun_km), moon_km(seen.moon_km), sun_moon_km(glm::length(direction)) {
    direction /= sun_moon_km;
    nearest_km = moon_km - glm::dot(moon_km, direction) * direction;
  }

  [[nodiscard]] double distance_km(const Vec3& point_km) const {
    return glm::length(glm::cross(point_km - moon_km, direction));
  }
  /// Radius of the umbra in the plane of a point, negative behind the cone's tip, where the eclipse is annular.
  [[nodiscard]] double umbra_km(const Vec3& point_km) const {
    constexpr double moon = moon_valley_radius_ratio * earth_equatorial_radius_km;
    const double sine = (sun_radius_km - moon) / sun_moon_km;
    return (moon - glm::dot(point_km - moon_km, direction) * sine) / std::sqrt(1.0 - sine * sine);
  }
  [[nodiscard]] double penumbra_km(const Vec3& point_km) const {
    constexpr double moon = moon_radius_ratio * earth_equatorial_radius_km;
    const double sine = (sun_radius_km + moon) / sun_moon_km;
    return (moon + glm::dot(point_km - moon_km, direction) * sine) / std::sqrt(1.0 - sine * sine);
  }
};

/// The Earth as a unit sphere: lengths along its pole are stretched by the flattening.
class RoundEarth {
public:
  explicit RoundEarth(const Vec3& pole) : pole_(pole) {}

  /// Distance of a line from the centre, equatorial radii; below 1 it meets the Earth.
  [[nodiscard]] double distance(const ShadowAxis& axis) const { return glm::length(nearest(axis)); }
  /// Where the line first meets the surface, or comes nearest to it: km from the centre.
  [[nodiscard]] Vec3 place_km(const ShadowAxis& axis) const {
    const Vec3 middle = nearest(axis);
    const double inside = 1.0 - glm::dot(middle, middle);
    return scaled(inside > 0.0 ? middle - std::sqrt(inside) * round_direction(axis) : glm::normalize(middle),
                  earth_polar_ratio) *
           earth_equatorial_radius_km;
  }

private:
  [[nodiscard]] Vec3 scaled(const Vec3& v, double factor) const {
    return v + (factor - 1.0) * glm::dot(v, pole_) * pole_;
  }
  [[nodiscard]] Vec3 round_direction(const ShadowAxis& axis) const {
    return glm::normalize(scaled(axis.direction, 1.0 / earth_polar_ratio));
  }
  [[nodiscard]] Vec3 nearest(const ShadowAxis& axis) const {
    const Vec3 direction = round_direction(axis);
    const Vec3 point = scaled(axis.nearest_km / earth_equatorial_radius_km, 1.0 / earth_polar_ratio);
    return point - glm::dot(point, direction) * direction;
  }

  Vec3 pole_;
};

/// The axis as a function of the seconds of TT since an instant.
class ShadowPass {
public:
  explicit ShadowPass(Instant origin) : origin_(std::move(origin)) {}

  [[nodiscard]] Instant instant(double seconds) const { return later(origin_, seconds); }
  [[nodiscard]] ShadowAxis axis(double seconds) const {
    return ShadowAxis(apparent_sun_moon(origin_.tt.plus_days(seconds / seconds_per_day)));
  }
  /// Seconds of the least distance of the axis from the Earth's centre.
  [[nodiscard]] double greatest(int lunation) const {
    const auto squared_distance = [&](double seconds) {
      const Vec3 nearest_km = axis(seconds).nearest_km;
      return glm::dot(nearest_km, nearest_km);
    };
    return nearest_pass(squared_distance, Syzygy::new_moon, lunation, origin_.tt);
  }

private:
  Instant origin_;
};

/// Total, annular or hybrid. The umbra is widest where the surface bulges most towards the Moon, near the middle of the
/// path, and narrowest at the ends: those three places decide.
SolarEclipseType central_type(const ShadowPass& pass, const RoundEarth& earth, double greatest) {
  const auto umbra_at = [&](double seconds) {
    const ShadowAxis axis = pass.axis(seconds);
    return axis.umbra_km(earth.place_km(axis));
  };
  if (umbra_at(greatest) <= 0.0) {
    return SolarEclipseType::annular;
  }
  const auto height = [&](double seconds) { return earth.distance(pass.axis(seconds)) - 1.0; };
  for (const double step_s : {-1800.0, 1800.0}) {
    constexpr double limit_s = 6.0 * 3600.0;
    const std::optional<double> end = first_crossing(height, greatest, step_s, limit_s);
    if (end && umbra_at(*end) <= 0.0) {
      return SolarEclipseType::hybrid;
    }
  }
  return SolarEclipseType::total;
}

Observer geodetic(const Vec3& icrs_km, const EarthState& greenwich) {
  const Vec3 place = greenwich.equator_of_date_from_icrs * icrs_km;
  const double longitude = std::atan2(place.y, place.x) - greenwich.local_sidereal_time_rad;
  const double latitude = std::atan2(place.z, earth_polar_ratio * earth_polar_ratio * std::hypot(place.x, place.y));
  return {latitude * rad, std::remainder(longitude, 2.0 * std::numbers::pi) * rad, 0.0 * metre};
}

SolarEclipse eclipse_of_lunation(const Instant& origin, int lunation) {
  const ShadowPass pass(origin);
  const double greatest = pass.greatest(lunation);
  const ShadowAxis axis = pass.axis(greatest);
  SolarEclipse eclipse;
  eclipse.greatest = pass.instant(greatest);
  eclipse.gamma = std::copysign(glm::length(axis.nearest_km) / earth_equatorial_radius_km,
                                glm::dot(axis.nearest_km, ecliptic_north_icrs));
  const EarthState greenwich = earth_state(eclipse.greatest, Observer{});
  const RoundEarth earth(glm::transpose(greenwich.equator_of_date_from_icrs)[2]);
  const Vec3 place_km = earth.place_km(axis);
  eclipse.place = geodetic(place_km, greenwich);
  // In true lengths: those of the round Earth, ten kilometres more in high latitudes, lose the slightest eclipses.
  const double height_km = axis.distance_km(place_km);
  const double umbra_km = axis.umbra_km(place_km);
  eclipse.central = earth.distance(axis) < 1.0;
  if (eclipse.central) {
    eclipse.type = central_type(pass, earth, greatest);
  } else if (height_km < std::abs(umbra_km)) {
    eclipse.type = umbra_km > 0.0 ? SolarEclipseType::total : SolarEclipseType::annular;
  } else if (height_km < axis.penumbra_km(place_km)) {
    eclipse.type = SolarEclipseType::partial;
  }
  return eclipse;
}

} // namespace

SolarEclipseState solar_eclipse_state(const Vec3& sun_km, const Vec3& moon_km, double radius_ratio) {
  const double sun = std::asin(sun_radius_km / glm::length(sun_km));
  const double moon = std::asin(radius_ratio * earth_equatorial_radius_km / glm::length(moon_km));
  const double separation = angle_between(sun_km, moon_km).to(rad);
  return {separation * rad, sun * rad, moon * rad, (sun + moon - separation) / (2.0 * sun),
          f64::disc_covered(sun, moon, separation)};
}

std::string_view name_of(SolarEclipseType type) {
  switch (type) {
  case SolarEclipseType::none:
    return "none";
  case SolarEclipseType::partial:
    return "partial";
  case SolarEclipseType::annular:
    return "annular";
  case SolarEclipseType::total:
    return "total";
  case SolarEclipseType::hybrid:
    break;
  }
  return "hybrid";
}

SolarEclipse solar_eclipse_near(const Instant& instant) {
  return eclipse_of_lunation(instant, nearest_lunation(Syzygy::new_moon, instant.tt));
}

std::vector<SolarEclipse> solar_eclipses(const Instant& from, const Instant& to) {
  return eclipses_between(from, to, Syzygy::new_moon, eclipse_of_lunation);
}

} // namespace vesper
