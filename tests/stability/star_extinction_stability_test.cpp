// The table of the stars' extinction under extreme media, observers and input.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/refracted_columns.hpp"
#include "vesper/atmosphere/star_extinction_table.hpp"
#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace vesper {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_share(const Vec4& share) {
  for (int channel = 0; channel < 4; ++channel) {
    if (!(share[channel] >= 0.0 && share[channel] <= 1.0)) {
      return false;
    }
  }
  return true;
}

std::optional<RefractionConditions> random_bending(std::mt19937_64& random, Length height) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  if (height > 100.0 * kilometre || unit(random) < 0.2) {
    return std::nullopt;
  }
  RefractionConditions conditions = standard_conditions(height);
  if (unit(random) < 0.5) {
    // Also what no air is: a sea level's pressure at any height, cold enough for rays that circle the planet.
    conditions.pressure_hpa = 1100.0 * unit(random);
    conditions.temperature_c = -90.0 + 150.0 * unit(random);
  }
  return conditions;
}

TEST(StarExtinction, IsAShareForAnyMediumObserverAndLight) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int scene = 0; scene < 60; ++scene) {
    ClearAir air;
    air.aerosol_optical_depth = 10.0 * std::pow(unit(random), 4);
    air.stratospheric_optical_depth = std::pow(unit(random), 3);
    air.angstrom_exponent = -1.0 + 5.0 * unit(random);
    air.ozone_dobson = 1000.0 * unit(random);
    const Medium medium = scene % 10 == 0 ? published_medium() : clear_medium(air);
    const Length height = (std::pow(10.0, -3.0 + 7.0 * unit(random)) - 0.4) * kilometre;
    const StarExtinction table = make_star_extinction(medium, height, random_bending(random, height));
    for (const Vec4& texel : table.texels) {
      ASSERT_LE(texel.x, 1.0e-12);
      ASSERT_TRUE(std::isfinite(texel.x) && std::isfinite(texel.y) && std::isfinite(texel.z) && std::isfinite(texel.w));
    }
    for (int i = 0; i < 2000; ++i) {
      const double sine = std::pow(2.0 * unit(random) - 1.0, 3);
      const Vec4 light(unit(random), unit(random), std::pow(unit(random), 9), unit(random));
      ASSERT_TRUE(is_share(star_extinction(table, sine, light))) << scene << " " << sine;
    }
    for (const Vec4& light : {Vec4(0.0), Vec4(0.0, 1.0, 0.0, 0.0), Vec4(0.0, 0.0, 1.0, 0.0), Vec4(1.0e30)}) {
      for (const double sine : {-1.0, table.frame.sin_horizon, 0.0, 1.0}) {
        ASSERT_TRUE(is_share(star_extinction(table, sine, light))) << scene << " " << sine;
      }
    }
  }
}

TEST(StarExtinction, LetsMoreLightThroughTheHigherItComesFrom) {
  const Vec4 white(0.95, 1.0, 1.09, 2.2);
  for (const double height_km : {-0.4, 0.0, 1.0e-3, 2.4, 9.0}) {
    const StarExtinction table =
        make_star_extinction(clear_medium(), height_km * kilometre, standard_conditions(height_km * kilometre));
    const double horizon = table.frame.sin_horizon;
    Vec4 last(0.0);
    for (int i = 0; i <= 2000; ++i) {
      const double t = i / 2000.0;
      const Vec4 share = star_extinction(table, horizon + (1.0 - horizon) * t * t * t, white);
      for (int channel = 0; channel < 4; ++channel) {
        ASSERT_GE(share[channel], last[channel] * (1.0 - 1.0e-12)) << height_km << " " << t;
      }
      last = share;
    }
    // A sky without a ground goes on below the horizon without a step.
    const Vec4 below = star_extinction(table, horizon - 1.0e-9, white) / star_extinction(table, horizon, white);
    EXPECT_NEAR(below.z, 1.0, 1.0e-4) << height_km;
    EXPECT_GT(star_extinction(table, -1.0, white).y, 0.7);
  }
}

TEST(StarExtinction, VanishesSteadilyTowardsSpace) {
  // From the top of the air and beyond nothing but the limb dims a star, and no height makes a jump.
  const Vec4 white(0.95, 1.0, 1.09, 2.2);
  const Medium medium = clear_medium();
  const auto shares = [&](double height_km, double sine) {
    return star_extinction(make_star_extinction(medium, height_km * kilometre, std::nullopt), sine, white).y;
  };
  double last = 0.0;
  for (double height_km = 0.0; height_km < 200.0; height_km += 1.37) {
    const double share = shares(height_km, 0.05);
    EXPECT_GE(share, last) << height_km;
    last = share;
  }
  EXPECT_EQ(last, 1.0);
  EXPECT_NEAR(shares(119.999, 0.0), shares(120.001, 0.0), 1.0e-6);
  EXPECT_EQ(shares(36000.0, 0.0), 1.0);
  EXPECT_LT(shares(400.0, make_star_extinction(medium, 400.0 * kilometre, std::nullopt).frame.sin_horizon), 1.0e-6);
}

TEST(StarExtinction, RefusesWhatIsNoScene) {
  EXPECT_THROW(static_cast<void>(make_star_extinction(clear_medium(), infinity * metre, std::nullopt)), Error);
  EXPECT_THROW(static_cast<void>(make_star_extinction(clear_medium(), -7000.0 * kilometre, std::nullopt)), Error);
  Medium shell = clear_medium();
  shell.top_radius = shell.ground_radius;
  EXPECT_THROW(static_cast<void>(make_star_extinction(shell, 0.0 * metre, std::nullopt)), Error);
  RefractionConditions hot = standard_conditions(0.0 * metre);
  hot.temperature_c = 1000.0;
  EXPECT_THROW(static_cast<void>(make_star_extinction(clear_medium(), 0.0 * metre, hot)), Error);
}

} // namespace
} // namespace vesper
