#include "baselines/mapped_sky.hpp"

#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace vesper::baseline {
namespace {

using std::numbers::pi;

constexpr Angle light_radius = 0.2666 * deg;

double rayleigh(double cos_angle) { return 3.0 / (16.0 * pi) * (1.0 + cos_angle * cos_angle); }

double cos_between(const SkyPlace& place) {
  return std::sin(place.view_rad) * std::sin(place.light_rad) +
         std::cos(place.view_rad) * std::cos(place.light_rad) * place.cos_azimuth;
}

glm::vec4 log2_of(const glm::vec4& light) { return glm::log2(glm::max(light, glm::vec4(1.0e-30F))); }

} // namespace

LightField::ViewRay view_ray(const LightField& field, const SampledAir& air, const SkyPlace& place) {
  // Where a ray has no length there is no light; the lookups come from inside too.
  const double height = std::clamp(place.height_km, 1.0e-3, air.top_km() - air.ground_km() - 0.05);
  const double dip = std::acos(air.ground_km() / (air.ground_km() + height));
  constexpr double aside_rad = 2.0e-6;
  const double altitude =
      place.meets_ground ? std::min(place.view_rad, -dip - aside_rad) : std::max(place.view_rad, -dip + aside_rad);
  return field.view_ray(air.ground_km() + height, std::sin(altitude));
}

MappedSky::MappedSky(const SkyMapping& mapping, const LightField& field, const SampledAir& air,
                     const Responses& responses, std::function<double(double)> aerosol_phase)
    : mapping_(mapping), aerosol_phase_(std::move(aerosol_phase)) {
  const SkyMappingSize& size = mapping.size();
  const auto row = static_cast<std::size_t>(size.lights) * static_cast<std::size_t>(size.azimuths);
  const auto rows = static_cast<std::size_t>(size.heights) * static_cast<std::size_t>(size.views);
  aerosol_.resize(rows * row);
  other_.resize(rows * row);
  parallel_for(rows, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const int height = static_cast<int>(i) / size.views;
      const int view = static_cast<int>(i) % size.views;
      const LightField::ViewRay ray = view_ray(field, air, mapping.node(height, view, 0, 0));
      for (int l = 0; l < size.lights; ++l) {
        for (int a = 0; a < size.azimuths; ++a) {
          const SkyPlace place = mapping.node(height, view, l, a);
          const LightField::RayLight light =
              field.light(ray, std::sin(place.light_rad), place.cos_azimuth, light_radius);
          const double cos_angle = cos_between(place);
          const std::size_t texel = i * row + static_cast<std::size_t>(l * size.azimuths + a);
          other_[texel] = responses(light.other) / static_cast<float>(rayleigh(cos_angle));
          aerosol_[texel] = responses(light.single_aerosol) / static_cast<float>(aerosol_phase_(cos_angle));
        }
      }
    }
  });
}

glm::vec4 MappedSky::light(const SkyPlace& place, Between between) const {
  const SkyMappingSize& size = mapping_.size();
  const std::array<double, 4> at = mapping_.texel(place);
  const std::array<int, 4> counts{size.heights, size.views, size.lights, size.azimuths};
  std::array<int, 4> low{};
  std::array<double, 4> fraction{};
  for (std::size_t axis = 0; axis < 4; ++axis) {
    low[axis] = std::clamp(static_cast<int>(at[axis]), 0, counts[axis] - 2);
    fraction[axis] = std::clamp(at[axis] - low[axis], 0.0, 1.0);
  }
  glm::vec4 other(0.0F);
  glm::vec4 aerosol(0.0F);
  for (unsigned corner = 0; corner < 16; ++corner) {
    double weight = 1.0;
    std::size_t texel = 0;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const int up = static_cast<int>((corner >> axis) & 1U);
      weight *= up == 1 ? fraction[axis] : 1.0 - fraction[axis];
      texel = texel * static_cast<std::size_t>(counts[axis]) + static_cast<std::size_t>(low[axis] + up);
    }
    if (weight == 0.0) {
      continue;
    }
    const auto w = static_cast<float>(weight);
    other += w * (between == Between::values ? other_[texel] : log2_of(other_[texel]));
    aerosol += w * (between == Between::values
                        ? aerosol_[texel]
                        : glm::max(log2_of(aerosol_[texel]), log2_of(other_[texel]) + glm::vec4(-14.0F)));
  }
  if (between == Between::logarithms) {
    other = glm::exp2(other);
    aerosol = glm::exp2(aerosol);
  }
  const double cos_angle = cos_between(place);
  return static_cast<float>(rayleigh(cos_angle)) * other + static_cast<float>(aerosol_phase_(cos_angle)) * aerosol;
}

} // namespace vesper::baseline
