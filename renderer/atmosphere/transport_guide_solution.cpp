// How the guide is solved: order by order along rays from each of its cells.
#include "vesper/atmosphere/transport_guide.hpp"
#include "vesper/base/sine.hpp"
#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesper {
namespace {

using std::numbers::pi;

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

/// Where a view's light stands.
struct TransportGuide::LightPlace {
  double vertical;  ///< cosine of its zenith angle at the origin
  double level;     ///< its sine, times the cosine of the azimuth from it to the view
  double cos_angle; ///< of the angle between light and view

  [[nodiscard]] double cos_zenith(double from_vertical, double from_level) const {
    return from_vertical * vertical + from_level * level;
  }
};

void TransportGuide::solve_beam(unsigned threads) {
  beam_.assign(heights * angles, Values{});
  parallel_for(
      heights, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          for (std::size_t j = 0; j < angles; ++j) {
            const AirRay ray = air_.ray(air_.ground_km() + heights_km_[i], cos_light_zenith(j));
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
  const double cos_zenith = bin_cos_zenith(height, zenith_bin);
  const double sin_zenith = sine_of(cos_zenith);
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

TransportGuide::Values TransportGuide::reflected(const ViewRay& view, const LightPlace& light,
                                                 const std::vector<Values>& irradiance) const {
  Values radiance{};
  if (view.meets_ground) {
    const Values ground = on_ground(irradiance, light.cos_zenith(view.ground_from_vertical, view.ground_from_level));
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
      radiance[k] = view.ground[k] * optics_.albedo(wavelengths_[k]) / pi * ground[k];
    }
  }
  return radiance;
}

TransportGuide::Values TransportGuide::scattered_once(const ViewRay& view, const LightPlace& light,
                                                      const std::vector<Values>& ground) const {
  std::array<Values, SampledAir::most_components> phase{};
  for (std::size_t c = 0; c < air_.component_count(); ++c) {
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
      phase[c][k] = optics_.phase(c, wavelengths_[k], light.cos_angle);
    }
  }
  Values radiance = reflected(view, light, ground);
  for (const Step& step : view.steps) {
    const Values beam = between(beam_, corner(step.height, light.cos_zenith(step.from_vertical, step.from_level)));
    for (std::size_t c = 0; c < air_.component_count(); ++c) {
      for (std::size_t k = 0; k < most_wavelengths; ++k) {
        radiance[k] += step.by_component[c][k] * beam[k] * phase[c][k];
      }
    }
  }
  return radiance;
}

TransportGuide::Values TransportGuide::scattered_again(const ViewRay& view, const LightPlace& light,
                                                       const std::vector<Values>& mean,
                                                       const std::vector<Values>& ground) const {
  Values radiance = reflected(view, light, ground);
  for (const Step& step : view.steps) {
    const Values source = between(mean, corner(step.height, light.cos_zenith(step.from_vertical, step.from_level)));
    for (std::size_t k = 0; k < most_wavelengths; ++k) {
      radiance[k] += step.by_all[k] * source[k];
    }
  }
  return radiance;
}

template <class Radiance>
TransportGuide::Gathered TransportGuide::gather(std::size_t cell, const std::vector<ViewRay>& views,
                                                Radiance&& radiance) {
  const std::size_t height = cell / angles;
  const double cos_light = cos_light_zenith(cell % angles);
  const double sin_light = sine_of(cos_light);
  Gathered sum{};
  for (std::size_t j = 0; j < zenith_bins; ++j) {
    const double cos_zenith = bin_cos_zenith(height, j);
    const double sin_zenith = sine_of(cos_zenith);
    const double solid_angle_sr = bin_sr(height, j);
    for (std::size_t b = 0; b < azimuth_bins; ++b) {
      const double cos_azimuth = std::cos(pi * (static_cast<double>(b) + 0.5) / azimuth_bins);
      const double level = sin_light * cos_azimuth;
      const LightPlace light{cos_light, level, cos_zenith * cos_light + sin_zenith * level};
      const std::size_t place = cell * wavelengths_.size() * bins + j * azimuth_bins + b;
      const Values arriving = radiance(views[height * zenith_bins + j], light, place);
      for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
        const double weighed = arriving[k] * solid_angle_sr;
        cumulative_[place + k * bins] = static_cast<float>(weighed);
        sum.mean[k] += weighed / (4.0 * pi);
        sum.irradiance[k] += weighed * std::max(0.0, cos_zenith);
      }
    }
  }
  return sum;
}

void TransportGuide::solve_scattered(unsigned threads) {
  std::vector<ViewRay> views;
  for (std::size_t i = 0; i < heights; ++i) {
    for (std::size_t j = 0; j < zenith_bins; ++j) {
      views.push_back(view_ray(i, j));
    }
  }
  std::vector<Values> direct(angles, Values{});
  for (std::size_t j = 0; j < angles; ++j) {
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
      direct[j][k] = std::max(0.0, cos_light_zenith(j)) * beam_[j][k];
    }
  }
  scattered_.assign(heights * angles, Values{});
  ground_.assign(angles, Values{}); // until the end without the direct light
  cumulative_.assign(heights * angles * bins * wavelengths_.size(), 0.0F);
  std::vector<float> once(cumulative_.size()); // likewise by cell, wavelength, bin
  const auto for_each_cell = [&](const auto& radiance) {
    parallel_for(
        heights * angles, 16,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t cell = begin; cell < end; ++cell) {
            const Gathered light = gather(cell, views, radiance);
            scattered_[cell] = light.mean;
            if (cell < angles) {
              ground_[cell] = light.irradiance;
            }
          }
        },
        threads);
  };
  for_each_cell([&](const ViewRay& view, const LightPlace& light, std::size_t place) {
    const Values radiance = scattered_once(view, light, direct);
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
      once[place + k * bins] = static_cast<float>(radiance[k]);
    }
    return radiance;
  });
  // Each round adds an order. What is missing after these weighs less than the guide's other errors.
  constexpr int last_order = 10;
  for (int order = 2; order <= last_order; ++order) {
    const std::vector<Values> mean = scattered_;
    const std::vector<Values> diffuse = ground_;
    for_each_cell([&](const ViewRay& view, const LightPlace& light, std::size_t place) {
      Values radiance = scattered_again(view, light, mean, diffuse);
      for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
        radiance[k] += static_cast<double>(once[place + k * bins]);
      }
      return radiance;
    });
  }
  for (std::size_t j = 0; j < angles; ++j) {
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
      ground_[j][k] += direct[j][k];
    }
  }
  accumulate_histograms();
}

void TransportGuide::accumulate_histograms() {
  for (std::size_t row = 0; row < cumulative_.size() / bins; ++row) {
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

} // namespace vesper
