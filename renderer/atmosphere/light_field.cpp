#include "vesper/atmosphere/light_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesper {

LightField::LightField(const SampledAir& air, const SpectralAir& optics, const LightFieldSize& size, unsigned threads)
    : model_(air, optics, size, threads) {
  ThreadedLightGatherer gatherer(model_, threads);
  solution_ = solve_light_field(model_, gatherer, threads);
}

LightField::LightField(LightFieldModel model, LightFieldSolution solution)
    : model_(std::move(model)), solution_(std::move(solution)) {}

LightField::ViewRay LightField::view_ray(double radius_km, double cos_zenith) const {
  ViewRay ray;
  ray.direct = model_.ray(radius_km, cos_zenith, 0.04, 0.1);
  ray.later = model_.ray(radius_km, cos_zenith, 0.04, 0.1);
  return ray;
}

LightField::RayLight LightField::light(const ViewRay& ray, double cos_light_zenith, double cos_azimuth,
                                       Angle light_angular_radius) const {
  constexpr std::size_t most = LightFieldModel::most_blocks;
  const std::size_t blocks = model_.blocks();
  const f32::LightPlace place = light_place(ray.direct, cos_light_zenith, cos_azimuth);
  std::array<Lanes, SampledAir::most_components * most> by_scatterer{};
  std::array<Lanes, most> aerosol{};
  std::array<Lanes, most> other{};
  std::array<Lanes, most> ground{};
  std::array<Lanes, most> phase{};
  add_direct(model_, ray.direct, place, static_cast<float>(light_angular_radius.to(rad)), by_scatterer.data(),
             ground.data());
  for (std::size_t s = 0; s < model_.scatterers(); ++s) {
    model_.phase(s, static_cast<double>(place.cos_angle), phase.data());
    for (std::size_t b = 0; b < blocks; ++b) {
      (s == 0 ? other : aerosol)[b] += phase[b] * by_scatterer[s * blocks + b];
    }
  }
  add_scattered(model_, ray.later, place, solution_.tables, other.data(), ground.data());
  RayLight light;
  for (std::size_t l = 0; l < blocks * Lanes::size; ++l) {
    light.single_aerosol[l] = aerosol[l / Lanes::size][l % Lanes::size];
    light.other[l] = other[l / Lanes::size][l % Lanes::size];
    light.ground[l] = ground[l / Lanes::size][l % Lanes::size];
  }
  return light;
}

std::vector<double> LightField::radiance(const SkyQuery& query) const {
  validate(query);
  const Vec3& toward = query.light_direction;
  const Vec3& view = query.view_direction;
  const double level = std::hypot(toward.x, toward.y) * std::hypot(view.x, view.y);
  const double cos_azimuth =
      level > 1.0e-9 ? std::clamp((toward.x * view.x + toward.y * view.y) / level, -1.0, 1.0) : 1.0;
  const RayLight parts = light(view_ray(model_.air().ground_km() + query.height.to(kilometre), view.z), toward.z,
                               cos_azimuth, query.light_angular_radius);
  std::vector<double> radiance;
  for (std::size_t l = 0; l < model_.optics().size(); ++l) {
    radiance.push_back(static_cast<double>(parts.single_aerosol[l] + parts.other[l] + parts.ground[l]));
  }
  return radiance;
}

std::vector<double> LightField::diffuse_irradiance(double cos_light_zenith) const {
  const auto cosine = static_cast<float>(std::clamp(cos_light_zenith, -1.0, 1.0));
  const f32::RealTable places{model_.angle_places().data()};
  const auto blocks = static_cast<std::ptrdiff_t>(model_.blocks());
  std::vector<double> result;
  for (std::size_t l = 0; l < model_.optics().size(); ++l) {
    const f32::LightTable ground{&solution_.tables.ground[l / Lanes::size], blocks};
    result.push_back(
        static_cast<double>(f32::ground_light(cosine, ground, places, model_.shell().angles)[l % Lanes::size]));
  }
  return result;
}

} // namespace vesper
