#include "vesper/sky/moon_samples.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

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

/// \param at on the unit sphere
MoonSample sample_at(const MoonMap& map, int face, const Vec2& place, const Vec3& at, double solid_angle) {
  const f64::vec4 texel = between_texels(map, face, place.x, place.y);
  return {f32::vec3(at), f32::vec3(glm::normalize(f64::vec3(texel.y, texel.z, texel.w))), static_cast<float>(texel.x),
          static_cast<float>(solid_angle)};
}

void hold_sizes(const MoonMap& map, int places) {
  const auto size = static_cast<std::size_t>(std::max(map.face_size, 0));
  if (size == 0 || map.texels.size() != 24 * size * size || places < 1) {
    throw Error(ErrorKind::argument,
                "a map of the Moon with " + std::to_string(map.texels.size()) + " numbers for faces of " +
                    std::to_string(map.face_size) + " texels, at " + std::to_string(places) + " places of each",
                {"", "", "Give six square faces of four numbers a texel, and at least one place"});
  }
}

/// Calls `with(sample, direction to the observer, solid angle in squares of the Moon's radius)` for what is seen.
template <class With> void for_seen(const MoonSamples& samples, const Vec3& observer, const With& with) {
  const f32::vec3 eye(observer);
  for (const MoonSample& sample : samples) {
    const float height = glm::dot(sample.normal, eye) - 1.0F; // of the eye over the sample's horizon
    if (height > 0.0F) {
      const f32::vec3 way = eye - sample.normal;
      const float nearness = f32::inversesqrt(glm::dot(way, way));
      with(sample, nearness * way, sample.solid_angle * height * nearness * nearness * nearness);
    }
  }
}

float sunlit_reflectance(const MoonSample& sample, const f32::vec3& to_observer, const f32::MoonLighting& light) {
  return glm::dot(sample.normal, light.to_sun) > -f32::lunar_relief_reach
             ? f32::lunar_relief_reflectance(sample.normal, sample.relief, to_observer, light.to_sun,
                                             light.sun_radius_rad, light.sun_law)
             : 0.0F;
}

} // namespace

MoonSamples sample_moon(const MoonMap& map, int places) {
  hold_sizes(map, places);
  MoonSamples samples;
  samples.reserve(6 * static_cast<std::size_t>(places));
  // The additive sequence of the plastic number fills a square as evenly as a grid, without its rows.
  const auto along_edge = [](double step, int i) { return 2.0 * std::fmod(step * i, 1.0) - 1.0; };
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < places; ++i) {
      const double right = along_edge(0.7548776662466927, i + 1);
      const double up = along_edge(0.5698402909980532, i + 1);
      const f64::vec3 place = f64::cube_direction(face, {right, up});
      const double radius = glm::length(place);
      samples.push_back(sample_at(map, face, {right, up}, place / radius, 4.0 / (places * radius * radius * radius)));
    }
  }
  return samples;
}

MoonSamples sample_crescent(const MoonMap& map, const Vec3& to_observer, const Vec3& to_sun) {
  hold_sizes(map, 1);
  constexpr double places = 16384.0;
  using std::numbers::pi;
  // Longitudes from the observer towards the Sun, about the axis through the horns.
  const Vec3 horn = glm::normalize(glm::cross(to_observer, to_sun));
  const Vec3 aside = glm::cross(horn, to_observer);
  const double terminator = std::atan2(glm::dot(to_sun, aside), glm::dot(to_sun, to_observer)) - 0.5 * pi;
  const auto reach = static_cast<double>(f32::lunar_relief_reach);
  const double width = 0.5 * pi - terminator + reach;
  const int rows = static_cast<int>(std::ceil(std::sqrt(2.0 * places / width)));
  MoonSamples samples;
  for (int row = 0; row < rows; ++row) {
    const double up = (2 * row + 1.0) / rows - 1.0;
    const double across = std::sqrt(1.0 - up * up);
    const double first = std::max(terminator - std::asin(std::min(reach / across, 1.0)), -0.5 * pi);
    const double span = 0.5 * pi - first;
    const int columns = static_cast<int>(std::ceil(span * rows / 2.0));
    for (int column = 0; column < columns; ++column) {
      const double longitude = first + span * (column + 0.5) / columns;
      const Vec3 at = up * horn + across * (std::cos(longitude) * to_observer + std::sin(longitude) * aside);
      const int face = f64::cube_face(at, 0);
      const Vec3 on_face = glm::transpose(f64::cube_face_axes(face)) * at;
      samples.push_back(sample_at(map, face, Vec2(on_face) / on_face.z, at, 2.0 / rows * span / columns));
    }
  }
  return samples;
}

MoonGlobe moon_globe(MoonMap map, int places) {
  MoonSamples samples = sample_moon(map, places);
  return {std::move(map), std::move(samples)};
}

MoonLightSums sum_moon_light(const MoonSamples& samples, const Vec3& observer, const f64::MoonLighting& lighting,
                             const Mat3& fixed_from_disc) {
  constexpr std::size_t edge = moon_cells_of_edge;
  const f32::MoonLighting light = in_single(lighting);
  // A line of sight along the axes of the disc, in cells from its lower left corner.
  const auto cells_of_sine = static_cast<float>(0.5 * edge * glm::length(observer));
  const f32::vec3 right = cells_of_sine * f32::vec3(fixed_from_disc[0]);
  const f32::vec3 upward = cells_of_sine * f32::vec3(fixed_from_disc[1]);
  const auto cell_at = [](float place) {
    return static_cast<std::size_t>(std::clamp(place + 0.5F * edge, 0.0F, edge - 1.0F));
  };
  MoonLightSums sums;
  sums.cells.resize(edge * edge);
  std::vector<float> seen(edge * edge, 0.0F);
  for_seen(samples, observer, [&](const MoonSample& sample, const f32::vec3& to_observer, float solid_angle) {
    const float weight = solid_angle * sample.albedo;
    const float sun = weight * sunlit_reflectance(sample, to_observer, light);
    const float earth =
        weight * f32::lunar_relief_reflectance(sample.normal, sample.relief, to_observer, light.to_earth,
                                               f32::earth_radius_from_moon_rad, light.earth_law);
    sums.sun += static_cast<double>(sun);
    sums.earth += static_cast<double>(earth);
    const std::size_t cell = cell_at(-glm::dot(to_observer, upward)) * edge + cell_at(-glm::dot(to_observer, right));
    seen[cell] += solid_angle;
    sums.cells[cell].sun += sun;
    sums.cells[cell].earth += earth;
  });
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const float mean = seen[i] > 0.0F ? 1.0F / (std::numbers::pi_v<float> * seen[i]) : 0.0F;
    sums.cells[i] = {mean * sums.cells[i].sun, mean * sums.cells[i].earth};
  }
  sums.sun /= std::numbers::pi;
  sums.earth /= std::numbers::pi;
  return sums;
}

Vec4 sum_moon_light(const MoonSamples& samples, const Vec3& observer, const f64::MoonLighting& lighting,
                    const std::function<Vec4(const Vec3&)>& eclipse_xyzs) {
  const f32::MoonLighting light = in_single(lighting);
  Vec4 sum(0.0);
  for_seen(samples, observer, [&](const MoonSample& sample, const f32::vec3& to_observer, float solid_angle) {
    sum += Vec4(solid_angle * f32::moon_luminance(sample.albedo, sample.normal, sample.relief, to_observer, light,
                                                  f32::vec4(eclipse_xyzs(Vec3(sample.normal)))));
  });
  return sum;
}

void for_sunlit(const MoonSamples& samples, const Vec3& observer, const f64::MoonLighting& lighting,
                const std::function<void(const MoonSample&, double)>& with) {
  const f32::MoonLighting light = in_single(lighting);
  for_seen(samples, observer, [&](const MoonSample& sample, const f32::vec3& to_observer, float solid_angle) {
    const float reflectance = sunlit_reflectance(sample, to_observer, light);
    if (reflectance > 0.0F) {
      with(sample, static_cast<double>(solid_angle * sample.albedo * reflectance) / std::numbers::pi);
    }
  });
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
