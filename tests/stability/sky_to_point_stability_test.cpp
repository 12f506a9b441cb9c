// Light and transmittance on the way to a point where they might fail: no way at all, the horizon, the ends of the air.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_to_point.hpp"
#include "vesper/atmosphere/small_sky_tables.hpp"
#include "vesper/base/error.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesper {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

class SkyToPoint : public testing::Test {
protected:
  SkyWay way(double height_km, double altitude_deg, double distance_km, double sun_deg = 10.0,
             double azimuth_deg = 60.0) const {
    return sky_way(tables, query(height_km, altitude_deg, sun_deg, azimuth_deg), distance_km * kilometre);
  }
  static SkyQuery query(double height_km, double altitude_deg, double sun_deg, double azimuth_deg) {
    return {height_km * kilometre, test::direction(0.0 * deg, sun_deg * deg), mean_light_radius,
            test::direction(azimuth_deg * deg, altitude_deg * deg)};
  }
  SkyTables tables = make_sky_tables(published_medium(), {8, 8, 12, 24});
};

TEST_F(SkyToPoint, NoWayHasNoLightAndTakesNone) {
  for (const double height : {0.0, 3.0, 99.9, 100.0, 400.0}) {
    for (const double altitude : {90.0, 0.0, -1.0e-7, -30.0, -90.0}) {
      const SkyWay none = way(height, altitude, 0.0);
      EXPECT_EQ(none.light.y, 0.0);
      EXPECT_EQ(none.transmittance.y, 1.0);
    }
  }
}

TEST_F(SkyToPoint, ShortWaysAreInProportionAndAllAreOneCurve) {
  for (const double height : {0.0, 3.0, 11.0}) {
    for (const double altitude : {80.0, 3.0, 0.0, -20.0}) {
      const double near = way(height, altitude, 1.0e-6).light.y;
      EXPECT_NEAR(way(height, altitude, 1.0e-3).light.y, 1.0e3 * near, 1.0e-4 * 1.0e3 * near);
      double before = 0.0;
      double passed = 1.0;
      for (double km = 1.0e-3; km < 3000.0; km *= 1.02) {
        const SkyWay now = way(height, altitude, km);
        EXPECT_TRUE(std::isfinite(now.light.y) && now.light.y >= 0.0) << km;
        EXPECT_LE(std::abs(now.light.y - before), 0.03 * way(height, altitude, endless).light.y)
            << height << " " << altitude << " " << km;
        // Steps that lengthen with the way may give back a little of what they took.
        EXPECT_LE(now.transmittance.y, passed + 1.0e-3);
        before = now.light.y;
        passed = std::min(passed, now.transmittance.y);
      }
    }
  }
}

TEST_F(SkyToPoint, TheWholeWayHasAllTheLightOfTheAir) {
  tables.albedo = f32::vec4(0.0F); // without the ground's own
  for (const double height : {0.0, 3.0, 99.0, 400.0}) {
    for (const double altitude : {90.0, 20.0, 0.0, -20.0, -60.0}) {
      const double all = sky_luminance(tables, query(height, altitude, 10.0, 60.0)).y;
      EXPECT_NEAR(way(height, altitude, endless).light.y, all, 1.0e-4 * all) << height << " " << altitude;
    }
  }
}

TEST_F(SkyToPoint, NothingLiesBetweenPointsOutsideTheAir) {
  const SkyWay toward_ground = way(400.0, -40.0, 100.0);
  EXPECT_EQ(toward_ground.light.y, 0.0);
  EXPECT_EQ(toward_ground.transmittance.y, 1.0);
  EXPECT_LT(way(400.0, -40.0, 800.0).transmittance.y, 1.0);
}

TEST_F(SkyToPoint, SmallTablesHaveNoWay) {
  const SkyTables small = make_small_sky_tables(published_medium());
  EXPECT_THROW(static_cast<void>(sky_way(small, query(0.0, 20.0, 10.0, 60.0), 10.0 * kilometre)), Error);
}

TEST_F(SkyToPoint, TheHorizonIsNoStepForNearPoints) {
  for (const double height : {0.5, 3.0, 11.0}) {
    const auto radius = static_cast<double>(tables.frame.ground_km);
    const double horizon_deg = -std::acos(radius / (radius + height)) * 180.0 / 3.14159265358979;
    for (const double km : {1.0, 10.0, 40.0}) {
      const SkyWay over = way(height, horizon_deg + 1.0e-3, km);
      const SkyWay under = way(height, horizon_deg - 1.0e-3, km);
      EXPECT_NEAR(over.transmittance.y, under.transmittance.y, 1.0e-3);
      EXPECT_NEAR(over.light.y, under.light.y, 0.15 * over.light.y) << height << " " << km;
    }
  }
}

TEST_F(SkyToPoint, WhatIsNoDistanceIsAnError) {
  EXPECT_THROW(static_cast<void>(way(0.0, 0.0, -1.0)), Error);
  EXPECT_THROW(static_cast<void>(way(0.0, 0.0, std::numeric_limits<double>::quiet_NaN())), Error);
  EXPECT_THROW(static_cast<void>(way(-1.0, 0.0, 1.0)), Error);
}

} // namespace
} // namespace vesper
