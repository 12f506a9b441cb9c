#include "vesper/atmosphere/light_gathering.hpp"

#include "vesper/base/sine.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

f32::LightTable block(const std::vector<Lanes>& lights, std::size_t b, std::size_t blocks) {
  return {lights.data() + b, static_cast<std::ptrdiff_t>(blocks)};
}

} // namespace

f32::LightPlace light_place(const LightRay& ray, double cos_light_zenith, double cos_azimuth) {
  const double level = sine_of(cos_light_zenith) * cos_azimuth;
  return {static_cast<float>(cos_light_zenith), static_cast<float>(level),
          static_cast<float>(ray.cos_zenith * cos_light_zenith + ray.sin_zenith * level)};
}

void add_direct(const LightFieldModel& model, const LightRay& ray, const f32::LightPlace& light, float light_radius_rad,
                Lanes* by_scatterer, Lanes* by_ground) {
  const std::size_t blocks = model.blocks();
  const f32::LightShell shell = model.shell();
  const Lanes* weights = ray.weights.data();
  for (const f32::LightStep& step : ray.steps) {
    const Lanes* own = weights;
    weights += model.scatterers() * blocks;
    const float cosine = f32::light_cosine(step, light);
    const float visible = f32::visible_light(cosine, step.height_km, shell.ground_km, light_radius_rad);
    if (visible <= 0.0F) {
      continue;
    }
    const f32::DepthPlace place = f32::depth_place(step, cosine, shell);
    for (std::size_t b = 0; b < blocks; ++b) {
      const Lanes arriving = visible * f32::light_transmittance(place, block(model.depths(), b, blocks));
      for (std::size_t s = b; s < model.scatterers() * blocks; s += blocks) {
        by_scatterer[s] += own[s] * arriving;
      }
    }
  }
  if (ray.meets_ground) {
    const float cosine = f32::light_cosine(ray.ground, light);
    const float visible = std::max(0.0F, cosine) * f32::visible_light(cosine, 0.0F, shell.ground_km, light_radius_rad);
    if (visible > 0.0F) {
      const f32::DepthPlace place = f32::depth_place(ray.ground, cosine, shell);
      for (std::size_t b = 0; b < blocks; ++b) {
        by_ground[b] +=
            visible * ray.ground_weights[b] * f32::light_transmittance(place, block(model.depths(), b, blocks));
      }
    }
  }
}

void add_scattered(const LightFieldModel& model, const LightRay& ray, const f32::LightPlace& light,
                   const LightFieldTables& tables, Lanes* by_air, Lanes* by_ground) {
  const std::size_t blocks = model.blocks();
  const std::size_t scatterers = model.scatterers();
  const f32::LightShell shell = model.shell();
  const f32::RealTable places{model.angle_places().data()};
  const Lanes* weights = ray.weights.data();
  for (const f32::LightStep& step : ray.steps) {
    const Lanes* own = weights;
    weights += scatterers * blocks;
    const float cosine = f32::light_cosine(step, light);
    const f32::FieldPlace place = f32::field_place(step, cosine, light, shell, places);
    for (std::size_t b = 0; b < blocks; ++b) {
      by_air[b] += own[b] * f32::scattered_by_molecules(place, model.second_moment()[b], block(tables.field, b, blocks),
                                                        shell.angles);
    }
    if (place.source < 0) {
      continue;
    }
    for (std::size_t b = 0; b < blocks; ++b) {
      Lanes aerosol = own[blocks + b];
      for (std::size_t s = 2; s < scatterers; ++s) {
        aerosol += own[s * blocks + b];
      }
      by_air[b] += aerosol * f32::scattered_by_aerosol(place, block(tables.sources, b, blocks), shell.angles);
    }
  }
  if (ray.meets_ground) {
    const float cosine = f32::light_cosine(ray.ground, light);
    for (std::size_t b = 0; b < blocks; ++b) {
      by_ground[b] +=
          ray.ground_weights[b] * f32::ground_light(cosine, block(tables.ground, b, blocks), places, shell.angles);
    }
  }
}

} // namespace vesper
