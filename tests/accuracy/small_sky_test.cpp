// Hillaire's small tables against the reference transport: a cheap tier, with the errors that belong to it.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/atmosphere/single_scattering.hpp"
#include "vesper/atmosphere/small_sky_tables.hpp"
#include "vesper/atmosphere/spectral_rule.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace vesper {
namespace {

struct SmallSpan {
  std::vector<double> altitudes_deg; ///< of the Sun
  double limit;                      ///< RMS over the sky, %
  std::string name;
};

void compare_small(const Medium& medium, const std::string& name, const std::vector<SmallSpan>& spans) {
  const SkyTables tables = make_small_sky_tables(medium);
  const SpectralRule rule = spectral_rule(medium, solar_irradiance_1au(), 8);
  const ReferenceTransport reference(medium, rule.wavelengths_nm);
  const SpectralWeights& weights = rule.weights;
  const double lux = weights(std::vector<double>(rule.wavelengths_nm.size(), 1.0)).y;
  PathBudget budget;
  budget.relative_error = 0.01;
  for (const SmallSpan& span : spans) {
    double squares = 0.0;
    std::size_t count = 0;
    for (const double sun : span.altitudes_deg) {
      for (const double altitude : {90.0, 45.0, 15.0, 3.0}) {
        for (const double azimuth : {0.0, 90.0, 180.0}) {
          if (altitude == 90.0 && azimuth > 0.0) {
            continue;
          }
          const SkyQuery query{0.0 * kilometre, test::direction(0.0 * deg, sun * deg), mean_light_radius,
                               test::direction(azimuth * deg, altitude * deg)};
          ++budget.stream;
          const double expected = reference.radiance(query, {weights.y}, budget).functionals[0].mean / lux;
          const double error = sky_luminance(tables, query).y / expected - 1.0;
          squares += error * error;
          ++count;
        }
      }
    }
    test::ErrorSum rms;
    rms.add(100.0 * std::sqrt(squares / static_cast<double>(count)));
    rms.hold("small tables, " + name + ", Sun " + span.name + ": RMS of the luminance over the sky", span.limit, "%");
  }
}

// What other renderers with this method may expect: good by day, of the right order at -6 degrees, nothing below.
TEST(SmallSky, PublishedMediumAgainstTheReference) {
  compare_small(
      published_medium(), "published",
      {{{45.0, 10.0}, 7.0, "above 5 degrees"}, {{2.0, -2.0}, 10.0, "5 to -3 degrees"}, {{-5.0}, 35.0, "-5 degrees"}});
}

TEST(SmallSky, ClearAirAgainstTheReference) {
  compare_small(clear_medium(), "clear",
                {{{45.0, 10.0}, 15.0, "above 5 degrees"}, {{2.0, -2.0}, 20.0, "5 to -3 degrees"}});
}

TEST(SmallSky, LightScatteredOnceIsThatOfTheQuadrature) {
  SkyTables tables = make_small_sky_tables(published_medium());
  SmallSkyTables once = *tables.small;
  for (f32::vec4& texel : once.multiple) {
    texel = f32::vec4(0.0F);
  }
  // One radiance out of the four.
  once.responses = f32::mat4(0.0F);
  once.responses[1] = f32::vec4(1.0F);
  tables.small = std::make_shared<const SmallSkyTables>(once);
  test::ErrorSum errors;
  for (const double sun : {80.0, 30.0, 5.0, 0.0, -3.0}) {
    for (const double altitude : {90.0, 40.0, 10.0, 2.0}) {
      const SkyQuery query{1.0 * kilometre, test::direction(0.0 * deg, sun * deg), mean_light_radius,
                           test::direction(70.0 * deg, altitude * deg)};
      const double expected =
          single_scattering(published_medium(), query, {once.wavelengths_nm[1]}, 1.0e-4).radiance[0];
      errors.add(100.0 * (sky_luminance(tables, query).y / expected - 1.0));
    }
  }
  errors.hold("small tables, light scattered once, against quadrature", 1.0, "%");
}

TEST(SmallSky, StaysFiniteAnywhere) {
  const SkyTables tables = make_small_sky_tables(clear_medium());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const auto anywhere = [&] {
      return test::direction(360.0 * uniform(random) * deg, (180.0 * uniform(random) - 90.0) * deg);
    };
    const double height_km = std::pow(10.0, 6.0 * uniform(random)) - 1.0;
    const Xyzs seen = sky_luminance(tables, {height_km * kilometre, anywhere(), mean_light_radius, anywhere()});
    for (const double value : {seen.y, seen.s}) {
      ASSERT_TRUE(std::isfinite(value) && value >= 0.0) << value << " at " << height_km << " km";
    }
  }
}

} // namespace
} // namespace vesper
