#include "baselines/table_mapping.hpp"

#include <algorithm>
#include <cmath>

namespace vesper::baseline {
namespace {

float root(float x) { return std::sqrt(std::max(x, 0.0F)); }
float cosine(float x) { return std::clamp(x, -1.0F, 1.0F); }
float last(int size) { return static_cast<float>(size - 1); }
/// 0 to 1 from the shortest to the longest distance.
float share(float distance, float shortest, float longest) {
  return longest > shortest ? std::clamp((distance - shortest) / (longest - shortest), 0.0F, 1.0F) : 0.0F;
}

} // namespace

float Shell::longest_level_km() const { return std::sqrt(top_km * top_km - ground_km * ground_km); }
float Shell::horizon_km(float r) const { return root(r * r - ground_km * ground_km); }
float Shell::to_top_km(float r, float mu) const {
  return std::max(root(r * r * (mu * mu - 1.0F) + top_km * top_km) - r * mu, 0.0F);
}
float Shell::to_ground_km(float r, float mu) const {
  return std::max(-r * mu - root(r * r * (mu * mu - 1.0F) + ground_km * ground_km), 0.0F);
}
bool Shell::meets_ground(float r, float mu) const {
  return mu < 0.0F && r * r * (mu * mu - 1.0F) + ground_km * ground_km >= 0.0F;
}
float Shell::to_edge_km(float r, float mu, bool to_ground) const {
  return to_ground ? to_ground_km(r, mu) : to_top_km(r, mu);
}

float sun_span_2017(const Shell& shell, float lowest_mu_s) {
  return -2.0F * lowest_mu_s * shell.ground_km / (shell.longest_level_km() - (shell.top_km - shell.ground_km));
}

float sun_span_revised(const Shell& shell, float lowest_mu_s) {
  const float shortest = shell.top_km - shell.ground_km;
  return (shell.to_top_km(shell.ground_km, lowest_mu_s) - shortest) / (shell.longest_level_km() - shortest);
}

TransmittanceTexel transmittance_texel(const Shell& shell, const TableSizes& sizes, RayPlace ray) {
  const float level = shell.longest_level_km();
  const float horizon = shell.horizon_km(ray.r);
  const float x_mu = share(shell.to_top_km(ray.r, ray.mu), shell.top_km - ray.r, horizon + level);
  return {x_mu * last(sizes.transmittance_mu), horizon / level * last(sizes.transmittance_r)};
}

RayPlace transmittance_ray(const Shell& shell, const TableSizes& sizes, TransmittanceTexel texel) {
  const float level = shell.longest_level_km();
  const float horizon = level * texel.r / last(sizes.transmittance_r);
  const float r = std::sqrt(horizon * horizon + shell.ground_km * shell.ground_km);
  const float shortest = shell.top_km - r;
  const float distance = shortest + texel.mu / last(sizes.transmittance_mu) * (horizon + level - shortest);
  const float mu = distance == 0.0F
                       ? 1.0F
                       : cosine((level * level - horizon * horizon - distance * distance) / (2.0F * r * distance));
  return {r, mu};
}

IrradianceTexel irradiance_texel(const Shell& shell, const TableSizes& sizes, float r, float mu_s) {
  return {(0.5F * mu_s + 0.5F) * last(sizes.irradiance_mu_s),
          (r - shell.ground_km) / (shell.top_km - shell.ground_km) * last(sizes.irradiance_r)};
}

SunPlace irradiance_sun(const Shell& shell, const TableSizes& sizes, IrradianceTexel texel) {
  return {shell.ground_km + texel.r / last(sizes.irradiance_r) * (shell.top_km - shell.ground_km),
          cosine(2.0F * texel.mu_s / last(sizes.irradiance_mu_s) - 1.0F)};
}

ScatteringTexel scattering_texel(const Shell& shell, const TableSizes& sizes, const ScatteringPlace& place) {
  const float level = shell.longest_level_km();
  const float horizon = shell.horizon_km(place.r);
  const float last_of_half = last(sizes.scattering_mu / 2);
  const float distance = shell.to_edge_km(place.r, place.mu, place.meets_ground);
  const float mu = place.meets_ground
                       ? last_of_half * (1.0F - share(distance, place.r - shell.ground_km, horizon))
                       : last_of_half + 1.0F + last_of_half * share(distance, shell.top_km - place.r, horizon + level);

  const float shortest = shell.top_km - shell.ground_km;
  const float a = (shell.to_top_km(shell.ground_km, place.mu_s) - shortest) / (level - shortest);
  const float x_mu_s = std::max(1.0F - a / shell.sun_span, 0.0F) / (1.0F + a);
  return {horizon / level * last(sizes.scattering_r), mu, x_mu_s * last(sizes.scattering_mu_s),
          (0.5F * place.nu + 0.5F) * last(sizes.scattering_nu)};
}

ScatteringPlace scattering_place(const Shell& shell, const TableSizes& sizes, const ScatteringTexel& texel) {
  const float level = shell.longest_level_km();
  const float horizon = level * texel.r / last(sizes.scattering_r);
  const float r = std::sqrt(horizon * horizon + shell.ground_km * shell.ground_km);

  const float last_of_half = last(sizes.scattering_mu / 2);
  const bool meets_ground = texel.mu < last_of_half + 0.5F;
  float mu = 0.0F;
  if (meets_ground) {
    const float shortest = r - shell.ground_km;
    const float distance = shortest + (1.0F - texel.mu / last_of_half) * (horizon - shortest);
    mu = distance == 0.0F ? -1.0F : cosine(-(horizon * horizon + distance * distance) / (2.0F * r * distance));
  } else {
    const float shortest = shell.top_km - r;
    const float distance = shortest + (texel.mu - last_of_half - 1.0F) / last_of_half * (horizon + level - shortest);
    mu = distance == 0.0F ? 1.0F
                          : cosine((level * level - horizon * horizon - distance * distance) / (2.0F * r * distance));
  }

  const float x_mu_s = texel.mu_s / last(sizes.scattering_mu_s);
  const float shortest = shell.top_km - shell.ground_km;
  const float a = (1.0F - x_mu_s) * shell.sun_span / (1.0F + x_mu_s * shell.sun_span);
  const float distance = shortest + std::min(a, shell.sun_span) * (level - shortest);
  const float mu_s =
      distance == 0.0F ? 1.0F : cosine((level * level - distance * distance) / (2.0F * shell.ground_km * distance));

  const float spread = root((1.0F - mu * mu) * (1.0F - mu_s * mu_s));
  const float nu = 2.0F * texel.nu / last(sizes.scattering_nu) - 1.0F;
  return {r, mu, mu_s, std::clamp(nu, mu * mu_s - spread, mu * mu_s + spread), meets_ground};
}

} // namespace vesper::baseline
