#include "vesper/atmosphere/spread_light.hpp"

#include "vesper/atmosphere/level_illuminance.hpp"
#include "vesper/base/gauss_legendre.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr std::size_t ring_count = 10;
constexpr int ring_samples = 24; // spread_light_width apart on the horizon
constexpr std::size_t turn_nodes = 6;

/// Rings with the length of altitude that each stands for.
std::vector<std::pair<Angle, double>> ring_rule(Angle lowest) {
  std::vector<std::pair<Angle, double>> rings;
  const Angle range = 90.0 * deg - lowest;
  for (const QuadratureNode& node : gauss_legendre(ring_count)) {
    const Angle altitude = lowest + node.place * range;
    rings.emplace_back(altitude, node.weight * range.to(rad) * std::cos(altitude.to(rad)));
  }
  return rings;
}

Vec3 toward_azimuth(Angle altitude, double azimuth_rad) {
  const double level = std::cos(altitude.to(rad));
  return {level * std::sin(azimuth_rad), level * std::cos(azimuth_rad), std::sin(altitude.to(rad))};
}

} // namespace

Angle lowest_spread_light(const SkyTables& tables, Length height) {
  const auto height_km = static_cast<float>(height.to(kilometre));
  const bool outside = height_km > tables.frame.top_km - tables.frame.ground_km;
  return outside ? -90.0 * deg : -static_cast<double>(f32::sky_dip(height_km, tables.frame)) * rad;
}

SpreadLight spread_light(Angle lowest, const std::function<double(const Vec3&)>& luminance) {
  SpreadLight light;
  for (const auto& [altitude, length] : ring_rule(lowest)) {
    SpreadLight::Ring& ring = light.rings.emplace_back();
    ring.altitude = altitude;
    for (int k = 0; k < ring_samples; ++k) {
      const double azimuth = 2.0 * pi * k / ring_samples;
      const double part = luminance(toward_azimuth(altitude, azimuth)) * length * 2.0 * pi / ring_samples;
      ring.even += part;
      ring.first += part * Vec2(std::cos(azimuth), std::sin(azimuth));
      ring.second += part * Vec2(std::cos(2.0 * azimuth), std::sin(2.0 * azimuth));
    }
  }
  return light;
}

SpreadLightViews::SpreadLightViews(std::shared_ptr<const SkyTables> tables, Length height,
                                   const std::vector<Angle>& views)
    : tables_(std::move(tables)), height_(height), lowest_(lowest_spread_light(*tables_, height)), rings_(ring_count) {
  const auto rings = ring_rule(lowest_);
  const std::vector<QuadratureNode> rule = gauss_legendre(turn_nodes);
  for (const auto& [altitude, length] : rings) {
    illuminance_.push_back(vector_of(diffuse_illuminance(*tables_, height_, altitude)));
  }
  harmonics_.reserve(views.size() * rings.size());
  for (const Angle view : views) {
    for (const auto& [altitude, length] : rings) {
      Harmonics& sums = harmonics_.emplace_back();
      for (const QuadratureNode& node : rule) {
        // Crowded where view and light are near to each other, about whose line aerosol makes a peak.
        const double turn = pi * node.place * node.place;
        const double weight = 2.0 * node.place * node.weight;
        const Vec4 seen = weight * vector_of(sky_luminance(*tables_, {height_, toward_azimuth(altitude, turn), Angle(),
                                                                      toward_azimuth(view, 0.0)}));
        sums.even += seen;
        sums.first += 2.0 * std::cos(turn) * seen;
        sums.second += 2.0 * std::cos(2.0 * turn) * seen;
      }
    }
  }
}

Vec4 SpreadLightViews::luminance(std::size_t view, Angle azimuth, const SpreadLight& light) const {
  const double once = azimuth.to(rad);
  const Vec2 first(std::cos(once), std::sin(once));
  const Vec2 second(std::cos(2.0 * once), std::sin(2.0 * once));
  Vec4 sum(0.0);
  for (std::size_t i = 0; i < rings_; ++i) {
    const SpreadLight::Ring& ring = light.rings[i];
    const Harmonics& harmonics = harmonics_[view * rings_ + i];
    sum += ring.even * harmonics.even + glm::dot(ring.first, first) * harmonics.first +
           glm::dot(ring.second, second) * harmonics.second;
  }
  return sum;
}

Vec4 SpreadLightViews::illuminance(const SpreadLight& light) const {
  Vec4 sum(0.0);
  for (std::size_t i = 0; i < rings_; ++i) {
    sum += light.rings[i].even * illuminance_[i];
  }
  return sum;
}

} // namespace vesper
