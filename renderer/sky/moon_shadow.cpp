#include "vesper/sky/moon_shadow.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/sky/eclipse_light.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

constexpr int share_nodes = 256;

f32::vec3 narrow(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

} // namespace

std::optional<MoonShadowInAir> moon_shadow(const Vec3& sun_km, const Vec3& moon_km,
                                           std::span<const double> wavelengths_nm) {
  const double sun_distance_km = glm::length(sun_km);
  const Vec3 to_sun = sun_km / sun_distance_km;
  const double moon_along_km = glm::dot(moon_km, to_sun);
  const double moon_radius_km = moon_radius_ratio * earth_equatorial_radius_km;
  const double sun_radius_km = sun_radius.to(kilometre);
  const double reach_km = eclipsed_air_distance.to(kilometre);
  // On the other side of the Earth's sky there is no eclipse, nor where the Moon is not well in front of the air.
  if (moon_along_km <= 2.0 * reach_km) {
    return std::nullopt;
  }
  const Vec3 moon_aside_km = moon_km - moon_along_km * to_sun;
  const double sun_rad = sun_radius_km / sun_distance_km;
  const double moon_rad = moon_radius_km / moon_along_km;
  const double penumbra_km = moon_radius_km + sun_rad * (moon_along_km + reach_km);
  if (glm::length(moon_aside_km) > penumbra_km + reach_km) {
    return std::nullopt;
  }
  MoonShadowInAir result;
  result.shadow = {narrow(to_sun),
                   narrow(moon_aside_km),
                   static_cast<float>(moon_along_km),
                   static_cast<float>(moon_radius_km),
                   static_cast<float>(sun_distance_km),
                   static_cast<float>(sun_radius_km)};
  result.shares.resize(share_nodes, f32::vec4(0.0F));
  for (int i = 0; i < share_nodes; ++i) {
    const double gap = f64::moon_shadow_node_gap(static_cast<double>(i) / (share_nodes - 1));
    const double separation = std::max(0.0, (2.0 * gap - 1.0) * sun_rad + moon_rad);
    for (std::size_t l = 0; l < std::min<std::size_t>(wavelengths_nm.size(), 4); ++l) {
      result.shares[static_cast<std::size_t>(i)][static_cast<int>(l)] =
          static_cast<float>(sunlight_seen(sun_rad, moon_rad, separation, limb_darkening_power(wavelengths_nm[l])));
    }
  }
  return result;
}

std::optional<MoonShadowInAir> moon_shadow(const SkyState& sky, std::span<const double> wavelengths_nm) {
  return moon_shadow(sky.sun.distance.to(kilometre) * sky.sun.direction_horizon,
                     sky.moon.place.distance.to(kilometre) * sky.moon.place.direction_horizon, wavelengths_nm);
}

} // namespace vesper
