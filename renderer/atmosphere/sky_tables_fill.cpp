#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/spectral_rule.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"
#include "vesper/light/sunlight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numbers>
#include <string>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr Angle light_radius = 0.2666 * deg; ///< of Sun and Moon
constexpr std::size_t most_wavelengths = 8;  ///< by measurement: docs/SKY_TABLES.md
constexpr int phase_nodes = 256;
constexpr f32::SkyTransmittanceFrame transmittance_nodes{96, 48};
/// Logarithms to base 2 of what is dark; and of the least share that light scattered once by aerosol is given of the
/// other light, so that a shadow's edge is no cliff that interpolation overshoots.
constexpr float darkest_log2 = -100.0F;
constexpr float least_aerosol_log2 = -14.0F;

f32::vec4 to_vec4(const Xyzs& light) {
  return {static_cast<float>(light.x), static_cast<float>(light.y), static_cast<float>(light.z),
          static_cast<float>(light.s)};
}

f32::vec4 log2_of(const f32::vec4& light, float least_log2) {
  f32::vec4 result;
  for (int i = 0; i < 4; ++i) {
    result[i] = light[i] > 0.0F ? std::max(std::log2(light[i]), least_log2) : least_log2;
  }
  return result;
}

void validate(const SkyTableSize& size) {
  for (const int nodes : {size.heights, size.views_below, size.views_above, size.lights}) {
    if (nodes < 2 || nodes > 256) {
      throw Error(ErrorKind::argument, "a sky table with " + std::to_string(nodes) + " nodes",
                  {"", "", "Give 2 to 256 for each of its axes"});
    }
  }
}

/// Makes tables: what all its parts need.
class Filler {
public:
  Filler(const Medium& medium, const SkyTableSize& size, unsigned threads, const Progress& progress)
      : threads_(threads), progress_(progress), air_(medium),
        rule_(spectral_rule(medium, solar_irradiance_1au(), most_wavelengths)), optics_(medium, rule_.wavelengths_nm) {
    const Xyzs sun = rule_.weights(std::vector<double>(optics_.size(), 1.0));
    lux_ = sun.y;
    tables_.light = to_vec4({sun.x / lux_, 1.0, sun.z / lux_, sun.s / lux_});
    tables_.frame = {static_cast<float>(air_.ground_km()),
                     static_cast<float>(air_.top_km()),
                     size.heights,
                     size.views_below,
                     size.views_above,
                     size.lights};
  }

  SkyTables operator()() {
    fill_phase();
    fill_transmittance();
    const LightField field(air_, optics_, {}, threads_);
    report(0.5);
    fill_ground(field);
    fill_scattering(field);
    return std::move(tables_);
  }

private:
  template <class Values> [[nodiscard]] f32::vec4 responses(const Values& spectrum) const {
    Xyzs sum;
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      const auto value = static_cast<double>(spectrum[l]) / lux_;
      sum.x += rule_.weights.x[l] * value;
      sum.y += rule_.weights.y[l] * value;
      sum.z += rule_.weights.z[l] * value;
      sum.s += rule_.weights.s[l] * value;
    }
    return to_vec4(sum);
  }

  void report(double share) const {
    if (progress_) {
      progress_(share);
    }
  }

  /// Weighted by what each component scatters at the green wavelength, from the ground to space.
  void fill_phase() {
    const auto& wavelengths = optics_.wavelengths_nm();
    const auto green = static_cast<std::size_t>(
        std::min_element(wavelengths.begin(), wavelengths.end(),
                         [](double a, double b) { return std::abs(a - 550.0) < std::abs(b - 550.0); }) -
        wavelengths.begin());
    const SampledAir::PerComponent columns =
        air_.columns_to_space(air_.ray(air_.ground_km(), 1.0), [](const auto&) { return false; });
    for (int i = 0; i < phase_nodes; ++i) {
      const double place = static_cast<double>(i) / (phase_nodes - 1);
      double sum = 0.0;
      double all = 0.0;
      for (std::size_t c = 0; c < air_.component_count(); ++c) {
        if (optics_.phase_kind(c) != PhaseKind::rayleigh) {
          const double scattering = columns[c] * optics_.scattering_per_km(c, green);
          sum += scattering * optics_.phase(c, green, std::cos(pi * place * place));
          all += scattering;
        }
      }
      tables_.phase.emplace_back(all > 0.0 ? static_cast<float>(std::log2(sum / all)) : -3.65F, 0.0F, 0.0F, 0.0F);
    }
  }

  void fill_transmittance() {
    tables_.transmittance_frame = transmittance_nodes;
    tables_.transmittance.resize(static_cast<std::size_t>(transmittance_nodes.altitudes * transmittance_nodes.heights));
    std::vector<double> albedo;
    for (std::size_t l = 0; l < optics_.size(); ++l) {
      albedo.push_back(optics_.albedo(l));
    }
    tables_.albedo = responses(albedo) / tables_.light;
    parallel_for(
        static_cast<std::size_t>(transmittance_nodes.heights), 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            const double share = static_cast<double>(i) / (transmittance_nodes.heights - 1);
            const double height_km = (air_.top_km() - air_.ground_km()) * share * share;
            const float dip = f32::sky_dip(static_cast<float>(height_km), tables_.frame);
            for (int j = 0; j < transmittance_nodes.altitudes; ++j) {
              const double altitude = static_cast<double>(f32::sky_transmittance_node_rad(j, dip, transmittance_nodes));
              // The horizon itself counts as free.
              AirRay ray = air_.ray(air_.ground_km() + height_km, std::sin(altitude));
              if (ray.meets_ground) {
                ray = air_.ray(air_.ground_km() + height_km, std::sin(altitude + 2.0e-5));
              }
              const SampledAir::PerComponent columns = air_.columns_to_space(ray, [](const auto&) { return false; });
              std::vector<double> left(optics_.size());
              for (std::size_t l = 0; l < optics_.size(); ++l) {
                left[l] = std::exp(-optics_.optical_depth(columns, l));
              }
              tables_.transmittance[i * transmittance_nodes.altitudes + static_cast<std::size_t>(j)] =
                  log2_of(responses(left) / tables_.light, darkest_log2);
            }
          }
        },
        threads_);
  }

  void fill_ground(const LightField& field) {
    for (int i = 0; i < tables_.frame.lights; ++i) {
      const double altitude = static_cast<double>(f32::sky_node_light_rad(i, tables_.frame));
      tables_.ground.push_back(log2_of(responses(field.diffuse_irradiance(std::sin(altitude))), darkest_log2));
    }
  }

  void fill_scattering(const LightField& field) {
    const f32::SkyTableFrame& frame = tables_.frame;
    const auto lights = static_cast<std::size_t>(frame.lights);
    const auto rows = static_cast<std::size_t>(frame.views_below + frame.views_above);
    const std::size_t row_texels = lights * f32::sky_azimuths;
    const auto all_rows = static_cast<std::size_t>(frame.heights) * rows;
    tables_.other.resize(all_rows * row_texels);
    tables_.aerosol.resize(all_rows * row_texels);
    std::mutex reporting;
    std::size_t done = 0;
    parallel_for(
        all_rows, 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) {
            fill_row(field, static_cast<int>(k / rows), static_cast<int>(k % rows), k * row_texels);
          }
          const std::lock_guard lock(reporting);
          done += end - begin;
          report(0.5 + 0.5 * static_cast<double>(done) / static_cast<double>(all_rows));
        },
        threads_);
  }

  void fill_row(const LightField& field, int height, int row, std::size_t texel) {
    const f32::SkyTableFrame& frame = tables_.frame;
    const float height_km = f32::sky_node_height_km(height, frame);
    const float dip = f32::sky_dip(height_km, frame);
    const bool below = row < frame.views_below;
    const float altitude = f32::sky_node_altitude_rad(row, dip, frame);
    // A ray that grazes the ground shall fall on its own side of the horizon.
    constexpr double aside_rad = 2.0e-6;
    const double aside = altitude == -dip ? (below ? -aside_rad : aside_rad) : 0.0;
    const double view = static_cast<double>(altitude) + aside;
    const LightField::ViewRay ray = field.view_ray(air_.ground_km() + static_cast<double>(height_km), std::sin(view));
    const float path_share = f32::sky_path_share(height_km, altitude, below, frame);
    for (int l = 0; l < frame.lights; ++l) {
      const double light = static_cast<double>(f32::sky_node_light_rad(l, frame));
      for (int k = 0; k < f32::sky_azimuths; ++k, ++texel) {
        const double cos_azimuth = std::cos(pi * k / (f32::sky_azimuths - 1));
        const LightField::RayLight seen = field.light(ray, std::sin(light), cos_azimuth, light_radius);
        const f32::vec4 other = log2_of(responses(seen.other) / path_share, darkest_log2);
        const double cos_angle = std::sin(view) * std::sin(light) + std::cos(view) * std::cos(light) * cos_azimuth;
        const float phase =
            f32::sky_aerosol_phase(line_sampler(tables_.phase), static_cast<float>(cos_angle), phase_nodes);
        const f32::vec4 aerosol = log2_of(responses(seen.single_aerosol) / (path_share * phase), darkest_log2);
        tables_.other[texel] = other;
        tables_.aerosol[texel] = glm::max(aerosol, other + f32::vec4(least_aerosol_log2));
      }
    }
  }

  unsigned threads_;
  const Progress& progress_;
  SampledAir air_;
  SpectralRule rule_;
  SpectralAir optics_;
  double lux_ = 1.0;
  SkyTables tables_;
};

} // namespace

SkyTables make_sky_tables(const Medium& medium, const SkyTableSize& size, unsigned threads, const Progress& progress) {
  validate(size);
  return Filler(medium, size, threads, progress)();
}

} // namespace vesper
