#include "vesper/atmosphere/transport_guide.hpp"

#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vesper {
namespace {

using std::numbers::pi;

/// Heights go as the power of their number: half of them lie in the lowest sixth of the air.
constexpr double height_power = 2.5;

constexpr double lookup_step_km = 0.05;

constexpr TransportGuide::Values zero{};

} // namespace

/// A piece of a view ray: where it lies, and what one unit of source in it sends to the ray's origin.
struct TransportGuide::Step {
  HeightPlace height;
  // cos of the light's zenith angle there = from_vertical * cos(light's zenith angle at the origin)
  //                                       + from_level * sin(the same) * cos(azimuth from the light)
  double from_vertical;
  double from_level;
  std::array<Values, SampledAir::most_components> by_component;
  Values by_all;
};

struct TransportGuide::ViewRay {
  std::vector<Step> steps;
  bool meets_ground = false;
  Values ground{}; ///< what a ground of radiance 1 sends to the origin
  double ground_from_vertical = 0.0;
  double ground_from_level = 0.0;
};

TransportGuide::TransportGuide(const SampledAir& air, const SpectralAir& optics, std::vector<std::size_t> wavelengths,
                               unsigned threads)
    : air_(air), optics_(optics), wavelengths_(std::move(wavelengths)) {
  for (std::size_t i = 0; i < heights; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(heights - 1);
    heights_km_[i] = (air.top_km() - air.ground_km()) * std::pow(share, height_power);
    // Bins crowd at the horizon of this height.
    const double radius_km = air.ground_km() + heights_km_[i];
    const double dip = std::acos(std::min(1.0, air.ground_km() / radius_km));
    std::array<double, zenith_bins + 1>& edges = zenith_edges_[i];
    for (std::size_t j = 0; j <= below_bins; ++j) {
      const double t = 1.0 - static_cast<double>(j) / below_bins;
      edges[j] = std::sin(-dip - (0.5 * pi - dip) * t * t);
    }
    for (std::size_t j = 1; j <= above_bins; ++j) {
      const double t = static_cast<double>(j) / above_bins;
      edges[below_bins + j] = std::sin(-dip + (0.5 * pi + dip) * t * t);
    }
    edges.front() = -1.0;
    edges.back() = 1.0;
  }
  for (std::size_t i = 0, below = 0; static_cast<double>(i) * lookup_step_km <= heights_km_.back(); ++i) {
    while (below + 2 < heights && heights_km_[below + 1] <= static_cast<double>(i) * lookup_step_km) {
      ++below;
    }
    height_below_.push_back(static_cast<unsigned char>(below));
  }
  solve_beam(threads);
  solve_scattered(threads);
}

TransportGuide::HeightPlace TransportGuide::height_place(double height_km) const {
  const double height = std::clamp(height_km, 0.0, heights_km_.back());
  std::size_t below = height_below_[static_cast<std::size_t>(height / lookup_step_km)];
  while (below + 2 < heights && heights_km_[below + 1] <= height) {
    ++below;
  }
  return {below, (height - heights_km_[below]) / (heights_km_[below + 1] - heights_km_[below])};
}

TransportGuide::Corner TransportGuide::corner(HeightPlace height, double cos_light_zenith) {
  const double place = std::clamp(0.5 * (cos_light_zenith + 1.0), 0.0, 1.0) * static_cast<double>(angles - 1);
  const auto below = std::min(static_cast<std::size_t>(place), angles - 2);
  return {height.below, below, height.fraction, place - static_cast<double>(below)};
}

TransportGuide::Values TransportGuide::between(const std::vector<Values>& table, const Corner& corner) const {
  const Values* low = &table[corner.height * angles + corner.angle];
  const Values* high = low + angles;
  const double t = corner.angle_fraction;
  const double s = corner.height_fraction;
  Values result{};
  for (std::size_t k = 0; k < most_wavelengths; ++k) {
    const double below = low[0][k] + t * (low[1][k] - low[0][k]);
    const double above = high[0][k] + t * (high[1][k] - high[0][k]);
    result[k] = below + s * (above - below);
  }
  return result;
}

TransportGuide::Light TransportGuide::light(double radius_km, double cos_light_zenith) const {
  const Corner place = corner(height_place(radius_km - air_.ground_km()), cos_light_zenith);
  return {between(beam_, place), between(scattered_, place)};
}

TransportGuide::Values TransportGuide::ground_irradiance(double cos_light_zenith) const {
  const Corner place = corner({0, 0.0}, cos_light_zenith);
  Values result{};
  for (std::size_t k = 0; k < most_wavelengths; ++k) {
    const Values* row = &ground_[place.angle];
    result[k] = row[0][k] + place.angle_fraction * (row[1][k] - row[0][k]);
  }
  return result;
}

void TransportGuide::solve_beam(unsigned threads) {
  beam_.assign(heights * angles, zero);
  parallel_for(
      heights, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          for (std::size_t j = 0; j < angles; ++j) {
            const double cos_zenith = 2.0 * static_cast<double>(j) / static_cast<double>(angles - 1) - 1.0;
            const AirRay ray = air_.ray(air_.ground_km() + heights_km_[i], cos_zenith);
            if (ray.meets_ground) {
              continue;
            }
            const auto columns = air_.columns_to_space(ray, [](const auto&) { return false; });
            for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
              beam_[i * angles + j][k] = std::exp(-optics_.optical_depth(columns, wavelengths_[k]));
            }
          }
        }
      },
      threads);
}

TransportGuide::ViewRay TransportGuide::view_ray(std::size_t height, std::size_t zenith_bin) const {
  const double radius_km = air_.ground_km() + heights_km_[height];
  // The highest of them look down on the top from just below it.
  const double cos_zenith = 0.5 * (zenith_edges_[height][zenith_bin] + zenith_edges_[height][zenith_bin + 1]);
  const double sin_zenith = std::sqrt(1.0 - cos_zenith * cos_zenith);
  const AirRay ray = air_.ray(radius_km, cos_zenith);
  ViewRay view;
  SampledAir::PerComponent columns{};
  const auto geometry = [&](double place_km, double& from_vertical, double& from_level) {
    const double along_km = place_km - ray.origin_km;
    const double r = ray.radius_km(place_km);
    from_vertical = (radius_km + along_km * cos_zenith) / r;
    from_level = along_km * sin_zenith / r;
  };
  const auto add_step = [&](double from, double to, const SampledAir::PerComponent& before) {
    const double middle = 0.5 * (from + to);
    SampledAir::PerComponent half = before;
    air_.add_columns(ray, from, middle, half);
    const double radius = ray.radius_km(middle);
    const SampledAir::PerComponent density = air_.density(radius);
    Step step{height_place(radius - air_.ground_km()), 0.0, 0.0, {}, {}};
    geometry(middle, step.from_vertical, step.from_level);
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
      const double share = (to - from) * std::exp(-optics_.optical_depth(half, wavelengths_[k]));
      for (std::size_t c = 0; c < air_.component_count(); ++c) {
        step.by_component[c][k] = share * density[c] * optics_.scattering_per_km(c, wavelengths_[k]);
        step.by_all[k] += step.by_component[c][k];
      }
    }
    view.steps.push_back(step);
  };
  // Cells are joined to steps that grow with height.
  constexpr double longest_km = 60.0;
  double step_from = ray.begin_km;
  SampledAir::PerComponent step_columns{};
  air_.for_each_cell(ray, longest_km, [&](double from, double to) {
    air_.add_columns(ray, from, to, columns);
    const double low_km = std::min(ray.radius_km(step_from), ray.radius_km(to)) - air_.ground_km();
    const double rise_km = std::abs(ray.radius_km(to) - ray.radius_km(step_from));
    if (to - step_from >= longest_km || rise_km >= 0.5 + 0.2 * low_km || to >= ray.end_km) {
      add_step(step_from, to, step_columns);
      step_from = to;
      step_columns = columns;
    }
    return true;
  });
  view.meets_ground = ray.meets_ground;
  if (view.meets_ground) {
    geometry(ray.end_km, view.ground_from_vertical, view.ground_from_level);
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
      view.ground[k] = std::exp(-optics_.optical_depth(columns, wavelengths_[k]));
    }
  }
  return view;
}

void TransportGuide::solve_scattered(unsigned threads) {
  const std::size_t count = wavelengths_.size();
  std::vector<ViewRay> views;
  for (std::size_t i = 0; i < heights; ++i) {
    for (std::size_t j = 0; j < zenith_bins; ++j) {
      views.push_back(view_ray(i, j));
    }
  }
  scattered_.assign(heights * angles, zero);
  ground_.assign(angles, zero);
  for (std::size_t j = 0; j < angles; ++j) {
    const double cos_light = 2.0 * static_cast<double>(j) / static_cast<double>(angles - 1) - 1.0;
    for (std::size_t k = 0; k < count; ++k) {
      ground_[j][k] = std::max(0.0, cos_light) * beam_[j][k];
    }
  }
  const std::vector<Values> ground_direct = ground_;

  // Radiance by cell, bin and wavelength: of light scattered once, and of all.
  std::vector<float> once(heights * angles * bins * count, 0.0F);
  cumulative_.assign(once.size(), 0.0F);
  // Each round adds the next order. What is missing after these weighs less than the guide's other errors.
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Values> source = scattered_;
    const std::vector<Values> ground = ground_;
    parallel_for(
        heights * angles, 16,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t cell = begin; cell < end; ++cell) {
            const std::size_t i = cell / angles;
            const std::size_t a = cell % angles;
            const double cos_light = 2.0 * static_cast<double>(a) / static_cast<double>(angles - 1) - 1.0;
            const double sin_light = std::sqrt(std::max(0.0, 1.0 - cos_light * cos_light));
            Values mean{};
            Values level{};
            for (std::size_t j = 0; j < zenith_bins; ++j) {
              const ViewRay& view = views[i * zenith_bins + j];
              const double cos_zenith = 0.5 * (zenith_edges_[i][j] + zenith_edges_[i][j + 1]);
              const double sin_zenith = std::sqrt(1.0 - cos_zenith * cos_zenith);
              const double bin_sr = 2.0 * pi / azimuth_bins * (zenith_edges_[i][j + 1] - zenith_edges_[i][j]);
              for (std::size_t b = 0; b < azimuth_bins; ++b) {
                const double cos_azimuth = std::cos(pi * (static_cast<double>(b) + 0.5) / azimuth_bins);
                const std::size_t place = (cell * count) * bins + j * azimuth_bins + b;
                std::array<Values, SampledAir::most_components> phase{};
                if (round == 0) {
                  const double cos_angle = cos_zenith * cos_light + sin_zenith * sin_light * cos_azimuth;
                  for (std::size_t c = 0; c < air_.component_count(); ++c) {
                    for (std::size_t k = 0; k < count; ++k) {
                      phase[c][k] = optics_.phase(c, wavelengths_[k], cos_angle);
                    }
                  }
                }
                Values radiance{};
                const auto light_at = [&](double from_vertical, double from_level) {
                  return from_vertical * cos_light + from_level * sin_light * cos_azimuth;
                };
                for (const Step& step : view.steps) {
                  const Corner at = corner(step.height, light_at(step.from_vertical, step.from_level));
                  const Values light = between(round == 0 ? beam_ : source, at);
                  if (round > 0) {
                    for (std::size_t k = 0; k < most_wavelengths; ++k) {
                      radiance[k] += step.by_all[k] * light[k];
                    }
                    continue;
                  }
                  for (std::size_t c = 0; c < air_.component_count(); ++c) {
                    for (std::size_t k = 0; k < count; ++k) {
                      radiance[k] += step.by_component[c][k] * light[k] * phase[c][k];
                    }
                  }
                }
                if (view.meets_ground) {
                  const Corner at = corner({0, 0.0}, light_at(view.ground_from_vertical, view.ground_from_level));
                  for (std::size_t k = 0; k < count; ++k) {
                    const double irradiance =
                        ground[at.angle][k] + at.angle_fraction * (ground[at.angle + 1][k] - ground[at.angle][k]);
                    const double before =
                        ground_direct[at.angle][k] +
                        at.angle_fraction * (ground_direct[at.angle + 1][k] - ground_direct[at.angle][k]);
                    // The first round's ground stays in what is kept of it.
                    const double fresh = round == 0 ? irradiance : irradiance - before;
                    radiance[k] += view.ground[k] * optics_.albedo(wavelengths_[k]) / pi * fresh;
                  }
                }
                for (std::size_t k = 0; k < count; ++k) {
                  if (round == 0) {
                    once[place + k * bins] = static_cast<float>(radiance[k]);
                  } else {
                    radiance[k] += static_cast<double>(once[place + k * bins]);
                  }
                  cumulative_[place + k * bins] = static_cast<float>(radiance[k] * bin_sr);
                  mean[k] += radiance[k] * bin_sr / (4.0 * pi);
                  level[k] += radiance[k] * bin_sr * std::max(0.0, cos_zenith);
                }
              }
            }
            scattered_[cell] = mean;
            if (i == 0) {
              for (std::size_t k = 0; k < count; ++k) {
                ground_[a][k] = ground_direct[a][k] + level[k];
              }
            }
          }
        },
        threads);
  }
  // Sums over the bins, up to 1.
  for (std::size_t row = 0; row < heights * angles * count; ++row) {
    float* bin = &cumulative_[row * bins];
    double sum = 0.0;
    for (std::size_t b = 0; b < bins; ++b) {
      sum += static_cast<double>(bin[b]);
    }
    const double share = sum > 0.0 ? 1.0 / sum : 0.0;
    double so_far = 0.0;
    for (std::size_t b = 0; b < bins; ++b) {
      so_far += static_cast<double>(bin[b]);
      // Exactly 1 at the last bin that holds anything.
      bin[b] = so_far == sum && sum > 0.0 ? 1.0F : static_cast<float>(so_far * share);
    }
  }
}

std::size_t TransportGuide::cell(double radius_km, double cos_light_zenith) const {
  const HeightPlace at = height_place(radius_km - air_.ground_km());
  const std::size_t height = at.below + (at.fraction < 0.5 ? 0 : 1);
  const double place = std::clamp(0.5 * (cos_light_zenith + 1.0), 0.0, 1.0) * static_cast<double>(angles - 1);
  return height * angles + static_cast<std::size_t>(std::lround(place));
}

bool TransportGuide::lit(std::size_t cell, std::size_t k) const {
  return cumulative_[(cell * wavelengths_.size() + k + 1) * bins - 1] > 0.0F;
}

TransportGuide::Direction TransportGuide::sample(std::size_t cell, std::size_t k, double u, double v, double w) const {
  const float* begin = &cumulative_[(cell * wavelengths_.size() + k) * bins];
  const auto bin = static_cast<std::size_t>(std::min<std::ptrdiff_t>(
      std::upper_bound(begin, begin + bins, u,
                       [](double value, float sum) { return value < static_cast<double>(sum); }) -
          begin,
      bins - 1));
  const std::size_t zenith = bin / azimuth_bins;
  const std::array<double, zenith_bins + 1>& edges = zenith_edges_[cell / angles];
  // One number tells the side of the light's vertical plane and the place in the bin.
  const double side = w < 0.5 ? 1.0 : -1.0;
  const double within = w < 0.5 ? 2.0 * w : 2.0 * w - 1.0;
  return {edges[zenith] + v * (edges[zenith + 1] - edges[zenith]),
          side * pi * (static_cast<double>(bin % azimuth_bins) + within) / azimuth_bins};
}

std::size_t TransportGuide::zenith_bin(std::size_t height, double cos_zenith) const {
  const std::array<double, zenith_bins + 1>& edges = zenith_edges_[height];
  const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, cos_zenith);
  return static_cast<std::size_t>(above - edges.begin()) - 1;
}

TransportGuide::Values TransportGuide::density(std::size_t cell, Direction direction) const {
  const std::size_t height = cell / angles;
  const std::size_t zenith = zenith_bin(height, direction.cos_zenith);
  const auto azimuth =
      std::min(static_cast<std::size_t>(std::abs(direction.azimuth_rad) / pi * azimuth_bins), azimuth_bins - 1);
  const std::size_t bin = zenith * azimuth_bins + azimuth;
  const double bin_sr = 2.0 * pi / azimuth_bins * (zenith_edges_[height][zenith + 1] - zenith_edges_[height][zenith]);
  Values result{};
  for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
    const float* row = &cumulative_[(cell * wavelengths_.size() + k) * bins];
    const double share = static_cast<double>(row[bin]) - (bin > 0 ? static_cast<double>(row[bin - 1]) : 0.0);
    result[k] = share / bin_sr;
  }
  return result;
}

} // namespace vesper
