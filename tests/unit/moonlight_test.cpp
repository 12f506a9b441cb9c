// The Moon's light by phase and distance.
#include "vesper/base/error.hpp"
#include "vesper/light/earthshine.hpp"
#include "vesper/light/lunar_surface.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace vesper {
namespace {

TEST(Moonlight, MagnitudeFollowsThePhaseLaw) {
  EXPECT_NEAR(moon_v_magnitude(0.0 * deg), -12.73 - 0.31, 1e-12);
  // Quarter: 2.34 + 0.26 mag fainter.
  EXPECT_NEAR(moon_v_magnitude(90.0 * deg), -12.73 + 2.34 + 0.26244, 1e-12);
  EXPECT_EQ(moon_v_magnitude(180.0 * deg), std::numeric_limits<double>::infinity());
  // Joined at 150 degrees without a step.
  EXPECT_NEAR(moon_v_magnitude(150.0 * deg), moon_v_magnitude(150.000001 * deg), 1e-6);
}

TEST(Moonlight, OfTheNewMoonIsNone) {
  const Spectrum light = moon_irradiance(180.0 * deg, moon_mean_distance, astronomical_unit);
  for (const double value : light.values()) {
    EXPECT_EQ(value, 0.0);
  }
}

TEST(Earthlight, FollowsPhaseAndDistance) {
  const double full = earth_irradiance(0.0 * deg, moon_mean_distance, astronomical_unit)(550.0);
  EXPECT_NEAR(earth_irradiance(0.0 * deg, 2.0 * moon_mean_distance, astronomical_unit)(550.0), full / 4.0,
              1e-12 * full);
  EXPECT_NEAR(earth_irradiance(0.0 * deg, moon_mean_distance, 2.0 * astronomical_unit)(550.0), full / 4.0,
              1e-12 * full);
  for (const EarthPhaseLaw law : {EarthPhaseLaw::measured, EarthPhaseLaw::polynomial}) {
    EXPECT_DOUBLE_EQ(earth_phase_light(0.0 * deg, law), 1.0);
    double last = 1.01; // the measured law rises by 0.1 % in the first 3 degrees
    for (double phase = 0.0; phase <= 180.0; phase += 0.5) {
      const double light = earth_phase_light(phase * deg, law);
      EXPECT_GE(light, 0.0);
      EXPECT_LE(light, last + 2e-3) << phase;
      last = light;
    }
    EXPECT_LT(last, 0.01);
  }
  // Both laws send the same from the full Earth at 550 nm; the tint takes from the red.
  const Spectrum cheap = earth_irradiance(0.0 * deg, moon_mean_distance, astronomical_unit, EarthPhaseLaw::polynomial);
  EXPECT_NEAR(cheap(550.0), full, 1e-3 * full);
  EXPECT_LT(cheap(680.0) / cheap(550.0), solar_irradiance_1au()(680.0) / solar_irradiance_1au()(550.0));
}

TEST(Earthlight, ComesFromADisc) {
  constexpr double radius = 0.95;
  // The mean angle over an even disc: 2/3 of the radius from its centre, 32/(9 pi) from its edge.
  EXPECT_NEAR(earthlight_phase(0.0 * deg, radius * deg).to(deg), 2.0 / 3.0 * radius, 1e-12);
  EXPECT_NEAR(earthlight_phase(radius * deg, radius * deg).to(deg), 1.1318 * radius, 0.08 * radius);
}

// From the lux of the spectrum back to V, with the lux per V of the spectrum itself.
TEST(Moonlight, SpectrumHasTheMagnitudeOfThePhaseLaw) {
  const double a0 = lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  for (double phase = 0.0; phase < 180.0; phase += 7.5) {
    const Spectrum light = moon_irradiance(phase * deg, moon_mean_distance, astronomical_unit);
    const double v = v_of_illuminance(integrate_xyzs(light).y * lux, lux_per_v_flux(light) / a0);
    EXPECT_NEAR(v, moon_v_magnitude(phase * deg), 1e-11) << phase;
  }
}

TEST(Moonlight, FallsWithTheSquareOfBothDistances) {
  const double mean = integrate_xyzs(moon_irradiance(30.0 * deg, moon_mean_distance, astronomical_unit)).y;
  EXPECT_NEAR(integrate_xyzs(moon_irradiance(30.0 * deg, 2.0 * moon_mean_distance, astronomical_unit)).y, mean / 4.0,
              1e-15 + 1e-12 * mean);
  EXPECT_NEAR(integrate_xyzs(moon_irradiance(30.0 * deg, moon_mean_distance, 0.5 * astronomical_unit)).y, mean * 4.0,
              1e-15 + 1e-11 * mean);
}

TEST(Moonlight, IsFiniteAndFallsOverAllPhases) {
  double last = std::numeric_limits<double>::infinity();
  for (double phase = 0.0; phase <= 180.0; phase += 0.5) {
    const Spectrum light = moon_irradiance(phase * deg, moon_mean_distance, astronomical_unit);
    EXPECT_LE(light.wavelengths_nm().front(), 360.0);
    EXPECT_GE(light.wavelengths_nm().back(), 830.0);
    for (const double value : light.values()) {
      ASSERT_TRUE(std::isfinite(value) && (value > 0.0 || phase == 180.0)) << phase;
    }
    EXPECT_LT(light(550.0), last) << phase;
    last = light(550.0);
  }
}

TEST(Moonlight, RefusesPhasesAndDistancesThatAreNone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double phase : {-1.0e-9, 180.001, nan}) {
    EXPECT_THROW(static_cast<void>(moon_v_magnitude(phase * deg)), Error) << phase;
    EXPECT_THROW(static_cast<void>(moon_irradiance(phase * deg, moon_mean_distance, astronomical_unit)), Error)
        << phase;
    EXPECT_THROW(static_cast<void>(lunar_law(phase * deg)), Error) << phase;
    EXPECT_THROW(static_cast<void>(earth_phase_light(phase * deg)), Error) << phase;
  }
  for (const double distance : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(static_cast<void>(moon_irradiance(0.0 * deg, distance * metre, astronomical_unit)), Error);
    EXPECT_THROW(static_cast<void>(moon_irradiance(0.0 * deg, moon_mean_distance, distance * metre)), Error);
    EXPECT_THROW(static_cast<void>(earth_irradiance(0.0 * deg, distance * metre, astronomical_unit)), Error);
    EXPECT_THROW(static_cast<void>(earth_irradiance(0.0 * deg, moon_mean_distance, distance * metre)), Error);
  }
}

} // namespace
} // namespace vesper
