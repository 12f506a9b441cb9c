#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/sky_table_parts.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numbers>
#include <string>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr std::size_t most_wavelengths = 8; ///< by measurement: docs/SKY_TABLES.md
/// Logarithm to base 2 of the least share that light scattered once by aerosol is given of the other light, so that a
/// shadow's edge is no cliff that interpolation overshoots.
constexpr float least_aerosol_log2 = -14.0F;

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
  Filler(const Medium& medium, const SkyTableSize& size, unsigned threads, const Progress& progress,
         const LightFieldSolver& solver)
      : threads_(threads), progress_(progress), field_size_(size.field), solver_(solver),
        sunlit_(medium, most_wavelengths), tables_(tables_without_light(sunlit_, size, threads)) {}

  SkyTables operator()() {
    const LightField field = solve();
    report(0.5);
    fill_ground(field);
    fill_scattering(field);
    return std::move(tables_);
  }

private:
  [[nodiscard]] LightField solve() const {
    if (!solver_) {
      return {sunlit_.air(), sunlit_.optics(), field_size_, threads_};
    }
    const LightFieldModel model(sunlit_.air(), sunlit_.optics(), field_size_, threads_);
    return {model, solver_(model)};
  }

  void report(double share) const {
    if (progress_) {
      progress_(share);
    }
  }

  void fill_ground(const LightField& field) {
    for (int i = 0; i < tables_.frame.lights; ++i) {
      const auto altitude = static_cast<double>(f32::sky_node_light_rad(i, tables_.frame));
      tables_.ground.push_back(
          log2_of(sunlit_.responses(field.diffuse_irradiance(std::sin(altitude))), sky_darkest_log2));
    }
  }

  void fill_scattering(const LightField& field) {
    const f32::SkyTableFrame& frame = tables_.frame;
    const auto lights = static_cast<std::size_t>(frame.lights);
    const auto rows = static_cast<std::size_t>(frame.views_below) + static_cast<std::size_t>(frame.views_above);
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
    const LightField::ViewRay ray =
        field.view_ray(sunlit_.air().ground_km() + static_cast<double>(height_km), std::sin(view));
    const float path_share = f32::sky_path_share(height_km, altitude, below, frame);
    for (int l = 0; l < frame.lights; ++l) {
      const auto light = static_cast<double>(f32::sky_node_light_rad(l, frame));
      for (int k = 0; k < f32::sky_azimuths; ++k, ++texel) {
        const double cos_azimuth = std::cos(pi * k / (f32::sky_azimuths - 1));
        const LightField::RayLight seen = field.light(ray, std::sin(light), cos_azimuth, mean_light_radius);
        const f32::vec4 other = log2_of(sunlit_.responses(seen.other) / path_share, sky_darkest_log2);
        const double cos_angle = std::sin(view) * std::sin(light) + std::cos(view) * std::cos(light) * cos_azimuth;
        const float phase =
            f32::sky_aerosol_phase(line_sampler(tables_.phase), static_cast<float>(cos_angle), sky_phase_nodes);
        const f32::vec4 aerosol =
            log2_of(sunlit_.responses(seen.single_aerosol) / (path_share * phase), sky_darkest_log2);
        tables_.other[texel] = other;
        tables_.aerosol[texel] = glm::max(aerosol, other + f32::vec4(least_aerosol_log2));
      }
    }
  }

  unsigned threads_;
  const Progress& progress_;
  LightFieldSize field_size_;
  const LightFieldSolver& solver_;
  SunlitAir sunlit_;
  SkyTables tables_;
};

} // namespace

SkyTables make_sky_tables(const Medium& medium, const SkyTableSize& size, unsigned threads, const Progress& progress,
                          const LightFieldSolver& solver) {
  validate(size);
  return Filler(medium, size, threads, progress, solver)();
}

} // namespace vesper
