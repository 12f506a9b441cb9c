// Single scattering at the ends of its ranges.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/single_scattering.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/error.hpp"

#include "support/media.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace vesper {
namespace {

const Vec3 to_zenith(0.0, 0.0, 1.0);
const Vec3 to_horizon(1.0, 0.0, 0.0);

Vec3 at_elevation(double altitude_rad) { return {std::cos(altitude_rad), 0.0, std::sin(altitude_rad)}; }

double radiance(const Medium& medium, double height_km, const Vec3& light, const Vec3& view) {
  const SingleScattering result = single_scattering(medium, {height_km * kilometre, light, 0.0 * deg, view}, {550.0});
  EXPECT_TRUE(std::isfinite(result.radiance[0]) && result.radiance[0] >= 0.0);
  EXPECT_GE(result.error[0], 0.0);
  EXPECT_LE(result.error[0], 1.0e-6 * result.radiance[0] + 1.0e-290);
  return result.radiance[0];
}

TEST(SingleScatteringStability, EveryDirectionFromEveryHeightUnderEverySun) {
  for (const double factor : {1.0, 100.0}) {
    const Medium air = test::scaled(published_medium(), factor);
    for (const double height : {0.0, 1.0e-9, 0.5, 12.0, 99.999999, 100.0, 101.0, 1.0e6}) {
      const double limb = -std::acos(6360.0 / (6360.0 + height));
      for (const double sun : {90.0, 30.0, 0.01, 0.0, -0.01, -5.0, -18.0, -60.0, -90.0}) {
        const Vec3 light = at_elevation(sun * std::numbers::pi / 180.0);
        for (const Vec3& view :
             {to_zenith, -to_zenith, to_horizon, -to_horizon, Vec3(0.0, 1.0, 0.0), light, -light, at_elevation(limb),
              at_elevation(limb + 1.0e-9), at_elevation(limb - 1.0e-9), at_elevation(-0.5), at_elevation(1.0)}) {
          SCOPED_TRACE(::testing::Message() << factor << " fold, " << height << " km, sun " << sun << ", view "
                                            << view.x << " " << view.y << " " << view.z);
          radiance(air, height, light, view);
        }
      }
    }
  }
}

TEST(SingleScatteringStability, PeaksOfThePhaseFunction) {
  for (const double g : {-0.99, 0.0, 0.99}) {
    Medium air = published_medium();
    air.components[1].phase = {PhaseKind::henyey_greenstein, constant_law(g)};
    const double forward = radiance(air, 0.0, at_elevation(0.3), at_elevation(0.3));
    const double sideways = radiance(air, 0.0, at_elevation(0.3), Vec3(0.0, 0.0, 1.0));
    EXPECT_GT(forward, 0.0);
    EXPECT_GT(sideways, 0.0);
    if (g > 0.0) {
      EXPECT_GT(forward, 100.0 * sideways);
    }
  }
}

TEST(SingleScatteringStability, NoAirShowsTheGroundOnly) {
  for (const double albedo : {0.0, 1.0}) {
    Medium air = test::scaled(published_medium(), 0.0);
    air.ground_albedo = constant_law(albedo);
    for (const double height : {0.0, 3.0, 100.0, 5000.0}) {
      EXPECT_EQ(radiance(air, height, at_elevation(0.5), to_zenith), 0.0);
      EXPECT_NEAR(radiance(air, height, at_elevation(0.5), -to_zenith), albedo * std::numbers::inv_pi * std::sin(0.5),
                  1.0e-15);
      EXPECT_EQ(radiance(air, height, at_elevation(-0.5), -to_zenith), 0.0);
    }
  }
}

TEST(SingleScatteringStability, GroundLightIsProportionalToAlbedo) {
  Medium air = published_medium();
  std::vector<double> down;
  for (const double albedo : {0.0, 0.5, 1.0}) {
    air.ground_albedo = constant_law(albedo);
    down.push_back(radiance(air, 10.0, at_elevation(0.7), -to_zenith));
  }
  EXPECT_NEAR(down[1] - down[0], 0.5 * (down[2] - down[0]), 1.0e-12);
  EXPECT_GT(down[2], down[0]);
}

TEST(SingleScatteringStability, LayersWithoutThicknessAndOverlapping) {
  const Medium base = published_medium();
  const double without = radiance(base, 0.0, at_elevation(0.2), to_zenith);
  Medium air = base;
  air.components.push_back({"none",
                            HeightProfile::tent(20.0, 20.0, 20.0),
                            constant_law(1.0),
                            constant_law(1.0),
                            {PhaseKind::henyey_greenstein, constant_law(0.5)}});
  EXPECT_NEAR(radiance(air, 0.0, at_elevation(0.2), to_zenith), without, 1.0e-9 * without);
  // Two halves of a component in the same place are the whole one.
  air = base;
  for (WavelengthLaw* law : {&air.components[1].scattering_per_km, &air.components[1].absorption_per_km}) {
    *law = [old = *law](double nm) { return 0.5 * old(nm); };
  }
  air.components.push_back(air.components[1]);
  EXPECT_NEAR(radiance(air, 0.0, at_elevation(0.2), to_zenith), without, 1.0e-9 * without);
  // A thin sheet far up in otherwise thin air is not missed, also in twilight.
  for (const double thickness_km : {1.0e-3, 1.0}) {
    air = test::scaled(base, 1.0e-9);
    air.components[0].profile =
        HeightProfile::table({60.0, 60.0 + thickness_km}, {1.0, 1.0}, HeightProfile::Between::linear);
    const double expected = air.components[0].scattering_per_km(550.0) * thickness_km;
    const Vec3 light = at_elevation(-0.1);
    const double phase = air.components[0].phase(light.z, 550.0);
    EXPECT_NEAR(radiance(air, 0.0, light, to_zenith) / (expected * phase), 1.0, 1.0e-6);
  }
}

TEST(SingleScatteringStability, TheShadowIsCutWhereItLies) {
  // Even, all but clear air: what is lit of the to_zenith's ray is proportional to what is seen.
  Medium air = test::scaled(published_medium(), 0.0);
  air.components[0].profile = HeightProfile::table({0.0, 100.0}, {1.0, 1.0}, HeightProfile::Between::linear);
  air.components[0].scattering_per_km = constant_law(1.0e-15);
  for (const double sun : {-0.001, -0.05, -0.1, -0.17}) {
    const double lit_km = 100.0 - 6360.0 * (1.0 / std::cos(sun) - 1.0);
    const double phase = air.components[0].phase(std::sin(sun), 550.0);
    EXPECT_NEAR(radiance(air, 0.0, at_elevation(sun), to_zenith) / (1.0e-15 * phase), lit_km, 1.0e-8) << sun;
  }
  EXPECT_EQ(radiance(air, 0.0, at_elevation(-0.18), to_zenith), 0.0);
}

TEST(SingleScatteringStability, GroundAndTopAreMetContinuously) {
  const Medium air = published_medium();
  for (const double altitude : {0.0, 0.3, 1.5}) {
    const double on = radiance(air, 0.0, at_elevation(0.4), at_elevation(altitude));
    EXPECT_NEAR(radiance(air, 1.0e-6, at_elevation(0.4), at_elevation(altitude)), on, 1.0e-5 * on);
  }
  const double in = radiance(air, 99.999999, at_elevation(0.4), at_elevation(-0.1));
  EXPECT_NEAR(radiance(air, 100.0, at_elevation(0.4), at_elevation(-0.1)), in, 1.0e-6 * in);
  // From far outside the same ray shows the same.
  const double chord = std::sqrt(6460.0 * 6460.0 - 6361.0 * 6361.0);
  for (const double far : {chord, 3000.0, 400000.0}) {
    const double distance = std::hypot(6361.0, far);
    const Vec3 view(std::sin(std::asin(6361.0 / distance)), 0.0, -far / distance);
    const Vec3 light(0.0, 1.0, 0.0);
    const double expected =
        radiance(air, std::hypot(6361.0, chord) - 6360.0, light, Vec3(6361.0 / 6460.0, 0.0, -chord / 6460.0));
    EXPECT_NEAR(radiance(air, distance - 6360.0, light, view), expected, 1.0e-6 * expected) << far;
  }
}

TEST(SingleScatteringStability, BoundsHold) {
  const Medium air = clear_medium();
  for (const double sun : {0.5, 0.01, -0.08}) {
    for (const double altitude : {0.001, 0.2, 1.5}) {
      const SkyQuery query{2.0 * kilometre, at_elevation(sun), 0.0 * deg, at_elevation(altitude)};
      const SingleScattering rough = single_scattering(air, query, {400.0, 700.0}, 1.0e-2);
      const SingleScattering fine = single_scattering(air, query, {400.0, 700.0}, 1.0e-8);
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_LE(std::abs(rough.radiance[k] - fine.radiance[k]),
                  rough.error[k] + fine.error[k] + 1.0e-14 * fine.radiance[k]);
        EXPECT_LE(rough.error[k], 1.0e-2 * rough.radiance[k]);
        EXPECT_LE(fine.error[k], 2.0e-8 * fine.radiance[k]);
      }
    }
  }
}

TEST(SingleScatteringStability, ASpectrumThatIsZeroSomewhere) {
  // The published medium is empty outside its samples; its dark wavelengths must not disturb the others.
  const Medium air = published_medium();
  const SkyQuery query{0.0 * kilometre, at_elevation(-0.1), 0.0 * deg, to_zenith};
  const SingleScattering both = single_scattering(air, query, {550.0, 900.0});
  EXPECT_EQ(both.radiance[1], 0.0);
  EXPECT_EQ(both.error[1], 0.0);
  EXPECT_EQ(both.radiance[0], single_scattering(air, query, {550.0}).radiance[0]);
}

TEST(SingleScatteringBadInput, IsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Medium air = published_medium();
  const auto ask = [&](double height_km, const Vec3& light, const Vec3& view, const std::vector<double>& nm,
                       double error) {
    (void)single_scattering(air, {height_km * kilometre, light, 0.0 * deg, view}, nm, error);
  };
  EXPECT_NO_THROW(ask(0.0, to_zenith, to_zenith, {550.0}, 1.0e-6));
  for (const double height : {-1.0e-6, nan, infinity}) {
    EXPECT_THROW(ask(height, to_zenith, to_zenith, {550.0}, 1.0e-6), Error);
  }
  EXPECT_THROW(ask(0.0, 2.0 * to_zenith, to_zenith, {550.0}, 1.0e-6), Error);
  EXPECT_THROW(ask(0.0, to_zenith, Vec3(nan, 0.0, 0.0), {550.0}, 1.0e-6), Error);
  EXPECT_THROW(ask(0.0, to_zenith, to_zenith, {}, 1.0e-6), Error);
  for (const double error : {0.0, -1.0, 1.0, nan}) {
    EXPECT_THROW(ask(0.0, to_zenith, to_zenith, {550.0}, error), Error);
  }
  Medium wrong = air;
  wrong.ground_albedo = constant_law(1.5);
  EXPECT_THROW((void)single_scattering(wrong, {0.0 * kilometre, to_zenith, 0.0 * deg, to_zenith}, {550.0}), Error);
}

} // namespace
} // namespace vesper
