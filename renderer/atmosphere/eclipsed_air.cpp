#include "vesper/atmosphere/eclipsed_air.hpp"

#include "vesper/atmosphere/sky_table_parts.hpp"
#include "vesper/base/gauss_legendre.hpp"

#include <algorithm>
#include <cmath>

namespace vesper {
namespace {

constexpr int ray_steps = 40;
constexpr std::size_t ray_nodes = 20; ///< above the horizon, and below it

/// Bessel's function of order 0, looked up: it is asked for a million times.
class BesselTable {
public:
  explicit BesselTable(double last) {
    const auto count = static_cast<int>(last / step) + 3;
    for (int i = 0; i < count; ++i) {
      values_.push_back(::j0(i * step));
    }
  }
  [[nodiscard]] double operator()(double x) const {
    const double place = x / step;
    const std::size_t i = std::min(static_cast<std::size_t>(place), values_.size() - 2);
    return values_[i] + (place - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
  }

private:
  static constexpr double step = 0.02;
  std::vector<double> values_;
};

} // namespace

EclipsedAir::HeightPlace EclipsedAir::height_place(float height_km) {
  std::size_t below = 0;
  while (below + 2 < heights_km.size() && height_km >= heights_km.at(below + 1)) {
    ++below;
  }
  const float from = heights_km.at(below);
  return {below, std::clamp((height_km - from) / (heights_km.at(below + 1) - from), 0.0F, 1.0F)};
}

EclipsedAir::EclipsedAir(const Medium& medium) : tables_(make_small_sky_tables(medium)) {
  const SunlitAir sunlit(medium, most_wavelengths);
  const SpectralAir& optics = sunlit.optics();
  const SampledAir::PerComponent density = sunlit.air().density(sunlit.air().ground_km());
  for (std::size_t l = 0; l < optics.size(); ++l) {
    const auto i = static_cast<int>(l);
    albedo_[i] = static_cast<float>(optics.albedo(l));
    double scattering = 0.0;
    double forward = 0.0;
    for (std::size_t c = 0; c < sunlit.air().component_count(); ++c) {
      if (optics.phase_kind(c) != PhaseKind::rayleigh) {
        const double here = density[c] * optics.scattering_per_km(c, l);
        scattering += here;
        forward += here * std::max(0.0, optics.phase_parameter(c, l));
      }
    }
    forward_[i] = scattering > 0.0 ? static_cast<float>(forward / scattering) : 0.0F;
  }
  fill_transfers();
  solve();
}

/// Light that one flight brings to each place, of what is sent off evenly at each: K, by wavelength and wave.
void EclipsedAir::fill_transfers() {
  const SmallSkyTables& small = *tables_.small;
  const f32::SmallSkyFrame& frame = small.frame;
  const f32::sampler2D air{small.air.data(), frame.levels, 3};
  const auto ground_km = static_cast<double>(frame.ground_km);
  static const std::vector<QuadratureNode> rule = gauss_legendre(ray_nodes);
  const BesselTable bessel(2500.0 * most_per_km);
  const std::size_t wavelengths = small.wavelengths_nm.size();
  responses_.assign(wavelengths * wave_count, Matrix{});
  verticals_ = responses_;
  std::array<double, wave_count> waves{};
  double sine2 = 0.0; // of the ray's altitude
  const auto add = [&](std::size_t to, std::size_t from, double share, const f32::vec4& light) {
    for (std::size_t l = 0; l < wavelengths; ++l) {
      const double sent = share * static_cast<double>(light[static_cast<int>(l)]);
      for (std::size_t k = 0; k < wave_count; ++k) {
        responses_[l * wave_count + k][to][from] += sent * waves[k];
        verticals_[l * wave_count + k][to][from] += sent * waves[k] * sine2;
      }
    }
  };
  for (std::size_t to = 0; to < places; ++to) {
    const bool level = to == ground;
    const double height = level ? 0.0 : static_cast<double>(heights_km[to]);
    const double radius = ground_km + height;
    const double horizon = -std::sqrt(height * (2.0 * ground_km + height)) / radius;
    for (const bool below : {false, true}) {
      if (below && level) {
        continue;
      }
      for (const QuadratureNode& node : rule) {
        // Rays crowd at the horizon.
        const double range = below ? -1.0 - horizon : 1.0 - horizon;
        const double sine = horizon + range * node.place * node.place;
        sine2 = sine * sine;
        const double width = std::abs(range) * 2.0 * node.place * node.weight;
        const double weight = level ? 2.0 * sine * width : 0.5 * width;
        const double cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
        const f32::SmallSkyRay ray =
            f32::small_sky_ray(static_cast<float>(height), static_cast<float>(sine), below, frame);
        const auto wave_at = [&](double along) {
          const double distance = ground_km * std::atan2(along * cosine, radius + along * sine);
          for (std::size_t k = 0; k < wave_count; ++k) {
            waves[k] = bessel(distance * most_per_km * static_cast<double>(k) / (wave_count - 1));
          }
        };
        f32::vec4 left(static_cast<float>(weight));
        for (int i = 0; i < ray_steps; ++i) {
          const float from = static_cast<float>(i) / ray_steps;
          const float next = static_cast<float>(i + 1) / ray_steps;
          const float step_km = ray.length_km * (next * next - from * from);
          const float along = ray.length_km * 0.5F * (from * from + next * next);
          const float at_km = f32::small_sky_point(ray, along, 0.0F, 0.0F, frame).x;
          const f32::SmallSkyAir here = f32::small_sky_air(air, at_km, frame);
          const f32::vec4 unscattered = forward_ * here.aerosol_per_km;
          const f32::vec4 extinction = glm::max(here.extinction_per_km - unscattered, f32::vec4(1.0e-9F));
          const f32::vec4 passed = glm::exp(-step_km * extinction);
          const f32::vec4 sent = left * (f32::vec4(1.0F) - passed) / extinction *
                                 (here.molecules_per_km + here.aerosol_per_km - unscattered);
          wave_at(static_cast<double>(along));
          const HeightPlace place = height_place(at_km);
          const auto share = static_cast<double>(place.above);
          add(to, place.below, 1.0 - share, sent);
          add(to, place.below + 1, share, sent);
          left *= passed;
        }
        if (below) {
          wave_at(static_cast<double>(ray.length_km));
          add(to, ground, 1.0, left * albedo_);
        }
      }
    }
  }
}

/// All flights together, K + K^2 + ... = (1 - K)^-1 K. No pivot is needed: each row of K sums to less than 1.
void EclipsedAir::solve() {
  for (Matrix& transfer : responses_) {
    Matrix left{};
    for (std::size_t i = 0; i < places; ++i) {
      for (std::size_t j = 0; j < places; ++j) {
        left[i][j] = (i == j ? 1.0 : 0.0) - transfer[i][j];
      }
    }
    for (std::size_t pivot = 0; pivot < places; ++pivot) {
      const double scale = 1.0 / left[pivot][pivot];
      for (std::size_t j = 0; j < places; ++j) {
        left[pivot][j] *= scale;
        transfer[pivot][j] *= scale;
      }
      for (std::size_t i = 0; i < places; ++i) {
        const double factor = i == pivot ? 0.0 : left[i][pivot];
        for (std::size_t j = 0; j < places && factor != 0.0; ++j) {
          left[i][j] -= factor * left[pivot][j];
          transfer[i][j] -= factor * transfer[pivot][j];
        }
      }
    }
  }
}

EclipsedAir::Diffuse EclipsedAir::diffuse(std::size_t wavelength, double per_km, const Column& sunlit) const {
  const double place = std::clamp(per_km / most_per_km, 0.0, 1.0) * (wave_count - 1);
  const std::size_t wave = std::min(static_cast<std::size_t>(place), wave_count - 2);
  const double t = place - static_cast<double>(wave);
  const auto product = [&](const std::vector<Matrix>& matrices, const Column& column) {
    const Matrix& low = matrices[wavelength * wave_count + wave];
    const Matrix& high = matrices[wavelength * wave_count + wave + 1];
    Column result{};
    for (std::size_t i = 0; i < places; ++i) {
      for (std::size_t j = 0; j < places; ++j) {
        result[i] += (low[i][j] + t * (high[i][j] - low[i][j])) * column[j];
      }
    }
    return result;
  };
  Diffuse result{product(responses_, sunlit), {}};
  Column all = sunlit;
  for (std::size_t i = 0; i < places; ++i) {
    all[i] += result.mean[i];
  }
  result.vertical = product(verticals_, all);
  return result;
}

} // namespace vesper
