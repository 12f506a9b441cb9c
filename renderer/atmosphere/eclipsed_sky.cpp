#include "vesper/atmosphere/eclipsed_sky.hpp"

#include "vesper/base/fourier.hpp"
#include "vesper/base/gauss_legendre.hpp"
#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr int view_steps = 48;

/// Share of the diffuse light that there is at the least, where the chart does not reach: as in the middle of an umbra
/// 160 km wide, by the reference transport.
constexpr float least_diffuse = 2.0e-4F;

f32::sampler2D plane_of(const std::vector<f32::vec4>& texels, int width) {
  return {texels.data(), width, static_cast<int>(texels.size()) / width};
}

f32::vec4 direct_light(const SmallSkyTables& small, float height_km, float sin_light) {
  return f32::small_sky_light(plane_of(small.transmittance, small.transmittance_frame.altitudes), height_km, sin_light,
                              small.transmittance_frame, small.frame);
}

} // namespace

f32::vec4 sunlight_at(const MoonShadowInAir& in_air, const f32::vec3& place_km) {
  return f32::moon_shadow_light({in_air.shares.data(), static_cast<int>(in_air.shares.size())},
                                static_cast<int>(in_air.shares.size()), place_km, in_air.shadow);
}

/// Of the chart: the nodes around it with their shares, and how much of the chart is to be trusted.
struct EclipsedSky::Place {
  std::size_t column, row, level;
  float right, down, up;
  float trust;
};

/// Radiances by wavelength, with the Moon and without.
struct EclipsedSky::Light {
  struct Pair {
    f32::vec4 eclipsed{0.0F};
    f32::vec4 open{0.0F};
  };
  Pair aerosol; ///< over its phase function
  Pair other;
};

EclipsedSky::EclipsedSky(std::shared_ptr<const EclipsedAir> air, MoonShadowInAir shadow, Length height,
                         unsigned threads)
    : air_(std::move(air)), shadow_(std::move(shadow)), height_km_(height.to(kilometre)),
      chart_(EclipsedAir::places * side * side) {
  parallel_for(
      air_->wavelengths_nm().size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t l = begin; l < end; ++l) {
          fill_chart(l);
        }
      },
      threads);
}

void EclipsedSky::fill_chart(std::size_t wavelength) {
  using Complex = std::complex<double>;
  const auto channel = static_cast<int>(wavelength);
  const SmallSkyTables& small = *air_->tables().small;
  const auto ground_km = static_cast<double>(small.frame.ground_km);
  const Vec3 to_sun(shadow_.shadow.to_sun);
  // Sunlight with the Moon in the real parts, without it in the imaginary ones: what the air makes of them is real.
  std::vector<std::vector<Complex>> planes(EclipsedAir::places, std::vector<Complex>(side * side));
  const auto offset_km = [](std::size_t i) { return (static_cast<double>(i) - 0.5 * side) * spacing_km; };
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      // Along great circles from the observer.
      const double east = offset_km(column);
      const double north = offset_km(row);
      const double distance = std::max(std::hypot(east, north), 1.0e-9);
      const double turn = distance / ground_km;
      const Vec3 up(std::sin(turn) * east / distance, std::sin(turn) * north / distance, std::cos(turn));
      const double sin_light = glm::dot(up, to_sun);
      for (std::size_t i = 0; i < EclipsedAir::places; ++i) {
        const bool on_ground = i == EclipsedAir::ground;
        const double height = on_ground ? 0.0 : static_cast<double>(EclipsedAir::heights_km[i]);
        const Vec3 at = (ground_km + height) * up - Vec3(0.0, 0.0, ground_km + height_km_);
        const auto sunlight = static_cast<double>(
            direct_light(small, static_cast<float>(height), static_cast<float>(sin_light))[channel]);
        const double open = sunlight * (on_ground ? std::max(sin_light, 0.0) / pi : 0.25 / pi);
        const auto share = static_cast<double>(sunlight_at(shadow_, f32::vec3(at))[channel]);
        planes[i][row * side + column] = {open * share, open};
      }
    }
  }
  for (std::vector<Complex>& plane : planes) {
    fourier_transform(plane, side, FourierWay::forward);
  }
  std::vector<std::vector<Complex>> verticals = planes;
  const double unit_per_km = 2.0 * pi / (static_cast<double>(side) * spacing_km);
  const auto wave_number = [](std::size_t i) { return static_cast<double>(i <= side / 2 ? i : side - i); };
  for (std::size_t v = 0; v < side; ++v) {
    for (std::size_t u = 0; u < side; ++u) {
      EclipsedAir::Column sunlit{};
      for (std::size_t i = 0; i < EclipsedAir::places; ++i) {
        sunlit[i] = planes[i][v * side + u];
      }
      const EclipsedAir::Diffuse diffuse =
          air_->diffuse(wavelength, unit_per_km * std::hypot(wave_number(u), wave_number(v)), sunlit);
      for (std::size_t i = 0; i < EclipsedAir::places; ++i) {
        planes[i][v * side + u] = diffuse.mean[i];
        verticals[i][v * side + u] = diffuse.vertical[i];
      }
    }
  }
  for (std::size_t i = 0; i < EclipsedAir::places; ++i) {
    fourier_transform(planes[i], side, FourierWay::back);
    fourier_transform(verticals[i], side, FourierWay::back);
    for (std::size_t texel = 0; texel < side * side; ++texel) {
      const Complex& light = planes[i][texel];
      const auto open = std::max(light.imag(), 1.0e-30);
      const auto share = [&](double value) { return static_cast<float>(std::clamp(value / open, 0.0, 1.0)); };
      Node& node = chart_[i * side * side + texel];
      node.open[channel] = static_cast<float>(open);
      node.left[channel] = share(light.real());
      node.vertical[channel] = share(verticals[i][texel].imag());
      node.vertical_left[channel] = share(verticals[i][texel].real());
    }
  }
}

EclipsedSky::Place EclipsedSky::place(const f32::vec3& at_km, float height_km) const {
  const float ground_km = air_->tables().frame.ground_km;
  const float level = std::hypot(at_km.x, at_km.y);
  const float distance = ground_km * std::atan2(level, ground_km + static_cast<float>(height_km_) + at_km.z);
  const float scale = level > 0.0F ? distance / (level * static_cast<float>(spacing_km)) : 0.0F;
  constexpr auto half = 0.5F * static_cast<float>(side);
  constexpr auto last = static_cast<float>(side - 1);
  const float x = std::clamp(half + scale * at_km.x, 0.0F, last);
  const float y = std::clamp(half + scale * at_km.y, 0.0F, last);
  // Waves come round at the chart's edges.
  const float aside = std::max(std::abs(scale * at_km.x), std::abs(scale * at_km.y));
  const EclipsedAir::HeightPlace level_place = EclipsedAir::height_place(height_km);
  const auto column = std::min(static_cast<std::size_t>(x), side - 2);
  const auto row = std::min(static_cast<std::size_t>(y), side - 2);
  return {column,
          row,
          level_place.below,
          x - static_cast<float>(column),
          y - static_cast<float>(row),
          level_place.above,
          1.0F - glm::smoothstep(half - 8.0F, half - 2.0F, aside)};
}

EclipsedSky::Node EclipsedSky::chart(const Place& place) const {
  Node sum{};
  const auto add = [&](std::size_t level, std::size_t row, std::size_t column, float share) {
    const Node& node = chart_[(level * side + row) * side + column];
    sum.open += share * node.open;
    sum.left += share * node.left;
    sum.vertical += share * node.vertical;
    sum.vertical_left += share * node.vertical_left;
  };
  const auto add_level = [&](std::size_t level, float share) {
    add(level, place.row, place.column, share * (1.0F - place.right) * (1.0F - place.down));
    add(level, place.row, place.column + 1, share * place.right * (1.0F - place.down));
    add(level, place.row + 1, place.column, share * (1.0F - place.right) * place.down);
    add(level, place.row + 1, place.column + 1, share * place.right * place.down);
  };
  add_level(place.level, 1.0F - place.up);
  if (place.up > 0.0F) {
    add_level(place.level + 1, place.up);
  }
  return sum;
}

EclipsedSky::Light EclipsedSky::march(const Vec3& view, bool with_ground) const {
  const SmallSkyTables& small = *air_->tables().small;
  const f32::SmallSkyFrame& frame = small.frame;
  const f32::sampler2D air = plane_of(small.air, frame.levels);
  const f32::sampler2D multiple = plane_of(small.multiple, frame.multiple_nodes);
  const auto ground_km = static_cast<double>(frame.ground_km);
  const double origin_km = ground_km + height_km_;
  const double sine = std::clamp(view.z, -1.0, 1.0);
  // From outside the air, the ray begins where it enters.
  double begin_km = 0.0;
  Light light;
  const double over_top = origin_km - static_cast<double>(frame.top_km);
  if (over_top >= 0.0) {
    const double rise = origin_km * sine;
    const double root2 = rise * rise - over_top * (origin_km + static_cast<double>(frame.top_km));
    if (rise >= 0.0 || root2 <= 0.0) {
      return light;
    }
    begin_km = -rise - std::sqrt(root2);
  }
  const Vec3 start(0.0, 0.0, origin_km);
  const Vec3 entry = start + begin_km * view;
  const double entry_radius = glm::length(entry);
  const double height = std::clamp(entry_radius - ground_km, 1.0e-3, static_cast<double>(frame.top_km) - ground_km);
  const double entry_sine = glm::dot(entry, view) / entry_radius;
  const double horizon = -std::sqrt(height * (2.0 * ground_km + height)) / entry_radius;
  const f32::SmallSkyRay ray =
      f32::small_sky_ray(static_cast<float>(height), static_cast<float>(entry_sine), entry_sine < horizon, frame);
  const auto sin_light = static_cast<float>(glm::dot(entry, Vec3(shadow_.shadow.to_sun)) / entry_radius);
  const auto cos_angle = static_cast<float>(glm::dot(view, Vec3(shadow_.shadow.to_sun)));
  const float molecules = f32::rayleigh_phase(cos_angle, frame.depolarization);
  const f32::vec3 forward(view);
  f32::vec4 left(1.0F);
  const auto sine2 = static_cast<float>(sine * sine);
  for (int i = 0; i < view_steps; ++i) {
    const float from = static_cast<float>(i) / view_steps;
    const float to = static_cast<float>(i + 1) / view_steps;
    const float step_km = ray.length_km * (to * to - from * from);
    const float along = ray.length_km * 0.5F * (from * from + to * to);
    const f32::vec2 point = f32::small_sky_point(ray, along, sin_light, cos_angle, frame);
    const f32::SmallSkyAir here = f32::small_sky_air(air, point.x, frame);
    const f32::vec3 at = (static_cast<float>(begin_km) + along) * forward;
    const f32::vec4 sunlight = direct_light(small, point.x, point.y);
    const f32::vec4 share = sunlight_at(shadow_, at);
    const f32::vec4 far_share = glm::max(share, f32::vec4(least_diffuse));
    const Place on_chart = place(at, point.x);
    // Beyond the chart light comes evenly from all sides.
    const float trust = on_chart.trust;
    const Node node = chart(on_chart);
    const f32::vec4 diffuse = glm::mix(f32::small_sky_multiple(multiple, point.x, point.y, frame), node.open, trust);
    const f32::vec4 diffuse_share = glm::mix(far_share, node.left, trust);
    const f32::vec4 vertical = glm::mix(f32::vec4(1.0F / 3.0F), node.vertical, trust);
    const f32::vec4 vertical_share = glm::mix(far_share / 3.0F, node.vertical_left, trust);
    const f32::vec4 extinction = glm::max(here.extinction_per_km, f32::vec4(1.0e-9F));
    const f32::vec4 passed = glm::exp(-step_km * extinction);
    const f32::vec4 reach = left * (f32::vec4(1.0F) - passed) / extinction;
    const f32::vec4 even = (f32::vec4(1.0F) - air_->forward()) * here.aerosol_per_km;
    // Molecules scatter by the square of the cosine between light and view.
    const auto to_view = [&](const f32::vec4& all, const f32::vec4& upright) {
      return 0.75F * (all + sine2 * upright + 0.5F * (1.0F - sine2) * (all - upright));
    };
    const f32::vec4 molecules_open = to_view(f32::vec4(1.0F), vertical);
    const f32::vec4 molecules_share = to_view(diffuse_share, vertical_share);
    light.aerosol.open += reach * here.aerosol_per_km * sunlight;
    light.aerosol.eclipsed += reach * here.aerosol_per_km * sunlight * share;
    light.other.open +=
        reach * (here.molecules_per_km * (molecules * sunlight + molecules_open * diffuse) + even * diffuse);
    light.other.eclipsed +=
        reach * (here.molecules_per_km * (molecules * sunlight * share + molecules_share * diffuse) +
                 even * diffuse * diffuse_share);
    left *= passed;
  }
  if (ray.meets_ground && with_ground) {
    const f32::vec2 point = f32::small_sky_point(ray, ray.length_km, sin_light, cos_angle, frame);
    const f32::vec3 at = (static_cast<float>(begin_km) + ray.length_km) * forward;
    const f32::vec4 sunlight = std::max(point.y, 0.0F) / static_cast<float>(pi) * direct_light(small, 0.0F, point.y);
    const f32::vec4 share = sunlight_at(shadow_, at);
    const f32::vec4 far_share = glm::max(share, f32::vec4(least_diffuse));
    Place on_chart = place(at, 0.0F);
    on_chart.level = EclipsedAir::ground;
    on_chart.up = 0.0F;
    const Node node = chart(on_chart);
    const f32::vec4 diffuse_share = glm::mix(far_share, node.left, on_chart.trust);
    light.other.open += left * air_->albedo() * (sunlight + node.open);
    light.other.eclipsed += left * air_->albedo() * (sunlight * share + node.open * diffuse_share);
  }
  const f32::mat4& responses = small.responses;
  return {{responses * light.aerosol.eclipsed, responses * light.aerosol.open},
          {responses * light.other.eclipsed, responses * light.other.open}};
}

EclipsedSky::Ratios EclipsedSky::ratios(const Vec3& view, bool with_ground) const {
  const Light light = march(view, with_ground);
  const auto cos_angle = static_cast<float>(glm::dot(view, Vec3(shadow_.shadow.to_sun)));
  // Where no light is there is nothing to dim.
  const auto ratio = [](const f32::vec4& eclipsed, const f32::vec4& open) {
    constexpr float none = 1.0e-30F;
    return (eclipsed + none) / (open + none);
  };
  const auto with_phase = [&](float phase) {
    return ratio(light.other.eclipsed + phase * light.aerosol.eclipsed, light.other.open + phase * light.aerosol.open);
  };
  const f32::sampler1D phases = line_sampler(air_->tables().phase);
  return {with_phase(f32::sky_aerosol_phase(phases, cos_angle, phases.width)),
          with_phase(std::exp2(log2_phase_without_peak(air_->tables(), cos_angle))),
          ratio(light.aerosol.eclipsed, light.aerosol.open)};
}

f32::vec4 EclipsedSky::level_ratio() const {
  constexpr std::size_t altitudes = 10;
  constexpr int azimuths = 16;
  static const std::vector<QuadratureNode> rule = gauss_legendre(altitudes);
  const f32::sampler1D phases = line_sampler(air_->tables().phase);
  const Vec3 to_sun(shadow_.shadow.to_sun);
  f32::vec4 eclipsed(1.0e-30F);
  f32::vec4 open(1.0e-30F);
  for (const QuadratureNode& node : rule) {
    const double altitude = 0.5 * pi * node.place;
    const auto weight = static_cast<float>(node.weight * std::sin(2.0 * altitude));
    for (int k = 0; k < azimuths; ++k) {
      const double azimuth = 2.0 * pi * (k + 0.5) / azimuths;
      const Vec3 view(std::cos(altitude) * std::cos(azimuth), std::cos(altitude) * std::sin(azimuth),
                      std::sin(altitude));
      const Light light = march(view, false);
      const auto cos_angle = static_cast<float>(glm::dot(view, to_sun));
      const float phase = f32::sky_aerosol_phase(phases, cos_angle, phases.width);
      eclipsed += weight * (light.other.eclipsed + phase * light.aerosol.eclipsed);
      open += weight * (light.other.open + phase * light.aerosol.open);
    }
  }
  return eclipsed / open;
}

} // namespace vesper
