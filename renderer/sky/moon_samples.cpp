#include "vesper/sky/moon_samples.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace vesper {
namespace {

/// The map's four numbers between the texels of one face.
f64::vec4 between_texels(const MoonMap& map, int face, double right, double up) {
  const auto at = [&](double place) {
    return std::clamp(0.5 * (place + 1.0) * map.face_size - 0.5, 0.0, map.face_size - 1.0);
  };
  const double x = at(right);
  const double y = at(-up);
  const auto texel = [&](double column, double row) {
    const auto i = static_cast<std::size_t>((face * map.face_size + row) * map.face_size + column) * 4;
    return f64::vec4(map.texels[i], map.texels[i + 1], map.texels[i + 2], map.texels[i + 3]);
  };
  const double left = std::floor(x);
  const double top = std::floor(y);
  const double next_x = std::min(left + 1.0, map.face_size - 1.0);
  const double next_y = std::min(top + 1.0, map.face_size - 1.0);
  return f64::mix(f64::mix(texel(left, top), texel(next_x, top), x - left),
                  f64::mix(texel(left, next_y), texel(next_x, next_y), x - left), y - top);
}

void hold_sizes(const MoonMap& map, int cells) {
  const auto size = static_cast<std::size_t>(std::max(map.face_size, 0));
  if (size == 0 || map.texels.size() != 24 * size * size || cells < 1) {
    throw Error(ErrorKind::argument,
                "a map of the Moon with " + std::to_string(map.texels.size()) + " numbers for faces of " +
                    std::to_string(map.face_size) + " texels, in " + std::to_string(cells) + " cells",
                {"", "", "Give six square faces of four numbers a texel, and at least one cell"});
  }
}

/// What a sample shows an observer.
struct SeenSample {
  float weight; ///< solid angle of its share of the disc, in squares of the Moon's radius
  f32::vec3 to_observer;
};

SeenSample seen(const MoonSample& sample, const f32::vec3& observer) {
  const f32::vec3 way = observer - sample.normal;
  const float distance = glm::length(way);
  const f32::vec3 to_observer = way / distance;
  return {sample.solid_angle * glm::dot(sample.normal, to_observer) / (distance * distance), to_observer};
}

} // namespace

MoonSamples sample_moon(const MoonMap& map, int cells) {
  hold_sizes(map, cells);
  MoonSamples samples;
  samples.reserve(6 * static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
  // Places inside the cells follow the additive sequence of the plastic number: as even as a grid, without its rows.
  const auto inside = [](double step, std::size_t i) { return std::fmod(step * static_cast<double>(i), 1.0); };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < cells; ++row) {
      for (int column = 0; column < cells; ++column) {
        const double right = 2.0 * (column + inside(0.7548776662466927, samples.size())) / cells - 1.0;
        const double up = 1.0 - 2.0 * (row + inside(0.5698402909980532, samples.size())) / cells;
        const f64::vec3 place = f64::cube_direction(face, {right, up});
        const double radius = glm::length(place);
        const f64::vec4 texel = between_texels(map, face, right, up);
        samples.push_back({f32::vec3(place / radius), f32::vec3(glm::normalize(f64::vec3(texel.y, texel.z, texel.w))),
                           static_cast<float>(texel.x),
                           static_cast<float>(4.0 / (cells * cells * radius * radius * radius))});
      }
    }
  }
  return samples;
}

MoonLightSums sum_moon_light(const MoonSamples& samples, const Vec3& observer, const f64::MoonLighting& lighting) {
  const f32::MoonLighting light = in_single(lighting);
  const f32::vec3 eye(observer);
  MoonLightSums sums;
  for (const MoonSample& sample : samples) {
    const SeenSample view = seen(sample, eye);
    if (view.weight <= 0.0F) {
      continue;
    }
    const float weight = view.weight * sample.albedo;
    sums.earth += static_cast<double>(
        weight * f32::lunar_relief_reflectance(sample.normal, sample.relief, view.to_observer, light.to_earth,
                                               f32::earth_radius_from_moon_rad, light.earth_law));
    if (glm::dot(sample.normal, light.to_sun) > -f32::lunar_relief_reach) {
      sums.sun += static_cast<double>(weight * f32::lunar_relief_reflectance(sample.normal, sample.relief,
                                                                             view.to_observer, light.to_sun,
                                                                             light.sun_radius_rad, light.sun_law));
    }
  }
  return {sums.sun / std::numbers::pi, sums.earth / std::numbers::pi};
}

Vec4 sum_moon_light(const MoonSamples& samples, const Vec3& observer, const f64::MoonLighting& lighting,
                    const std::function<Vec4(const Vec3&)>& eclipse_xyzs) {
  const f32::MoonLighting light = in_single(lighting);
  const f32::vec3 eye(observer);
  Vec4 sum(0.0);
  for (const MoonSample& sample : samples) {
    const SeenSample view = seen(sample, eye);
    if (view.weight > 0.0F) {
      sum += Vec4(view.weight * f32::moon_luminance(sample.albedo, sample.normal, sample.relief, view.to_observer,
                                                    light, f32::vec4(eclipse_xyzs(Vec3(sample.normal)))));
    }
  }
  return sum;
}

f32::MoonLighting in_single(const f64::MoonLighting& lighting) {
  const auto law = [](const f64::LunarLaw& from) {
    return f32::LunarLaw{static_cast<float>(from.seeliger), static_cast<float>(from.lambert)};
  };
  return {f32::vec3(lighting.to_sun),
          f32::vec3(lighting.to_earth),
          f32::vec4(lighting.sunlit),
          f32::vec4(lighting.earthlit),
          law(lighting.sun_law),
          law(lighting.earth_law),
          static_cast<float>(lighting.sun_radius_rad)};
}

} // namespace vesper
