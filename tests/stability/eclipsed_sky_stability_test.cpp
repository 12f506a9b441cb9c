// The sky in the Moon's shadow where it could fail: exact conjunctions, annular and grazing eclipses, the Sun below the
// horizon, observers from the ground to space, air with nothing in it.
#include "vesper/atmosphere/eclipsed_sky.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/sky/moon_shadow.hpp"

#include "support/media.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace vesper {
namespace {

using AirPointer = std::shared_ptr<const EclipsedAir>;

AirPointer air_of(const Medium& medium) { return std::make_shared<const EclipsedAir>(medium); }

const AirPointer& clear_air() {
  static const AirPointer air = air_of(clear_medium());
  return air;
}

MoonShadowInAir shadow_at(const AirPointer& air, double sun_altitude_deg, double moon_distance_km, double miss_km) {
  const Vec3 to_sun = test::direction(0.0 * deg, sun_altitude_deg * deg);
  return moon_shadow(1.5e8 * to_sun, moon_distance_km * to_sun + Vec3(0.0, miss_km, 0.0), air->wavelengths_nm())
      .value();
}

/// Calls f(view) over the whole sphere, zenith and nadir too.
template <class Function> void over_views(const Function& f) {
  for (const double altitude : {90.0, 89.99, 45.0, 10.0, 1.0, 0.0, -0.5, -3.0, -10.0, -20.0, -60.0, -90.0}) {
    for (const double azimuth : {0.0, 3.0, 90.0, 180.0, 270.0}) {
      f(test::direction(azimuth * deg, altitude * deg));
    }
  }
}

/// No more light than molecules add that scatter along the horizon what comes along it.
void expect_possible(const f32::vec4& ratio, float most = 1.13F) {
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(std::isfinite(ratio[i]) && ratio[i] >= 0.0F && ratio[i] <= most) << ratio[i];
  }
}

TEST(EclipsedSkyStability, IsPossibleAnywhere) {
  for (const double sun : {90.0, 30.0, -2.0, -17.0}) {
    for (const double moon_km : {357000.0, 406000.0}) {
      for (const double miss_km : {0.0, 3500.0}) {
        const MoonShadowInAir shadow = shadow_at(clear_air(), sun, moon_km, miss_km);
        for (const double height_km : {0.0, 11.0, 99.99, 400.0}) {
          const EclipsedSky sky(clear_air(), shadow, height_km * kilometre);
          over_views([&](const Vec3& view) {
            const EclipsedSky::Ratios ratios = sky.ratios(view);
            expect_possible(ratios.all);
            expect_possible(ratios.without_peak);
            expect_possible(ratios.aerosol, 1.0001F);
          });
          expect_possible(sky.level_ratio());
        }
      }
    }
  }
}

TEST(EclipsedSkyStability, NothingIsDimmedOutsideTheShadow) {
  // The Moon's edge at the Sun's as air 1200 km away sees it: no place of the sky is inside.
  const MoonShadowInAir shadow = shadow_at(clear_air(), 40.0, 380000.0, 4700.0);
  const EclipsedSky sky(clear_air(), shadow, 0.0 * metre);
  over_views([&](const Vec3& view) {
    const f32::vec4 ratio = sky.ratios(view).all;
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(ratio[i], 1.0F, 1.0e-4F) << view.z;
    }
  });
  EXPECT_NEAR(sky.level_ratio().y, 1.0F, 1.0e-4F);
  const Vec3 to_sun = test::direction(0.0 * deg, 40.0 * deg);
  EXPECT_FALSE(moon_shadow(1.5e8 * to_sun, 380000.0 * to_sun + Vec3(0.0, 5000.0, 0.0), {}));
  EXPECT_FALSE(moon_shadow(1.5e8 * to_sun, -380000.0 * to_sun, {}));
}

TEST(EclipsedSkyStability, TheSkyDarkensWithTheMoonsApproach) {
  double before = 1.0;
  for (double miss_km = 4400.0; miss_km >= 0.0; miss_km -= 220.0) {
    const EclipsedSky sky(clear_air(), shadow_at(clear_air(), 40.0, 360000.0, miss_km), 0.0 * metre);
    const auto now = static_cast<double>(sky.ratios({0.0, 0.0, 1.0}).all.y);
    EXPECT_LE(now, before + 1.0e-5) << miss_km;
    EXPECT_GT(now, 0.0);
    before = now;
  }
  EXPECT_LT(before, 1.0e-3);
}

TEST(EclipsedSkyStability, AnyAir) {
  for (const Medium& medium :
       {published_medium(), test::scaled(clear_medium(), 1.0e-6), test::scaled(clear_medium(), 20.0)}) {
    const AirPointer air = air_of(medium);
    const EclipsedSky sky(air, shadow_at(air, 20.0, 360000.0, 0.0), 0.0 * metre);
    over_views([&](const Vec3& view) { expect_possible(sky.ratios(view).all); });
  }
}

TEST(EclipsedSkyStability, SinglePrecisionTellsPlacesOfTheAirApart) {
  const Vec3 to_sun = test::direction(0.0 * deg, 30.0 * deg);
  const Vec3 moon_km = 360000.0 * to_sun + Vec3(0.0, 83.0, 0.0);
  const f32::MoonShadow shadow = moon_shadow(1.5e8 * to_sun, moon_km, {}).value().shadow;
  double worst = 0.0;
  for (double x = -1000.0; x <= 1000.0; x += 37.0) {
    for (double z = -60.0; z <= 60.0; z += 12.0) {
      const Vec3 place(x, 0.3 * x, z);
      const f32::vec3 discs = f32::moon_shadow_discs(f32::vec3(place), shadow);
      // The angle between Sun and Moon as the place sees them, in double precision.
      const Vec3 sun = glm::normalize(1.5e8 * to_sun - place);
      const Vec3 moon = glm::normalize(moon_km - place);
      const double apart = std::asin(glm::length(glm::cross(sun, moon)));
      worst = std::max(worst, std::abs(static_cast<double>(discs.z) - apart));
    }
  }
  // In km of the shadow on the ground.
  EXPECT_LT(worst * 360000.0, 0.05);
}

} // namespace
} // namespace vesper
