// The light field where methods fail.
#include "vesper/atmosphere/light_field.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/base/error.hpp"

#include "support/media.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace vesper {
namespace {

constexpr LightFieldSize small{10, 10, 4, 10, 4, 0.3, 1.0, 0.1, 4};

Vec3 toward(double azimuth_deg, double altitude_deg) {
  const double azimuth = azimuth_deg * std::numbers::pi / 180.0;
  const double altitude = altitude_deg * std::numbers::pi / 180.0;
  return {std::cos(altitude) * std::cos(azimuth), std::cos(altitude) * std::sin(azimuth), std::sin(altitude)};
}

void expect_possible_everywhere(const Medium& medium, const std::string& name) {
  const std::vector<double> wavelengths{440.0, 550.0, 680.0};
  const SampledAir air(medium);
  const SpectralAir optics(medium, wavelengths);
  const LightField field(air, optics, small);
  for (const double height : {0.0, 1.0e-9, 0.5, 20.0, 99.999, 100.0, 130.0, 40000.0}) {
    for (const double light : {90.0, 45.0, 0.0, -1.0e-9, -0.2, -5.0, -30.0, -90.0}) {
      for (const double view : {90.0, 30.0, 0.0, -1.0e-9, -0.5, -10.0, -90.0}) {
        for (const double azimuth : {0.0, 90.0, 180.0}) {
          const SkyQuery query{height * kilometre, toward(0.0, light), 0.2666 * deg, toward(azimuth, view)};
          for (const double radiance : field.radiance(query)) {
            EXPECT_TRUE(std::isfinite(radiance) && radiance >= 0.0)
                << name << ", height " << height << " km, light " << light << ", view " << view << ": " << radiance;
          }
        }
      }
      for (const double irradiance : field.diffuse_irradiance(toward(0.0, light).z)) {
        EXPECT_TRUE(std::isfinite(irradiance) && irradiance >= 0.0) << name;
      }
    }
  }
}

TEST(LightFieldStability, BothPresets) {
  expect_possible_everywhere(published_medium(), "published");
  expect_possible_everywhere(clear_medium(), "clear");
}

TEST(LightFieldStability, AsymmetriesFromMinus099To099) {
  for (const double g : {-0.99, 0.0, 0.99}) {
    Medium medium = published_medium();
    medium.components[1].phase = {PhaseKind::henyey_greenstein, [g](double) { return g; }};
    expect_possible_everywhere(medium, "g = " + std::to_string(g));
  }
}

TEST(LightFieldStability, NoAirAndAHundredTimesTheAir) {
  expect_possible_everywhere(test::scaled(published_medium(), 0.0), "no air");
  expect_possible_everywhere(test::scaled(published_medium(), 100.0), "a hundredfold");
}

TEST(LightFieldStability, AlbedoZeroAndOne) {
  for (const double albedo : {0.0, 1.0}) {
    Medium medium = published_medium();
    medium.ground_albedo = [albedo](double) { return albedo; };
    expect_possible_everywhere(medium, "albedo " + std::to_string(albedo));
  }
}

TEST(LightFieldStability, RefusesMoreWavelengthsThanItHolds) {
  std::vector<double> wavelengths(65);
  std::iota(wavelengths.begin(), wavelengths.end(), 450.0);
  const SampledAir air(published_medium());
  const SpectralAir optics(published_medium(), wavelengths);
  EXPECT_THROW(LightField(air, optics, small), Error);
}

TEST(LightFieldStability, RefusesSizesThatHoldNothing) {
  const SampledAir air(published_medium());
  const SpectralAir optics(published_medium(), {550.0});
  LightFieldSize size = small;
  size.heights = 1;
  EXPECT_THROW(LightField(air, optics, size), Error);
  size = small;
  size.later_zeniths = 2;
  EXPECT_THROW(LightField(air, optics, size), Error);
  size = small;
  size.least_step_km = 0.0;
  EXPECT_THROW(LightField(air, optics, size), Error);
}

} // namespace
} // namespace vesper
