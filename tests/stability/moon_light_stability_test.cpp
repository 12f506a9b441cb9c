// The Moon's light where its laws have limits: opposition, new Moon, terminator and limb, in both precisions.
#include "vesper/base/error.hpp"
#include "vesper/sky/moon_disc.hpp"

#include "support/moon_relief.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

void expect_light(const f64::vec4& light, double most) {
  for (int k = 0; k < 4; ++k) {
    ASSERT_TRUE(std::isfinite(light[k]) && light[k] >= 0.0 && light[k] <= most) << light[k];
  }
}

const std::vector<double>& phases() {
  static const std::vector<double> all{0.0,   1.0e-9, 1.0e-4, 0.3,   7.0,   89.9999, 90.0,      90.0001, 103.9,
                                       104.0, 104.1,  120.0,  149.9, 150.0, 150.1,   179.99999, 180.0};
  return all;
}

TEST(MoonLightStability, LawsAreBoundedAndAlikeInBothPrecisions) {
  for (const double phase : phases()) {
    SCOPED_TRACE(phase);
    const auto single = static_cast<float>(phase);
    const f64::LunarLaw exact = f64::lunar_law(phase);
    const f32::LunarLaw rounded = f32::lunar_law(single);
    const f64::LunarLaw cheap = f64::cheap_lunar_law(phase);
    const f32::LunarLaw cheap_rounded = f32::cheap_lunar_law(single);
    for (const double part : {exact.seeliger, exact.lambert, cheap.seeliger, cheap.lambert}) {
      EXPECT_TRUE(part >= 0.0 && part < 3.0) << part;
    }
    // A float of the phase angle is good to 4e-6 degrees, the sums to some 1e-6.
    EXPECT_NEAR(rounded.seeliger, exact.seeliger, 1.0e-5);
    EXPECT_NEAR(rounded.lambert, exact.lambert, 1.0e-5);
    EXPECT_NEAR(cheap_rounded.seeliger, cheap.seeliger, 1.0e-5);
    EXPECT_NEAR(f32::lunar_phase(single), f64::lunar_phase(phase), 1.0e-6 + 2.0e-6 * f64::lunar_phase(phase));
  }
}

TEST(MoonLightStability, LimitsOfTheLaws) {
  EXPECT_DOUBLE_EQ(f64::seeliger_sphere(0.0), 1.0);
  EXPECT_DOUBLE_EQ(f64::lambert_sphere(0.0), 1.0);
  EXPECT_EQ(f64::lambert_sphere(f64::pi), 0.0);
  EXPECT_EQ(f64::lunar_phase(180.0), 0.0);
  EXPECT_NEAR(f64::lunar_retrodirection(0.0), 2.0, 1.0e-5);
  EXPECT_EQ(f64::lunar_retrodirection(0.5 * pi + 1.0e-12), 1.0);
  EXPECT_NEAR(f64::lunar_retrodirection(0.5 * pi - 1.0e-9), 1.0, 1.0e-9);
  // The lunar-Lambert spheres at a quarter, by their closed forms.
  EXPECT_NEAR(f64::seeliger_sphere(0.5 * pi), 1.0 - std::log(1.0 / std::tan(pi / 8.0)) * std::sqrt(0.5), 1.0e-12);
  EXPECT_NEAR(f64::lambert_sphere(0.5 * pi), 1.0 / pi, 1.0e-12);
  // No steps where branches meet.
  for (const double x : {0.5 * pi - 0.05, pi - 0.1}) {
    EXPECT_NEAR(f64::lambert_sphere(x - 1.0e-9), f64::lambert_sphere(x + 1.0e-9), 1.0e-8);
    EXPECT_NEAR(f64::lunar_retrodirection(x - 1.0e-9), f64::lunar_retrodirection(x + 1.0e-9), 1.0e-7);
  }
}

TEST(MoonLightStability, FadesOverTheSunsDisc) {
  // Against the mean over a disc that darkens as the cosine: chords have the weight 3/4 (1 - y^2).
  constexpr double radius = 0.00465;
  for (double x = -1.4; x <= 1.4; x += 0.05) {
    double mean = 0.0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
      const double y = 2.0 * (i + 0.5) / steps - 1.0;
      mean += 0.75 * (1.0 - y * y) * std::max(0.0, x + y) * radius * 2.0 / steps;
    }
    EXPECT_NEAR(f64::cosine_to_disc(x * radius, radius), mean, 1.0e-6 * radius) << x;
    EXPECT_NEAR(f32::cosine_to_disc(static_cast<float>(x * radius), static_cast<float>(radius)), mean, 1.0e-5 * radius);
  }
  EXPECT_EQ(f64::cosine_to_disc(-0.1, radius), 0.0);
  EXPECT_DOUBLE_EQ(f64::cosine_to_disc(0.3, radius), 0.3);
  EXPECT_NEAR(f64::cosine_to_disc(0.0, 0.0), 0.0, 1.0e-7);
}

f64::MoonLighting lighting_at(double phase_deg) {
  f64::MoonLighting lighting{};
  const double phase = phase_deg * pi / 180.0;
  lighting.to_sun = {std::cos(phase), std::sin(phase), 0.0};
  lighting.to_earth = {1.0, 0.0, 0.0};
  lighting.sunlit = f64::vec4(1.3e5);
  lighting.earthlit = f64::vec4(15.0);
  lighting.sun_law = f64::lunar_law(phase_deg);
  lighting.earth_law = f64::lunar_law(0.7);
  lighting.sun_radius_rad = 0.00465;
  return lighting;
}

TEST(MoonLightStability, LuminanceIsFiniteEverywhereAndAlikeInBothPrecisions) {
  std::mt19937 random(20260812);
  std::normal_distribution<double> normal;
  const auto direction = [&] { return glm::normalize(Vec3(normal(random), normal(random), normal(random))); };
  for (const double phase : phases()) {
    const f64::MoonLighting lighting = lighting_at(phase);
    const f32::MoonLighting rounded = in_single(lighting);
    for (int i = 0; i < 3000; ++i) {
      Vec3 place = direction();
      if (i % 3 == 1) { // the terminator
        place = glm::normalize(place - glm::dot(place, lighting.to_sun) * lighting.to_sun);
      } else if (i % 3 == 2) { // the limb
        place = glm::normalize(Vec3(0.0, place.y, place.z));
      }
      const Vec3 relief = i % 2 == 0 ? place : glm::normalize(place + 0.3 * direction());
      const Vec3 to_observer(1.0, 0.0, 0.0);
      const f64::vec4 light = f64::moon_luminance(0.12, place, relief, to_observer, lighting, f64::vec4(1.0));
      expect_light(light, 2.0e4);
      const f32::vec4 single = f32::moon_luminance(0.12F, f32::vec3(place), f32::vec3(relief), f32::vec3(to_observer),
                                                   rounded, f32::vec4(1.0F));
      // Cosines are rounded by 1.2e-7: against their sum, that is the error of up to 2e4 cd/m2.
      const Vec3 seen = f64::lunar_relief_seen(place, relief, to_observer);
      const double cosines = std::abs(glm::dot(seen, lighting.to_sun)) + std::abs(glm::dot(seen, to_observer));
      ASSERT_NEAR(single.y, light.y, 2.4e-3 / (1.0e-6 + cosines) + 1.0e-5 * light.y) << phase << " " << i;
    }
  }
}

TEST(MoonLightStability, NightSideOfTheSphereStaysDark) {
  const f64::MoonLighting lighting = lighting_at(60.0);
  for (const double depth_deg : {3.5, 5.0, 20.0, 89.0}) {
    const double depth = depth_deg * pi / 180.0;
    const Vec3 across = glm::normalize(glm::cross(lighting.to_sun, Vec3(0.0, 0.0, 1.0)));
    const Vec3 place = std::cos(depth) * across - std::sin(depth) * lighting.to_sun;
    // A slope that looks straight at the Sun.
    EXPECT_EQ(f64::lunar_relief_reflectance(place, lighting.to_sun, place, lighting.to_sun, 0.00465, lighting.sun_law),
              0.0)
        << depth_deg;
  }
}

SkyState some_sky() {
  return sky_state(parse_instant("2026-01-05T12:00:00Z"), {12.87 * deg, 74.88 * deg, 22.0 * metre});
}

TEST(MoonLightStability, DiscsAtExactOppositionAndConjunction) {
  const MoonGlobe globe = moon_globe(test::map_of(test::waved_surface, 32), 1024);
  for (const Tier tier : {Tier::cheap, Tier::standard}) {
    for (const double phase : phases()) {
      SCOPED_TRACE(phase);
      SkyState sky = some_sky();
      sky.tier = tier;
      // Put the Sun into the Moon's sky where the phase angle has it, and the Earth's centre under the observer.
      sky.moon.phase_angle = phase * deg;
      sky.moon.libration = sky.moon.geocentric_libration = {0.0 * deg, 0.0 * deg};
      sky.moon.subsolar = {phase * deg, 0.0 * deg};
      sky.lunar_eclipse.penumbral_magnitude = -1.0;
      sky.lunar_eclipse.axis = glm::normalize(sky.lunar_eclipse.moon_km) * (phase < 90.0 ? 1.0 : -1.0);
      const MoonDisc disc = moon_disc(sky, globe);
      for (const double value : {disc.illuminance.x, disc.illuminance.y, disc.illuminance.z, disc.illuminance.s,
                                 disc.mean_luminance.to(candela_per_m2)}) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0.0 && value < 1.0e4) << value;
      }
      ASSERT_TRUE(disc.v_magnitude > -13.5);
      for (const f64::LunarLaw& law : {disc.lighting.sun_law, disc.lighting.earth_law}) {
        ASSERT_TRUE(law.seeliger >= 0.0 && law.seeliger < 10.0 && law.lambert >= 0.0 && law.lambert < 10.0);
      }
      if (phase == 180.0) { // earthshine alone is left
        EXPECT_EQ(disc.lighting.sun_law.lambert, 0.0);
        EXPECT_GT(disc.illuminance.y, 1.0e-6);
        EXPECT_LT(disc.illuminance.y, 1.0e-4);
      }
    }
  }
}

TEST(MoonLightStability, EclipseSharesOfOneAreNoEclipse) {
  const MoonGlobe globe = moon_globe(test::map_of(test::waved_surface, 16), 256);
  const MoonDisc disc = moon_disc(some_sky(), globe);
  const Vec3 observer = disc.distance / (1737.4 * kilometre) * disc.to_observer;
  const Vec4 whole = sum_moon_light(globe.samples, observer, disc.lighting, [](const Vec3&) { return Vec4(1.0); });
  EXPECT_NEAR(whole.y, disc.illuminance.y, 1.0e-5 * disc.illuminance.y);
  EXPECT_NEAR(whole.w, disc.illuminance.s, 1.0e-5 * disc.illuminance.s);
  const Vec4 dark = sum_moon_light(globe.samples, observer, disc.lighting, [](const Vec3&) { return Vec4(0.0); });
  EXPECT_GT(dark.y, 0.0);
  EXPECT_LT(dark.y, 1.0e-3 * whole.y);
}

TEST(MoonLightStability, RefusesMapsThatAreNone) {
  EXPECT_THROW(static_cast<void>(sample_moon({}, 8)), Error);
  EXPECT_THROW(static_cast<void>(sample_moon({4, std::vector<float>(383), {}}, 8)), Error);
  EXPECT_THROW(static_cast<void>(sample_moon({-4, std::vector<float>(384), {}}, 8)), Error);
  EXPECT_THROW(static_cast<void>(sample_moon(test::map_of(test::even_surface, 2), 0)), Error);
  EXPECT_EQ(sample_moon(test::map_of(test::even_surface, 1), 1).size(), 6U);
}

TEST(MoonLightStability, SamplesCoverTheSphere) {
  for (const int places : {1, 50, 16384}) {
    double solid_angle = 0.0;
    for (const MoonSample& sample : sample_moon(test::map_of(test::even_surface, 8), places)) {
      solid_angle += static_cast<double>(sample.solid_angle);
      ASSERT_NEAR(glm::length(sample.normal), 1.0F, 1.0e-6F);
    }
    EXPECT_NEAR(solid_angle / (4.0 * pi), 1.0, 1.0 / places) << places;
  }
}

} // namespace
} // namespace vesper
