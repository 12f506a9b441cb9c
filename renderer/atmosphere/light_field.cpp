#include "vesper/atmosphere/light_field.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr std::size_t lane_group = 4;
constexpr std::size_t lookup_cells = 4096;

/// 2^x within 3e-6, for loops that the compiler turns into vector instructions.
inline float exp2_fast(float x) {
  const float bounded = std::max(x, -126.0F);
  // Truncation rounds down what is positive.
  const int whole = static_cast<int>(bounded + 127.0F) - 127;
  const float t = bounded - static_cast<float>(whole);
  const float mantissa =
      1.0F + t * (0.69315286F + t * (0.24014077F + t * (0.055886440F + t * (0.0089304169F + t * 0.0018894827F))));
  return mantissa * std::bit_cast<float>(static_cast<std::uint32_t>(whole + 127) << 23U);
}

constexpr float log2_of_e = 1.4426950408889634F;

/// Cosines of the light's zenith angles at the nodes: half a degree apart where twilight falls.
std::vector<double> light_angle_cosines() {
  struct Range {
    double from_deg;
    double step_deg;
    int count;
  };
  std::vector<double> cosines;
  for (const Range& range : {Range{0.0, 5.0, 16}, {80.0, 1.0, 6}, {86.0, 0.5, 52}, {112.0, 2.0, 9}, {130.0, 10.0, 6}}) {
    for (int i = 0; i < range.count; ++i) {
      cosines.push_back(std::cos((range.from_deg + i * range.step_deg) * pi / 180.0));
    }
  }
  return cosines;
}

} // namespace

double LightField::zenith_place(double altitude_rad, double dip_rad) {
  const double above = altitude_rad + dip_rad;
  return above >= 0.0
             ? static_cast<double>(nodes_below) +
                   static_cast<double>(nodes_above) * std::sqrt(std::min(1.0, above / (0.5 * pi + dip_rad)))
             : static_cast<double>(nodes_below) * (1.0 - std::sqrt(std::min(1.0, -above / (0.5 * pi - dip_rad))));
}

double LightField::node_altitude(std::size_t zenith_node, double dip_rad) {
  const double place = static_cast<double>(zenith_node) - static_cast<double>(nodes_below);
  const double t = place / static_cast<double>(place < 0.0 ? nodes_below : nodes_above);
  return -dip_rad + (place < 0.0 ? -(0.5 * pi - dip_rad) : 0.5 * pi + dip_rad) * t * t;
}

LightField::LightField(const SampledAir& air, const SpectralAir& optics, const LightFieldSize& size, unsigned threads)
    : air_(air), optics_(optics), columns_(air, threads),
      lanes_((optics.size() + lane_group - 1) / lane_group * lane_group), heights_(size.heights),
      angle_cos_(light_angle_cosines()) {
  if (optics.size() > most_wavelengths) {
    throw Error(ErrorKind::argument, "a light field at " + std::to_string(optics.size()) + " wavelengths",
                {"", "", "Give at most " + std::to_string(most_wavelengths)});
  }
  for (std::size_t i = 0, below = 0; i <= lookup_cells; ++i) {
    const double cos_zenith = 1.0 - 2.0 * static_cast<double>(i) / lookup_cells;
    while (below + 2 < angle_cos_.size() && angle_cos_[below + 1] >= cos_zenith) {
      ++below;
    }
    angle_lookup_.push_back(static_cast<std::uint16_t>(below));
  }
  second_moment_.resize(lanes_, 0.0F);
  for (std::size_t c = 0; c < air.component_count(); ++c) {
    molecular_.push_back(optics.phase_kind(c) == PhaseKind::rayleigh);
    if (molecular_.back()) {
      for (std::size_t l = 0; l < optics.size(); ++l) {
        // p = (1 + 5 m P2(cos)) / 4 pi: its value straight on tells m.
        second_moment_[l] = static_cast<float>((4.0 * pi * optics.phase(c, l, 1.0) - 1.0) / 5.0);
      }
    }
  }
  solve(size, threads);
}

double LightField::dip(double radius_km) const { return std::acos(std::min(1.0, air_.ground_km() / radius_km)); }

double LightField::node_height_km(std::size_t i) const {
  const double share = static_cast<double>(i) / static_cast<double>(heights_ - 1);
  return (air_.top_km() - air_.ground_km()) * share * share;
}

LightField::Place LightField::place(double height_km) const {
  const double share = std::clamp(height_km / (air_.top_km() - air_.ground_km()), 0.0, 1.0);
  const auto below =
      std::min(static_cast<std::size_t>(std::sqrt(share) * static_cast<double>(heights_ - 1)), heights_ - 2);
  const double low = node_height_km(below);
  return {below, std::clamp((height_km - low) / (node_height_km(below + 1) - low), 0.0, 1.0)};
}

LightField::Corner LightField::corner(const Place& place, double cos_light_zenith) const {
  const double bounded = std::clamp(cos_light_zenith, -1.0, 1.0);
  std::size_t j = angle_lookup_[static_cast<std::size_t>((1.0 - bounded) * (0.5 * lookup_cells))];
  while (j + 2 < angle_cos_.size() && angle_cos_[j + 1] > bounded) {
    ++j;
  }
  const double t = (angle_cos_[j] - bounded) / (angle_cos_[j] - angle_cos_[j + 1]);
  return {place.height * angle_cos_.size() + j, static_cast<float>(place.height_fraction),
          static_cast<float>(std::clamp(t, 0.0, 1.0))};
}

LightField::ViewRay LightField::view_ray(double radius_km, double cos_zenith, double growth, double least_km) const {
  const std::size_t count = optics_.size();
  const AirRay ray = air_.ray(radius_km, cos_zenith);
  ViewRay view;
  view.cos_zenith = cos_zenith;
  view.sin_zenith = std::sqrt(std::max(0.0, (1.0 - cos_zenith) * (1.0 + cos_zenith)));
  const auto step_at = [&](double place_km) {
    const double along_km = place_km - ray.origin_km;
    const double r = ray.radius_km(place_km);
    const double view_z = std::clamp(place_km / r, -1.0, 1.0);
    return Step{r,
                place(r - air_.ground_km()),
                view_z,
                zenith_place(std::asin(view_z), dip(r)),
                (std::max(radius_km, air_.ground_km()) + along_km * cos_zenith) / r,
                along_km * view.sin_zenith / r};
  };
  std::vector<double> depth(count, 0.0);
  SampledAir::PerComponent step_columns{};
  double from_km = ray.begin_km;
  constexpr double longest_km = 40.0;
  air_.for_each_cell(ray, SampledAir::longest_cell_km, [&](double a, double b) {
    air_.add_columns(ray, a, b, step_columns);
    const double low_km = std::min(ray.radius_km(from_km), ray.radius_km(b)) - air_.ground_km();
    const double rise_km = std::abs(ray.radius_km(b) - ray.radius_km(from_km));
    if (b - from_km < longest_km && rise_km < least_km + growth * low_km && b < ray.end_km) {
      return true;
    }
    view.steps.push_back(step_at(0.5 * (from_km + b)));
    const std::size_t base = view.weights.size();
    view.weights.resize(base + (2 + air_.component_count()) * lanes_, 0.0F);
    float* weights = &view.weights[base];
    for (std::size_t l = 0; l < count; ++l) {
      const double within = optics_.optical_depth(step_columns, l);
      // Light from all of the step, dimmed by the part of it that lies before.
      const double passed = std::exp(-depth[l]) * (within > 1.0e-6 ? -std::expm1(-within) / within : 1.0);
      for (std::size_t c = 0; c < air_.component_count(); ++c) {
        const auto weight = static_cast<float>(passed * step_columns[c] * optics_.scattering_per_km(c, l));
        weights[(molecular_[c] ? 0 : 1) * lanes_ + l] += weight;
        weights[(2 + c) * lanes_ + l] = weight;
      }
      depth[l] += within;
    }
    step_columns = {};
    from_km = b;
    return true;
  });
  view.meets_ground = ray.meets_ground;
  if (view.meets_ground) {
    view.ground = step_at(ray.end_km);
    view.ground.radius_km = air_.ground_km();
    view.ground_weights.resize(lanes_, 0.0F);
    for (std::size_t l = 0; l < count; ++l) {
      view.ground_weights[l] = static_cast<float>(std::exp(-depth[l]) * optics_.albedo(l) / pi);
    }
  }
  return view;
}

/// Share of the light's disc above the horizon of a place.
double LightField::visible_light(double radius_km, double cos_light_zenith, double radius_rad) const {
  const double altitude = std::asin(std::clamp(cos_light_zenith, -1.0, 1.0)) + dip(radius_km);
  if (std::abs(altitude) >= radius_rad) {
    return altitude > 0.0 ? 1.0 : 0.0;
  }
  const double share = altitude / radius_rad;
  return 0.5 + (share * std::sqrt(1.0 - share * share) + std::asin(share)) / pi;
}

void LightField::add_direct(const ViewRay& ray, double cos_light_zenith, double sin_light_zenith, double cos_azimuth,
                            double radius_rad, float* by_molecules, float* by_aerosol, float* by_ground) const {
  const std::size_t count = optics_.size();
  const std::size_t components = air_.component_count();
  const double cos_angle = ray.cos_zenith * cos_light_zenith + ray.sin_zenith * sin_light_zenith * cos_azimuth;
  std::array<std::array<float, most_wavelengths>, SampledAir::most_components> phase{};
  for (std::size_t c = 0; c < components; ++c) {
    for (std::size_t l = 0; l < count; ++l) {
      phase[c][l] = static_cast<float>(optics_.phase(c, l, cos_angle));
    }
  }
  std::array<float, most_wavelengths> light{};
  const auto light_at = [&](const Step& step) {
    const double cosine = step.from_vertical * cos_light_zenith + step.from_level * sin_light_zenith * cos_azimuth;
    const double visible = visible_light(step.radius_km, cosine, radius_rad);
    if (visible <= 0.0) {
      return false;
    }
    const double ratio = std::min(1.0, air_.ground_km() / step.radius_km);
    const double horizon = -std::sqrt((1.0 - ratio) * (1.0 + ratio));
    SampledAir::PerComponent columns{};
    if (!columns_.to_space(step.radius_km, std::max(cosine, horizon * (1.0 - 1.0e-12)), columns)) {
      return false;
    }
    for (std::size_t l = 0; l < count; ++l) {
      light[l] =
          static_cast<float>(visible) * exp2_fast(-log2_of_e * static_cast<float>(optics_.optical_depth(columns, l)));
    }
    return true;
  };
  for (std::size_t i = 0; i < ray.steps.size(); ++i) {
    if (!light_at(ray.steps[i])) {
      continue;
    }
    const float* weights = &ray.weights[i * (2 + components) * lanes_];
    for (std::size_t c = 0; c < components; ++c) {
      float* radiance = molecular_[c] ? by_molecules : by_aerosol;
      for (std::size_t l = 0; l < count; ++l) {
        radiance[l] += weights[(2 + c) * lanes_ + l] * phase[c][l] * light[l];
      }
    }
  }
  if (ray.meets_ground && light_at(ray.ground)) {
    const auto cosine = static_cast<float>(ray.ground.from_vertical * cos_light_zenith +
                                           ray.ground.from_level * sin_light_zenith * cos_azimuth);
    for (std::size_t l = 0; l < count; ++l) {
      by_ground[l] += ray.ground_weights[l] * std::max(0.0F, cosine) * light[l];
    }
  }
}

void LightField::add_scattered(const ViewRay& ray, double cos_light_zenith, double sin_light_zenith, double cos_azimuth,
                               float* by_air, float* by_ground) const {
  const std::size_t lanes = lanes_;
  const std::size_t node_stride = moments * lanes;
  const std::size_t row_stride = angle_cos_.size() * node_stride;
  const double cos_angle = ray.cos_zenith * cos_light_zenith + ray.sin_zenith * sin_light_zenith * cos_azimuth;
  const std::size_t stride = (2 + air_.component_count()) * lanes;
  for (std::size_t i = 0; i < ray.steps.size(); ++i) {
    const Step& step = ray.steps[i];
    const double light_z =
        std::clamp(step.from_vertical * cos_light_zenith + step.from_level * sin_light_zenith * cos_azimuth, -1.0, 1.0);
    const double light_x = std::sqrt((1.0 - light_z) * (1.0 + light_z));
    const double level = std::sqrt((1.0 - step.view_z) * (1.0 + step.view_z));
    const auto vz = static_cast<float>(step.view_z);
    const auto vx = static_cast<float>(
        light_x > 1.0e-6 ? std::clamp((cos_angle - light_z * step.view_z) / light_x, -level, level) : 0.0);
    const float vyy = std::max(0.0F, 1.0F - vx * vx - vz * vz);
    // The view direction's azimuth from the light's.
    const double azimuth = level > 1.0e-6 ? std::acos(std::clamp(static_cast<double>(vx) / level, -1.0, 1.0)) : 0.0;
    const double azimuth_place = azimuth / pi * static_cast<double>(azimuth_nodes - 1);
    const auto a = std::min(static_cast<std::size_t>(azimuth_place), azimuth_nodes - 2);
    const auto q = static_cast<float>(azimuth_place - static_cast<double>(a));
    const auto e = std::min(static_cast<std::size_t>(step.zenith_place), zenith_nodes - 2);
    const auto p = static_cast<float>(step.zenith_place - static_cast<double>(e));
    const Corner at = corner(step.place, light_z);
    const float* low = &field_[at.node * node_stride];
    const float* high = low + row_stride;
    const float s = at.height_fraction;
    const float t = at.angle_fraction;
    const float w00 = (1.0F - s) * (1.0F - t);
    const float w01 = (1.0F - s) * t;
    const float w10 = s * (1.0F - t);
    const float w11 = s * t;
    const auto between = [&](std::size_t moment, std::size_t l) {
      const std::size_t k = moment * lanes + l;
      return w00 * low[k] + w01 * low[k + node_stride] + w10 * high[k] + w11 * high[k + node_stride];
    };
    const float* weights = &ray.weights[i * stride];
    for (std::size_t l = 0; l < lanes; ++l) {
      const float mean = exp2_fast(between(mean_log2, l));
      const float rxx = between(xx, l);
      const float rzz = between(zz, l);
      const float second = vx * vx * rxx + vz * vz * rzz + vyy * (1.0F - rxx - rzz) + 2.0F * vx * vz * between(xz, l);
      by_air[l] += mean * weights[l] * (1.0F + 5.0F * second_moment_[l] * (1.5F * second - 0.5F));
    }
    const float* aerosol = weights + lanes;
    if (*std::max_element(aerosol, aerosol + lanes) == 0.0F) {
      continue;
    }
    const std::size_t source_node = source_directions * lanes;
    const float* corner_sources = &aerosol_[at.node * source_node + (e * azimuth_nodes + a) * lanes];
    std::array<float, most_wavelengths> source{};
    const std::array<float, 4> place_weights{w00, w01, w10, w11};
    const std::array<std::size_t, 4> place_offsets{0, source_node, angle_cos_.size() * source_node,
                                                   (angle_cos_.size() + 1) * source_node};
    for (std::size_t k = 0; k < 4; ++k) {
      const float* from = corner_sources + place_offsets[k];
      const float c00 = place_weights[k] * (1.0F - p) * (1.0F - q);
      const float c01 = place_weights[k] * (1.0F - p) * q;
      const float c10 = place_weights[k] * p * (1.0F - q);
      const float c11 = place_weights[k] * p * q;
      for (std::size_t l = 0; l < lanes; ++l) {
        source[l] += c00 * from[l] + c01 * from[lanes + l] + c10 * from[azimuth_nodes * lanes + l] +
                     c11 * from[(azimuth_nodes + 1) * lanes + l];
      }
    }
    for (std::size_t l = 0; l < lanes; ++l) {
      by_air[l] += aerosol[l] * exp2_fast(source[l]);
    }
  }
  if (ray.meets_ground) {
    const Corner at = corner({0, 0.0}, ray.ground.from_vertical * cos_light_zenith +
                                           ray.ground.from_level * sin_light_zenith * cos_azimuth);
    const float* low = &ground_[at.node * lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
      by_ground[l] += ray.ground_weights[l] * exp2_fast(low[l] + at.angle_fraction * (low[l + lanes] - low[l]));
    }
  }
}

LightField::ViewRay LightField::view_ray(double radius_km, double cos_zenith) const {
  return view_ray(radius_km, cos_zenith, 0.04, 0.1);
}

LightField::RayLight LightField::light(const ViewRay& ray, double cos_light_zenith, double cos_azimuth,
                                       Angle light_angular_radius) const {
  const double sin_light = std::sqrt(std::max(0.0, (1.0 - cos_light_zenith) * (1.0 + cos_light_zenith)));
  RayLight light;
  add_direct(ray, cos_light_zenith, sin_light, cos_azimuth, light_angular_radius.to(rad), light.other.data(),
             light.single_aerosol.data(), light.ground.data());
  add_scattered(ray, cos_light_zenith, sin_light, cos_azimuth, light.other.data(), light.ground.data());
  return light;
}

std::vector<double> LightField::radiance(const SkyQuery& query) const {
  validate(query);
  const Vec3& toward = query.light_direction;
  const Vec3& view = query.view_direction;
  const double level = std::hypot(toward.x, toward.y) * std::hypot(view.x, view.y);
  const double cos_azimuth =
      level > 1.0e-9 ? std::clamp((toward.x * view.x + toward.y * view.y) / level, -1.0, 1.0) : 1.0;
  const RayLight parts = light(view_ray(air_.ground_km() + query.height.to(kilometre), view.z), toward.z, cos_azimuth,
                               query.light_angular_radius);
  std::vector<double> radiance;
  for (std::size_t l = 0; l < optics_.size(); ++l) {
    radiance.push_back(static_cast<double>(parts.single_aerosol[l] + parts.other[l] + parts.ground[l]));
  }
  return radiance;
}

std::vector<double> LightField::diffuse_irradiance(double cos_light_zenith) const {
  const Corner at = corner({0, 0.0}, cos_light_zenith);
  std::vector<double> result;
  for (std::size_t l = 0; l < optics_.size(); ++l) {
    const float* low = &ground_[at.node * lanes_];
    result.push_back(static_cast<double>(exp2_fast(low[l] + at.angle_fraction * (low[l + lanes_] - low[l]))));
  }
  return result;
}

} // namespace vesper
