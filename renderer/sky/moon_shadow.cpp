#include "vesper/sky/moon_shadow.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/sky/eclipse_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace vesper {
namespace {

constexpr int share_nodes = 256;

struct Bodies {
  Vec3 sun_km;
  Vec3 moon_km;
};

Bodies bodies_of(const SkyState& sky) {
  return {sky.sun.distance.to(kilometre) * sky.sun.direction_horizon,
          sky.moon.place.distance.to(kilometre) * sky.moon.place.direction_horizon};
}

std::optional<f32::MoonShadow> geometry_of(const Bodies& bodies) {
  const double sun_distance_km = glm::length(bodies.sun_km);
  const Vec3 to_sun = bodies.sun_km / sun_distance_km;
  const double moon_along_km = glm::dot(bodies.moon_km, to_sun);
  const double moon_radius_km = moon_radius_ratio * earth_equatorial_radius_km;
  const double sun_radius_km = sun_radius.to(kilometre);
  const double reach_km = eclipsed_air_distance.to(kilometre);
  // Behind the observer the Moon hides no Sun.
  if (!(moon_along_km > 2.0 * reach_km)) {
    return std::nullopt;
  }
  const Vec3 moon_aside_km = bodies.moon_km - moon_along_km * to_sun;
  const double penumbra_km = moon_radius_km + sun_radius_km / sun_distance_km * (moon_along_km + reach_km);
  if (glm::length(moon_aside_km) > penumbra_km + reach_km) {
    return std::nullopt;
  }
  return f32::MoonShadow{f32::vec3(to_sun),
                         f32::vec3(moon_aside_km),
                         static_cast<float>(moon_along_km),
                         static_cast<float>(moon_radius_km),
                         static_cast<float>(sun_distance_km),
                         static_cast<float>(sun_radius_km)};
}

/// Of a node of the table over the gap, for discs as the observer sees them: by wavelength, corona included.
std::vector<double> shares_at(int node, const f32::MoonShadow& shadow, std::span<const double> wavelengths_nm) {
  const f32::vec3 discs = f32::moon_shadow_discs({0.0F, 0.0F, 0.0F}, shadow);
  const auto sun = static_cast<double>(discs.x);
  const auto moon = static_cast<double>(discs.y);
  const double gap = f64::moon_shadow_node_gap(static_cast<double>(node) / (share_nodes - 1));
  SolarEclipseState eclipse;
  eclipse.sun_semidiameter = sun * rad;
  eclipse.moon_semidiameter = moon * rad;
  eclipse.separation = std::max(0.0, (2.0 * gap - 1.0) * sun + moon) * rad;
  const Spectrum past_moon = sunlight_past_moon(eclipse);
  std::vector<double> shares;
  for (const double nm : wavelengths_nm) {
    shares.push_back(past_moon(std::clamp(nm, past_moon.wavelengths_nm().front(), past_moon.wavelengths_nm().back())));
  }
  return shares;
}

std::optional<MoonShadowInAir> shadow_of(const Bodies& bodies, std::span<const double> wavelengths_nm) {
  const std::optional<f32::MoonShadow> shadow = geometry_of(bodies);
  if (!shadow) {
    return std::nullopt;
  }
  if (wavelengths_nm.empty()) {
    return MoonShadowInAir{*shadow, {}};
  }
  MoonShadowInAir result{*shadow, std::vector<f32::vec4>(share_nodes, f32::vec4(0.0F))};
  for (int node = 0; node < share_nodes; ++node) {
    const std::vector<double> shares = shares_at(node, *shadow, wavelengths_nm);
    for (std::size_t l = 0; l < shares.size(); ++l) {
      result.shares[static_cast<std::size_t>(node)][static_cast<int>(l)] = static_cast<float>(shares[l]);
    }
  }
  return result;
}

} // namespace

std::optional<MoonShadowInAir> moon_shadow(const Vec3& sun_km, const Vec3& moon_km,
                                           std::span<const double> wavelengths_nm) {
  return shadow_of({sun_km, moon_km}, wavelengths_nm);
}

std::optional<MoonShadowInAir> moon_shadow(const SkyState& sky, std::span<const double> wavelengths_nm) {
  return shadow_of(bodies_of(sky), wavelengths_nm);
}

LightShare moon_shadow_share(const SkyState& sky, std::span<const double> wavelengths_nm) {
  const std::optional<f32::MoonShadow> shadow = geometry_of(bodies_of(sky));
  if (!shadow) {
    return {};
  }
  std::vector<double> table;
  for (int node = 0; node < share_nodes; ++node) {
    const std::vector<double> shares = shares_at(node, *shadow, wavelengths_nm);
    table.insert(table.end(), shares.begin(), shares.end());
  }
  return [shadow = *shadow, table = std::move(table)](const Vec3& place_km, std::span<double> values) {
    const float gap = f32::moon_shadow_gap(f32::moon_shadow_discs(f32::vec3(place_km), shadow));
    const double place = static_cast<double>(f32::moon_shadow_gap_place(gap)) * (share_nodes - 1);
    const std::size_t node = std::min(static_cast<std::size_t>(place), std::size_t{share_nodes - 2});
    const double t = place - static_cast<double>(node);
    const double* low = &table[node * values.size()];
    for (std::size_t l = 0; l < values.size(); ++l) {
      values[l] *= low[l] + t * (low[l + values.size()] - low[l]);
    }
  };
}

} // namespace vesper
