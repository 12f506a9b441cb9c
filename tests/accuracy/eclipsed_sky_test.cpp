// The sky in the Moon's shadow against the reference transport in the same shadow.
#include "vesper/atmosphere/eclipsed_sky.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/moon_shadow.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

namespace vesper {
namespace {

const std::shared_ptr<const EclipsedAir>& clear_air() {
  static const auto air = std::make_shared<const EclipsedAir>(clear_medium());
  return air;
}

TEST(EclipsedSky, Measure) {
  const auto& air = clear_air();
  const std::vector<double> nm(air->wavelengths_nm().begin(), air->wavelengths_nm().end());
  const ReferenceTransport reference(clear_medium(), nm);
  const double sun_alt = std::atof(std::getenv("SUN"));
  const double miss = std::atof(std::getenv("MISS"));
  const double ang = std::atof(std::getenv("ANG"));
  PathBudget budget;
  budget.relative_error = 1e-4;
  budget.least_paths = static_cast<std::uint64_t>(std::atof(std::getenv("PATHS")));
  budget.most_paths = budget.least_paths;
  const Vec3 to_sun = test::direction(0.0 * deg, sun_alt * deg);
  const Vec3 side(0, 1, 0);
  const Vec3 up = glm::cross(to_sun, side);
  const Vec3 off = miss * (std::cos(ang / 57.3) * side + std::sin(ang / 57.3) * up);
  const auto shadow = moon_shadow(1.51e8 * to_sun, 360000.0 * to_sun + off, nm);
  for (double x = 0; x < 400; x += 50) {
    const auto s = sunlight_at(*shadow, f32::vec3(0, x, 0));
    printf("at %g km: %g %g %g %g\n", x, s.x, s.y, s.z, s.w);
  }
  clock_t t0 = clock();
  const EclipsedSky sky(air, *shadow, 0.0 * kilometre, 1);
  printf("chart %g s\n", double(clock() - t0) / CLOCKS_PER_SEC);
  t0 = clock();
  const auto level = sky.level_ratio();
  printf("level %g s\n", double(clock() - t0) / CLOCKS_PER_SEC);
  const LightShare share = [&](const Vec3& at, std::span<double> values) {
    const auto s = sunlight_at(*shadow, f32::vec3(at));
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] *= static_cast<double>(s[static_cast<int>(i)]);
    }
  };
  const auto to_y = [&](const TransportResult& r, bool err) {
    // the table's own weights
    double y = 0, e = 0;
    for (int i = 0; i < int(nm.size()); ++i) {
      const double w = static_cast<double>(air->tables().small->responses[i].y);
      y += w * r.spectrum[size_t(i)].mean;
      e += w * r.spectrum[size_t(i)].standard_error;
    }
    return err ? e : y;
  };
  for (auto [alt, az] : {std::pair(90., 0.), {45., 0.}, {45., 180.}, {20., 90.}, {10., 0.}, {10., 90.}, {10., 180.}, {3., 0.}, {3., 90.}, {3., 180.}}) {
    SkyQuery query{0.0 * kilometre, to_sun, mean_light_radius, test::direction(az * deg, alt * deg)};
    PathBudget plain = budget;
    plain.least_paths = plain.most_paths = 20000;
    const auto open = reference.radiance(query, {}, plain);
    query.light_share = share;
    ++budget.stream;
    const auto dark = reference.radiance(query, {}, budget);
    const auto r = sky.ratios(query.view_direction);
    const double truth = to_y(dark, false) / to_y(open, false);
    printf("alt %g az %g: ratio %.3e model %.3e  model/ref %.3f +- %.3f; lambda:", alt, az, truth, double(r.all.y), double(r.all.y) / truth,
           to_y(dark, true) / to_y(dark, false));
    for (size_t i = 0; i < nm.size(); ++i) printf(" %.2e", dark.spectrum[i].mean / open.spectrum[i].mean);
    printf("  zenith cd/m2 %.3g\n", to_y(dark, false) * 133000);
  }
  SkyQuery query{0.0 * kilometre, to_sun, mean_light_radius, {0, 0, 1}};
  PathBudget plain = budget;
  plain.least_paths = plain.most_paths = 20000;
  const auto open = reference.diffuse_irradiance(query, {}, plain);
  query.light_share = share;
  const auto dark = reference.diffuse_irradiance(query, {}, budget);
  printf("level: ratio %.3e model/ref %.3f +- %.3f lux %.3g\n", to_y(dark, false) / to_y(open, false),
         double(level.y) * to_y(open, false) / to_y(dark, false), to_y(dark, true) / to_y(dark, false), to_y(dark, false) * 133000);
}

} // namespace
} // namespace vesper
