#include "vesper/atmosphere/light_field_model.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/sine.hpp"
#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace vesper {
namespace {

using std::numbers::pi;

/// Scattering by aerosol below this share of all is left out.
constexpr double least_share = 1.0e-4;

constexpr std::size_t depth_heights = f32::depth_heights;
constexpr std::size_t depth_angles = f32::depth_angles;
constexpr std::size_t depth_levels = f32::depth_levels;

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

void set(Lanes* lights, std::size_t wavelength, double value) {
  lights[wavelength / Lanes::size].values[wavelength % Lanes::size] = static_cast<float>(value);
}

} // namespace

LightFieldModel::LightFieldModel(const SampledAir& air, const SpectralAir& optics, const LightFieldSize& size,
                                 unsigned threads)
    : air_(air), optics_(optics), size_(size), blocks_((optics.size() + Lanes::size - 1) / Lanes::size),
      angle_cos_(light_angle_cosines()) {
  if (optics.size() > most_wavelengths) {
    throw Error(ErrorKind::argument, "a light field at " + std::to_string(optics.size()) + " wavelengths",
                {"", "", "Give at most " + std::to_string(most_wavelengths)});
  }
  if (size.heights < 2 || std::min(size.zeniths, size.later_zeniths) < 3 ||
      std::min(size.azimuths, size.later_azimuths) < 1 || !(size.step_growth >= 0.0 && size.least_step_km > 0.0) ||
      size.most_orders < 1) {
    throw Error(ErrorKind::argument, "a light field of too few heights, directions, steps or orders",
                {"", "", "Give 2 heights, 3 zenith angles, 1 azimuth, steps above 0 km and 1 order at least"});
  }
  shell_ = {static_cast<float>(air.ground_km()), static_cast<float>(air.top_km()), static_cast<int>(angles())};
  find_scatterers();
  find_source_heights();
  place_angles();
  tabulate_depths(threads);
}

void LightFieldModel::find_scatterers() {
  scatterers_.emplace_back();
  second_moment_.resize(blocks_);
  const auto scatters = [&](std::size_t c) {
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      if (optics_.scattering_per_km(c, l) > 0.0) {
        return true;
      }
    }
    return false;
  };
  const auto same_phase = [&](std::size_t a, std::size_t b) {
    bool same = optics_.phase_kind(a) == optics_.phase_kind(b);
    for (std::size_t l = 0; l < optics_.size() && same; ++l) {
      same = optics_.phase_parameter(a, l) == optics_.phase_parameter(b, l);
    }
    return same;
  };
  for (std::size_t c = 0; c < air_.component_count(); ++c) {
    if (!scatters(c)) {
      continue;
    }
    const bool molecular = optics_.phase_kind(c) == PhaseKind::rayleigh;
    if (molecular && (scatterers_[0].empty() || same_phase(c, scatterers_[0][0]))) {
      scatterers_[0].push_back(c);
      continue;
    }
    const auto own = std::find_if(scatterers_.begin() + 1, scatterers_.end(),
                                  [&](const Scatterer& other) { return same_phase(c, other[0]); });
    own == scatterers_.end() ? scatterers_.push_back({c}) : own->push_back(c);
  }
  for (std::size_t l = 0; l < optics_.size() && !scatterers_[0].empty(); ++l) {
    // p = (1 + 5 m P2(cos)) / 4 pi: its value straight on tells m.
    set(second_moment_.data(), l, (4.0 * pi * optics_.phase(scatterers_[0][0], l, 1.0) - 1.0) / 5.0);
  }
}

PhaseKind LightFieldModel::phase_kind(std::size_t scatterer) const {
  return scatterers_[scatterer].empty() ? PhaseKind::rayleigh : optics_.phase_kind(scatterers_[scatterer][0]);
}

void LightFieldModel::phase_parameter(std::size_t scatterer, Lanes* parameters) const {
  for (std::size_t l = 0; l < optics_.size() && !scatterers_[scatterer].empty(); ++l) {
    set(parameters, l, optics_.phase_parameter(scatterers_[scatterer][0], l));
  }
}

void LightFieldModel::phase(std::size_t scatterer, double cos_angle, Lanes* per_sr) const {
  for (std::size_t l = 0; l < optics_.size(); ++l) {
    set(per_sr, l, scatterers_[scatterer].empty() ? 0.0 : optics_.phase(scatterers_[scatterer][0], l, cos_angle));
  }
}

double LightFieldModel::scattering_per_km(const Scatterer& scatterer, const SampledAir::PerComponent& density,
                                          std::size_t wavelength) const {
  double sum = 0.0;
  for (const std::size_t c : scatterer) {
    sum += density[c] * optics_.scattering_per_km(c, wavelength);
  }
  return sum;
}

double LightFieldModel::dip(double radius_km) const { return std::acos(std::min(1.0, air_.ground_km() / radius_km)); }

double LightFieldModel::zenith_place(double altitude_rad, double dip_rad) {
  const double above = altitude_rad + dip_rad;
  return above >= 0.0 ? source_nodes_below + source_nodes_above * std::sqrt(std::min(1.0, above / (0.5 * pi + dip_rad)))
                      : source_nodes_below * (1.0 - std::sqrt(std::min(1.0, -above / (0.5 * pi - dip_rad))));
}

double LightFieldModel::source_altitude(std::size_t zenith_node, double dip_rad) {
  const double place = static_cast<double>(zenith_node) - source_nodes_below;
  const double t = place / (place < 0.0 ? source_nodes_below : source_nodes_above);
  return -dip_rad + (place < 0.0 ? -(0.5 * pi - dip_rad) : 0.5 * pi + dip_rad) * t * t;
}

double LightFieldModel::node_height_km(std::size_t i) const {
  const double share = static_cast<double>(i) / static_cast<double>(size_.heights - 1);
  return (air_.top_km() - air_.ground_km()) * share * share;
}

double LightFieldModel::height_place(double height_km) const {
  const double share = std::clamp(height_km / (air_.top_km() - air_.ground_km()), 0.0, 1.0);
  const auto below =
      std::min(static_cast<std::size_t>(std::sqrt(share) * static_cast<double>(size_.heights - 1)), size_.heights - 2);
  const double low = node_height_km(below);
  // Below the next whole number also in single precision: a step belongs to the cell that it lies in.
  constexpr double most = 1.0 - 1.0e-5;
  return static_cast<double>(below) + std::clamp((height_km - low) / (node_height_km(below + 1) - low), 0.0, most);
}

void LightFieldModel::find_source_heights() {
  constexpr double step_km = 0.1;
  const auto count = static_cast<std::size_t>((air_.top_km() - air_.ground_km()) / step_km);
  double highest_km = -1.0;
  for (std::size_t i = 0; i <= count; ++i) {
    const double height_km = step_km * static_cast<double>(i);
    const SampledAir::PerComponent density = air_.density(air_.ground_km() + height_km);
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      double aerosol = 0.0;
      for (std::size_t s = 1; s < scatterers_.size(); ++s) {
        aerosol += scattering_per_km(scatterers_[s], density, l);
      }
      if (aerosol > least_share * (aerosol + scattering_per_km(scatterers_[0], density, l))) {
        highest_km = height_km;
      }
    }
  }
  source_heights_ =
      highest_km < 0.0 ? 0 : std::min(static_cast<std::size_t>(height_place(highest_km + step_km)) + 2, size_.heights);
}

void LightFieldModel::place_angles() {
  for (std::size_t i = 0, below = 0; i <= f32::light_angle_cells; ++i) {
    const double cosine = 1.0 - 2.0 * static_cast<double>(i) / f32::light_angle_cells;
    while (below + 2 < angle_cos_.size() && angle_cos_[below + 1] >= cosine) {
      ++below;
    }
    angle_places_.push_back(static_cast<float>(
        static_cast<double>(below) + (angle_cos_[below] - cosine) / (angle_cos_[below] - angle_cos_[below + 1])));
  }
}

void LightFieldModel::tabulate_depths(unsigned threads) {
  depths_.resize((depth_heights * depth_angles + depth_levels) * blocks_);
  const auto tabulate = [&](std::size_t k, double radius_km, double cos_zenith) {
    const auto columns = air_.columns_to_space(air_.ray(radius_km, cos_zenith), [](const auto&) { return false; });
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      set(&depths_[k * blocks_], l, std::numbers::log2e * optics_.optical_depth(columns, l));
    }
  };
  const auto radius_km = [&](std::size_t i, std::size_t count) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    return air_.ground_km() + (air_.top_km() - air_.ground_km()) * share * share;
  };
  parallel_for(
      depth_heights, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const double r = radius_km(i, depth_heights);
          const double nearest = air_.top_km() - r;
          const double reach2 = nearest * (air_.top_km() + r);
          for (std::size_t j = 0; j < depth_angles; ++j) {
            const double share = static_cast<double>(j) / static_cast<double>(depth_angles - 1);
            const double distance = nearest + (std::sqrt(reach2) - nearest) * share;
            const double cos_zenith =
                distance > 0.0 ? std::clamp((reach2 - distance * distance) / (2.0 * r * distance), 0.0, 1.0) : 1.0;
            tabulate(i * depth_angles + j, r, cos_zenith);
          }
        }
      },
      threads);
  parallel_for(
      depth_levels, 16,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          tabulate(depth_heights * depth_angles + i, radius_km(i, depth_levels), 0.0);
        }
      },
      threads);
}

double LightFieldModel::depth_place(double height_km) const {
  return std::sqrt(std::min(1.0, height_km / (air_.top_km() - air_.ground_km()))) *
         static_cast<double>(depth_heights - 1);
}

f32::LightStep LightFieldModel::step(const AirRay& ray, double place_km, double cos_zenith, double sin_zenith) const {
  const double r = std::max(ray.radius_km(place_km), air_.ground_km());
  const double height_km = r - air_.ground_km();
  const double along_km = place_km - ray.origin_km;
  const double origin_km = std::hypot(ray.origin_km, ray.perigee_km);
  const double view_z = std::clamp(place_km / r, -1.0, 1.0);
  const auto single = [](double x) { return static_cast<float>(x); };
  return {single((origin_km + along_km * cos_zenith) / r),
          single(along_km * sin_zenith / r),
          single(view_z),
          single(height_km),
          single(height_place(height_km)),
          single(zenith_place(std::asin(view_z), dip(r))),
          single(depth_place(height_km)),
          0.0F};
}

LightRay LightFieldModel::ray(double radius_km, double cos_zenith, double growth, double least_km) const {
  const AirRay ray = air_.ray(radius_km, cos_zenith);
  LightRay result;
  result.cos_zenith = cos_zenith;
  result.sin_zenith = sine_of(cos_zenith);
  std::vector<double> depth(optics_.size(), 0.0);
  SampledAir::PerComponent columns{};
  double from_km = ray.begin_km;
  constexpr double longest_km = 40.0;
  air_.for_each_cell(ray, SampledAir::longest_cell_km, [&](double a, double b) {
    air_.add_columns(ray, a, b, columns);
    const double low_km = std::min(ray.radius_km(from_km), ray.radius_km(b)) - air_.ground_km();
    const double rise_km = std::abs(ray.radius_km(b) - ray.radius_km(from_km));
    if (b - from_km < longest_km && rise_km < least_km + growth * low_km && b < ray.end_km) {
      return true;
    }
    f32::LightStep own = step(ray, 0.5 * (from_km + b), cos_zenith, result.sin_zenith);
    const std::size_t base = result.weights.size();
    result.weights.resize(base + scatterers() * blocks_);
    double aerosol_share = 0.0;
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      const double within = optics_.optical_depth(columns, l);
      // Light from all of the step, dimmed by the part of it that lies before.
      const double passed = std::exp(-depth[l]) * (within > 1.0e-6 ? -std::expm1(-within) / within : 1.0);
      double all = 0.0;
      double aerosol = 0.0;
      for (std::size_t s = 0; s < scatterers(); ++s) {
        const double scattering = scattering_per_km(scatterers_[s], columns, l);
        set(&result.weights[base + s * blocks_], l, passed * scattering);
        all += scattering;
        aerosol += s > 0 ? scattering : 0.0;
      }
      aerosol_share = std::max(aerosol_share, all > 0.0 ? aerosol / all : 0.0);
      depth[l] += within;
    }
    if (aerosol_share < least_share || own.height_place >= static_cast<float>(source_heights_ - 1)) {
      own.zenith_place = -1.0F;
    }
    result.steps.push_back(own);
    columns = {};
    from_km = b;
    return true;
  });
  result.meets_ground = ray.meets_ground;
  if (result.meets_ground) {
    result.ground = step(ray, ray.end_km, cos_zenith, result.sin_zenith);
    result.ground.height_km = 0.0F;
    result.ground.depth_place = 0.0F;
    result.ground_weights.resize(blocks_);
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      set(result.ground_weights.data(), l, std::exp(-depth[l]) * optics_.albedo(l) / pi);
    }
  }
  return result;
}

} // namespace vesper
