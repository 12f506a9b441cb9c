#include "vesper/sky/dark_sky.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/astro/frames.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/sky/milky_way.hpp"
#include "vesper/sky/sun_disc.hpp"
#include "vesper/sky/zodiacal_light.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

constexpr double earth_radius_km = 6371.0; // the mean, for a shell above all of it

Mat3 helioecliptic_from_horizon(const SkyState& sky) {
  const Vec3 pole = sky.stars.horizon_from_icrs * glm::transpose(mean_ecliptic_from_icrs(sky.instant.tt))[2];
  const Vec3& sun = sky.sun.direction_horizon;
  const Vec3 toward = glm::normalize(sun - glm::dot(sun, pole) * pole);
  return glm::transpose(Mat3(toward, glm::cross(pole, toward), pole));
}

} // namespace

DarkSky dark_sky(const SkyState& sky, const DarkSkyOptions& options) {
  static const Vec4 airglow_unit = xyzs_of_s10(airglow_spectrum());
  validate(options.glow);
  const SunDisc sun = sun_disc(sky);
  DarkSky dark;
  dark.helioecliptic_from_horizon = helioecliptic_from_horizon(sky);
  dark.icrs_from_horizon = glm::transpose(sky.stars.horizon_from_icrs);
  dark.zodiacal_scale = std::pow(sky.sun.distance / astronomical_unit, -2.3);
  dark.sin_sun_radius = sun.shading.sin_radius;
  dark.dust_corona = sun.shading.f_corona;
  dark.airglow =
      airglow_s10(options.solar_flux_sfu.value_or(80.0 + 120.0 * solar_activity(sky.instant))) * airglow_unit;
  dark.glow = options.glow;
  dark.milky_way = options.milky_way;
  return dark;
}

Vec4 zodiacal_light(const DarkSky& sky, const Vec3& direction) {
  const Vec3 helioecliptic = sky.helioecliptic_from_horizon * direction;
  return glm::max(sky.zodiacal_scale * zodiacal_luminance(helioecliptic) -
                      f64::dust_in_corona(helioecliptic, sky.sin_sun_radius) * sky.dust_corona,
                  Vec4(0.0));
}

Vec4 faint_starlight(const DarkSky& sky, const Vec3& direction, Angle width) {
  const CubePyramid& map = sky.milky_way != nullptr ? *sky.milky_way : *default_milky_way();
  constexpr double texels_across = 2.0; // of what is mixed between texels, at half its weight
  return map.at(sky.icrs_from_horizon * direction,
                f64::cube_level(width.to(rad) / texels_across, map.levels().front().face_size));
}

Vec4 airglow_above(const DarkSky& sky, double sin_altitude) {
  const Vec2 paths = f64::airglow_paths(std::abs(sin_altitude), 0.0, earth_radius_km);
  return (paths.x + paths.y) * sky.airglow;
}

DarkSkyAir::DarkSkyAir(const Medium& medium, Length height, const std::optional<RefractionConditions>& bending)
    : columns_(medium, height, bending), airglow_(medium, airglow_spectrum()),
      zodiacal_(medium, zodiacal_spectrum(0.5)), starlight_(medium, faint_starlight_spectrum()),
      height_km_(std::max(height.to(kilometre), 0.0)), ground_km_(medium.ground_radius.to(kilometre)) {}

/// Below the horizon those of the mirrored altitude, as the stars have them.
std::vector<double> DarkSkyAir::columns_km(double sin_altitude) const {
  const double horizon = columns_.sin_horizon();
  return columns_.columns_km(horizon + std::abs(sin_altitude - horizon));
}

Vec4 DarkSkyAir::airglow(const DarkSky& sky, double sin_altitude) const {
  const Vec2 paths = f64::airglow_paths(sin_altitude, height_km_, ground_km_);
  if (paths.y == 0.0) {
    return paths.x * sky.airglow;
  }
  return (paths.x + paths.y * airglow_.share(columns_.columns_km(sin_altitude))) * sky.airglow;
}

Vec4 DarkSkyAir::zodiacal_share(double sin_altitude) const { return zodiacal_.share(columns_km(sin_altitude)); }
Vec4 DarkSkyAir::starlight_share(double sin_altitude) const { return starlight_.share(columns_km(sin_altitude)); }

} // namespace vesper
