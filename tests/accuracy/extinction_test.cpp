// The optical path and the extinction of starlight against published figures.
#include "vesper/astro/refraction.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/star_extinction.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/shader_math.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace vesper {
namespace {

/// Relative optical air mass against true altitude: Young 1994 (Appl. Opt. 33, 1108, eq. 5).
double young_air_mass(double true_altitude_deg) {
  const double c = std::sin(true_altitude_deg * std::numbers::pi / 180.0);
  return (1.002432 * c * c + 0.148386 * c + 0.0096467) / (c * c * c + 0.149864 * c * c + 0.0102963 * c + 0.000303978);
}

TEST(OpticalPath, FollowsThePublishedAirMass) {
  double worst_high = 0.0;
  double worst_low = 0.0;
  for (double altitude = 0.0; altitude <= 90.0; altitude += 0.25) {
    const double ours = f64::optical_path(std::sin(altitude * std::numbers::pi / 180.0), 0.0);
    const double error = std::abs(ours / young_air_mass(altitude) - 1.0);
    (altitude >= 10.0 ? worst_high : worst_low) = std::max(altitude >= 10.0 ? worst_high : worst_low, error);
  }
  std::printf("optical path against Young 1994: worst %.2f %% above 10 degrees, %.1f %% below\n", 100.0 * worst_high,
              100.0 * worst_low);
  EXPECT_LT(worst_high, 0.02);
  // A homogeneous shell and straight rays: 40 air masses at the true horizon against 32 with refraction.
  EXPECT_LT(worst_low, 0.30);
}

TEST(OpticalPath, AtTheApparentAltitudeFollowsItToTheHorizon) {
  // With the altitude that refraction makes of the true one.
  const RefractionTable air = make_refraction_table(standard_conditions(0.0 * metre));
  double worst = 0.0;
  for (double altitude = 0.0; altitude <= 10.0; altitude += 0.25) {
    const double ours = f64::optical_path(std::sin(apparent_altitude(altitude * deg, air).to(rad)), 0.0);
    worst = std::max(worst, std::abs(ours / young_air_mass(altitude) - 1.0));
  }
  std::printf("optical path at apparent altitudes against Young 1994: worst %.1f %% below 10 degrees\n", 100.0 * worst);
  EXPECT_LT(worst, 0.09);
}

TEST(OpticalPath, HoldsWhereThePrintedFormulaFails) {
  // 0/0 at the zenith, and a shell of no thickness above 8 km.
  EXPECT_NEAR(f64::optical_path(1.0, 0.0), 1.0, 1.0e-12);
  EXPECT_NEAR(f64::optical_path(1.0, 8.0), std::exp(-1.0), 1.0e-12);
  EXPECT_NEAR(static_cast<double>(f32::optical_path(1.0F, 0.0F)), 1.0, 1.0e-6);
  for (const double height : {-0.4, 0.0, 2.4, 9.0, 12.0, 100.0}) {
    double last = 0.0;
    for (int i = 90 * 20; i >= 0; --i) {
      const double path = f64::optical_path(std::sin(i / 20.0 * std::numbers::pi / 180.0), height);
      EXPECT_TRUE(std::isfinite(path));
      EXPECT_GE(path, last);
      last = path;
    }
  }
}

TEST(OpticalPath, IsContinuousThroughTheHorizontal) {
  for (const double height : {0.0, 0.05, 2.4, 12.0}) {
    const double above = f64::optical_path(1.0e-9, height);
    const double below = f64::optical_path(-1.0e-9, height);
    EXPECT_NEAR(below / above, 1.0, 1.0e-5) << height;
  }
  // From an aircraft the dipped horizon shows more air than the horizontal.
  EXPECT_GT(f64::optical_path(std::sin(-0.05), 12.0), 2.0 * f64::optical_path(0.0, 12.0));
}

TEST(StarExtinction, AtTheZenithInV) {
  // V's effective wavelength for a solar spectrum is 550 nm: 0.20 to 0.30 magnitudes at a clear sea-level site, 0.13 to
  // 0.18 at an observatory.
  const auto magnitudes = [](double height_m) {
    const double depth = star_optical_depth_xyzs(clear_medium(), height_m * metre).y;
    return 2.5 / std::numbers::ln10 * depth * f64::optical_path(1.0, 1.0e-3 * height_m);
  };
  const double sea_level = magnitudes(0.0);
  const double mountain = magnitudes(2400.0);
  std::printf("zenith extinction of stars: %.3f mag at sea level, %.3f mag at 2400 m\n", sea_level, mountain);
  EXPECT_GT(sea_level, 0.20);
  EXPECT_LT(sea_level, 0.30);
  EXPECT_GT(mountain, 0.13);
  EXPECT_LT(mountain, 0.18);
}

/// Rayleigh optical depth at sea level: the fit of Bodhaine et al. 1999 (J. Atmos. Ocean. Technol. 16, 1854, eq. 30).
double bodhaine_optical_depth(double micrometres) {
  const double square = micrometres * micrometres;
  return 0.0021520 * (1.0455996 - 341.29061 / square - 0.90230850 * square) /
         (1.0 + 0.0027059889 / square - 85.968563 * square);
}

TEST(StarExtinction, OfPureAirAgreesWithBodhaine) {
  test::ErrorSum error;
  const Vec4 depth = star_optical_depth_xyzs(clear_medium({0.0, 0.0, 1.3, 0.0, 0.0}), 0.0 * metre);
  for (int channel = 0; channel < 4; ++channel) {
    error.add(100.0 * (depth[channel] / bodhaine_optical_depth(1.0e-3 * star_wavelengths_nm[channel]) - 1.0));
  }
  error.hold("optical depth of stars through pure air against Bodhaine et al. 1999", 0.2, "%");
}

TEST(StarExtinction, OfTheShellAgreesWithRaysThroughTheMedium) {
  test::ErrorSum high;
  test::ErrorSum low;
  for (const Medium& medium : {clear_medium(), published_medium()}) {
    for (const double height_km : {0.0, 2.4}) {
      const Vec4 shell = star_optical_depth_xyzs(medium, height_km * kilometre);
      const Vec3 eye(0.0, 0.0, medium.ground_radius.to(kilometre) + height_km);
      for (double altitude = 10.0; altitude <= 90.0; altitude += 1.0) {
        const double radians = altitude * std::numbers::pi / 180.0;
        const Vec3 direction = glm::normalize(Vec3(std::cos(radians), 0.0, std::sin(radians)));
        const AirColumns columns = columns_to_space(medium, eye, direction);
        for (int channel = 0; channel < 4; ++channel) {
          const double exact = optical_depth(medium, columns, star_wavelengths_nm[channel]).value;
          const double ours = shell[channel] * f64::optical_path(direction.z, height_km);
          (altitude >= 20.0 ? high : low).add(2.5 / std::numbers::ln10 * (ours - exact));
        }
      }
    }
  }
  high.hold("extinction of stars above 20 degrees against rays through the medium", 0.005, "mag");
  low.hold("extinction of stars from 10 to 20 degrees against rays through the medium", 0.03, "mag");
}

TEST(StarExtinction, BlueIsDimmedMost) {
  const Vec4 depth = star_optical_depth_xyzs(clear_medium(), 0.0 * metre);
  EXPECT_GT(depth.z, depth.w);
  EXPECT_GT(depth.w, depth.y);
  EXPECT_GT(depth.y, depth.x);
}

} // namespace
} // namespace vesper
