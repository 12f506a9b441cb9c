// The sky in the Moon's shadow against the reference transport in the same shadow, and against what has been measured.
#include "vesper/atmosphere/eclipsed_sky.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/moon_shadow.hpp"

#include "support/thorough.hpp"
#include "support/truth.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vesper {
namespace {

std::uint64_t paths(std::uint64_t reduced) { return test::thorough() ? 8 * reduced : reduced; }

/// An umbra 160 km wide at right angles to its axis, which passes `miss_km` north of the observer; the Sun stands
/// south.
class Eclipse {
public:
  static const std::shared_ptr<const EclipsedAir>& air() {
    static const auto made = std::make_shared<const EclipsedAir>(clear_medium());
    return made;
  }
  static std::vector<double> wavelengths_nm() {
    return {air()->wavelengths_nm().begin(), air()->wavelengths_nm().end()};
  }

  Eclipse(double sun_altitude_deg, double miss_km)
      : to_sun_(test::direction(0.0 * deg, sun_altitude_deg * deg)),
        shadow_(moon_shadow(1.51e8 * to_sun_, 360000.0 * to_sun_ + Vec3(0.0, miss_km, 0.0), wavelengths_nm()).value()),
        sky_(air(), shadow_, 0.0 * metre) {}

  [[nodiscard]] const EclipsedSky& sky() const { return sky_; }
  [[nodiscard]] double obscured() const {
    return 1.0 - static_cast<double>(sunlight_at(shadow_, {0.0F, 0.0F, 0.0F}).y);
  }

  /// Of what an estimate holds by wavelength: its Y with the Moon over that without, and the standard error of that.
  template <class Solve> [[nodiscard]] Estimate reference_ratio(const Solve& solve, std::uint64_t most) const {
    // The same paths as far as they go: of partial phases the ratio is then known better than either.
    const Estimate open = y_of(solve(query(false), budget(std::min<std::uint64_t>(most, paths(4000)))));
    const Estimate eclipsed = y_of(solve(query(true), budget(most)));
    const double ratio = eclipsed.mean / open.mean;
    return {ratio, ratio * std::hypot(eclipsed.standard_error / eclipsed.mean, open.standard_error / open.mean)};
  }
  [[nodiscard]] Estimate reference(const Vec3& view, std::uint64_t most) const {
    return reference_ratio(
        [&](SkyQuery query, const PathBudget& budget) {
          query.view_direction = view;
          return transport().radiance(query, {y_weights()}, budget);
        },
        most);
  }
  [[nodiscard]] Estimate reference_level(std::uint64_t most) const {
    return reference_ratio(
        [&](const SkyQuery& query, const PathBudget& budget) {
          return transport().diffuse_irradiance(query, {y_weights()}, budget);
        },
        most);
  }

private:
  static const ReferenceTransport& transport() {
    static const ReferenceTransport made(clear_medium(), wavelengths_nm());
    return made;
  }
  static SpectralFunctional y_weights() {
    SpectralFunctional weights;
    for (std::size_t i = 0; i < wavelengths_nm().size(); ++i) {
      weights.push_back(static_cast<double>(air()->tables().small->responses[static_cast<int>(i)].y));
    }
    return weights;
  }
  static Estimate y_of(const TransportResult& result) { return result.functionals[0]; }
  [[nodiscard]] SkyQuery query(bool eclipsed) const {
    SkyQuery result{0.0 * metre, to_sun_, mean_light_radius, {0.0, 0.0, 1.0}};
    if (eclipsed) {
      result.light_share = [this](const Vec3& place_km, std::span<double> values) {
        const f32::vec4 share = sunlight_at(shadow_, f32::vec3(place_km));
        for (std::size_t i = 0; i < values.size(); ++i) {
          values[i] *= static_cast<double>(share[static_cast<int>(i)]);
        }
      };
    }
    return result;
  }
  static PathBudget budget(std::uint64_t most) {
    PathBudget result;
    result.relative_error = 1.0e-4;
    result.least_paths = result.most_paths = most;
    return result;
  }

  Vec3 to_sun_;
  MoonShadowInAir shadow_;
  EclipsedSky sky_;
};

/// Percent that the model is off; the reference's own standard error is printed beside it.
double percent_off(const std::string& what, double model, const Estimate& reference) {
  const double off = 100.0 * (model / reference.mean - 1.0);
  std::printf("  %s: %.3g of the light is left, by the reference %.3g +- %.1f %%\n", what.c_str(), model,
              reference.mean, 100.0 * reference.standard_error / reference.mean);
  return off;
}

using Views = std::vector<std::pair<double, double>>; // altitude, azimuth from the Sun's, degrees

void compare_eclipsed(const Eclipse& eclipse, const Views& views, std::uint64_t most, test::ErrorSum& errors) {
  for (const auto& [altitude, azimuth] : views) {
    const Vec3 view = test::direction(azimuth * deg, altitude * deg);
    errors.add(percent_off(fmt::format("altitude {}, azimuth {}", altitude, azimuth),
                           static_cast<double>(eclipse.sky().ratios(view).all.y),
                           eclipse.reference(view, paths(most))));
  }
}

TEST(EclipsedSky, MidTotalityAgainstTheReference) {
  test::ErrorSum zenith;
  test::ErrorSum sky;
  test::ErrorSum horizon;
  test::ErrorSum level;
  for (const double sun : {10.0, 30.0, 60.0}) {
    std::printf("Sun %g degrees up\n", sun);
    const Eclipse eclipse(sun, 0.0);
    EXPECT_NEAR(eclipse.obscured(), 1.0, 2.0e-6); // but for the corona
    compare_eclipsed(eclipse, {{90.0, 0.0}}, 30000, zenith);
    compare_eclipsed(eclipse, {{45.0, 180.0}, {10.0, 90.0}}, 30000, sky);
    compare_eclipsed(eclipse, {{3.0, 90.0}}, 30000, horizon);
    if (sun == 30.0 || test::thorough()) {
      level.add(percent_off("level surface", static_cast<double>(eclipse.sky().level_ratio().y),
                            eclipse.reference_level(paths(120000))));
    }
  }
  zenith.hold("zenith luminance in mid-totality against the reference", 50.0, "%");
  sky.hold("luminance of the sky in mid-totality, 10 and 45 degrees up", 30.0, "%");
  horizon.hold("luminance 3 degrees over the horizon in mid-totality", 30.0, "%");
  level.hold("diffuse illuminance in mid-totality", 25.0, "%");
}

TEST(EclipsedSky, EdgeOfTheUmbraAgainstTheReference) {
  const Eclipse eclipse(30.0, 83.0);
  EXPECT_GT(eclipse.obscured(), 0.9995);
  test::ErrorSum errors;
  compare_eclipsed(eclipse, {{90.0, 0.0}, {45.0, 180.0}, {10.0, 0.0}, {3.0, 180.0}}, 30000, errors);
  errors.hold("luminance of the sky at the umbra's edge", 25.0, "%");
}

TEST(EclipsedSky, PartialPhasesAgainstTheReference) {
  test::ErrorSum errors;
  test::ErrorSum level;
  for (const double miss_km : {420.0, 1300.0}) {
    const Eclipse eclipse(30.0, miss_km);
    std::printf("%.1f %% of the Sun's light gone\n", 100.0 * eclipse.obscured());
    compare_eclipsed(eclipse, {{90.0, 0.0}, {45.0, 180.0}, {10.0, 90.0}, {3.0, 0.0}}, 4000, errors);
    level.add(percent_off("level surface", static_cast<double>(eclipse.sky().level_ratio().y),
                          eclipse.reference_level(paths(4000))));
  }
  errors.hold("luminance of the sky in partial phases up to 92 %", 1.0, "%");
  level.hold("diffuse illuminance in partial phases up to 92 %", 1.0, "%");
}

// Dandekar and Turtle (1971, Applied Optics 10, 1220) found the zenith at totality darker than by day by about four
// orders of magnitude. Illuminances of 1 to 10 lux have been read in many eclipses, and a horizon some 10 to 30 times
// as bright as the zenith.
TEST(EclipsedSky, IsAsBrightAsTotalityHasBeenSeen) {
  const Eclipse eclipse(40.0, 0.0);
  const SkyTables& tables = Eclipse::air()->tables();
  const Vec3 to_sun = test::direction(0.0 * deg, 40.0 * deg);
  constexpr double sunlight_lux = 133000.0;
  const auto luminance = [&](const Vec3& view) {
    return sunlight_lux * sky_luminance(tables, {0.0 * metre, to_sun, mean_light_radius, view}).y *
           static_cast<double>(eclipse.sky().ratios(view).all.y);
  };
  const double left = static_cast<double>(eclipse.sky().ratios({0.0, 0.0, 1.0}).all.y);
  EXPECT_NEAR(std::log10(left), -4.0, 0.5);
  const double zenith = luminance({0.0, 0.0, 1.0});
  for (const double azimuth : {60.0, 90.0, 120.0}) {
    const double horizon = luminance(test::direction(azimuth * deg, 3.0 * deg));
    std::printf("horizon over zenith, %g degrees from the Sun: %.1f\n", azimuth, horizon / zenith);
    EXPECT_GT(horizon / zenith, 8.0);
    EXPECT_LT(horizon / zenith, 40.0);
  }
}

} // namespace
} // namespace vesper
