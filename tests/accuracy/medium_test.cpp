// The media and their columns against published figures and a quadrature of another kind.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace vesper {
namespace {

/// Scattering cross-section of a molecule of air, 1e-28 cm2: the fit of Bodhaine et al. 1999 (J. Atmos. Ocean. Technol.
/// 16, 1854, eq. 29), good to 0.01 % from 250 to 850 nm for air with 360 ppm of carbon dioxide.
double bodhaine_cross_section(double wavelength_nm) {
  const double square = wavelength_nm * wavelength_nm * 1.0e-6;
  return (1.0455996 - 341.29061 / square - 0.90230850 * square) / (1.0 + 0.0027059889 / square - 85.968563 * square);
}

TEST(ClearMedium, MoleculesScatterAsPublished) {
  test::ErrorSum coefficient;
  test::ErrorSum column;
  const Medium air = clear_medium();
  const Vec3 zenith(0.0, 0.0, 1.0);
  const AirColumns columns = columns_to_space(air, air.ground_radius.to(kilometre) * zenith, zenith);
  for (int nm = 360; nm <= 830; nm += 10) {
    // cm2 times molecules per cm3 at 15 C and 1013.25 hPa, by km.
    const double per_km = bodhaine_cross_section(nm) * 1.0e-28 * 2.546899e19 * 1.0e5;
    coefficient.add(100.0 * (rayleigh_per_km(nm) / per_km - 1.0));
    // Their eq. 30: the optical depth of sea level at 45 degrees.
    const double depth = air.components[0].scattering_per_km(nm) * columns.km[0];
    column.add(100.0 * (depth / (0.0021520 * bodhaine_cross_section(nm)) - 1.0));
  }
  coefficient.hold("Rayleigh scattering against Bodhaine et al. 1999", 0.1, "%");
  column.hold("Rayleigh optical depth against Bodhaine et al. 1999", 0.2, "%");
}

TEST(ClearMedium, DepolarizationAsPublished) {
  // Young 1980 (Appl. Opt. 19, 3427): 0.0279 and a King factor of 1.048 for the visible.
  test::ErrorSum depolarization;
  test::ErrorSum king;
  for (const double nm : {500.0, 550.0, 600.0, 650.0}) {
    depolarization.add(air_depolarization(nm) - 0.0279);
    king.add(king_factor(nm) - 1.048);
    const double rho = air_depolarization(nm);
    EXPECT_NEAR((6.0 + 3.0 * rho) / (6.0 - 7.0 * rho), king_factor(nm), 1.0e-12);
  }
  depolarization.hold("depolarization of air against Young 1980", 1.0e-3, "");
  king.hold("King factor of air against Young 1980", 2.0e-3, "");
}

TEST(ClearMedium, HoldsTheColumnsItWasAskedFor) {
  const Vec3 zenith(0.0, 0.0, 1.0);
  for (const double dobson : {100.0, 300.0}) {
    for (const double aerosol : {0.02, 0.10, 1.0}) {
      const Medium air = clear_medium({aerosol, 0.005, 1.3, dobson, 0.15});
      const AirColumns columns = columns_to_space(air, air.ground_radius.to(kilometre) * zenith, zenith);
      const double low = air.components[1].extinction_per_km(550.0) * columns.km[1];
      const double high = air.components[2].extinction_per_km(550.0) * columns.km[2];
      EXPECT_NEAR(low + high, aerosol, 1.0e-8 * aerosol);
      EXPECT_NEAR(high, 0.005, 1.0e-10);
      // 300 Dobson units of 2.6867e20 molecules per m2 absorb 4.1 % at 600 nm.
      const double ozone = dobson * 2.6867e20 * 5.085e-25;
      EXPECT_NEAR(air.components[3].extinction_per_km(600.0) * columns.km[3], ozone, 1.0e-3 * ozone);
    }
  }
}

TEST(ClearMedium, ZenithExtinctionInV) {
  const Medium air = clear_medium();
  const Spectrum& sun = solar_irradiance_1au();
  const double sea_level = zenith_extinction_v_mag(air, 0.0 * metre, sun);
  const double mountain = zenith_extinction_v_mag(air, 2400.0 * metre, sun);
  std::printf(
      "zenith extinction in V: %.4f mag at sea level, %.4f mag at 2400 m; published medium %.4f mag\n", sea_level,
      mountain,
      2.5 / std::numbers::ln10 *
          optical_depth(published_medium(), columns_to_space(published_medium(), {0, 0, 6360}, {0, 0, 1}), 550.0)
              .value);
  EXPECT_GT(sea_level, 0.20);
  EXPECT_LT(sea_level, 0.30);
  EXPECT_GT(mountain, 0.13);
  EXPECT_LT(mountain, 0.18);
}

/// Midpoints in equal steps along the ray between its points of entry and exit.
double fine_depth(const Medium& medium, Vec3 from, Vec3 direction, double nm) {
  const double top = medium.top_radius.to(kilometre);
  const double along = glm::dot(from, direction);
  const double discriminant = along * along - glm::dot(from, from) + top * top;
  if (discriminant <= 0.0) {
    return 0.0;
  }
  const double begin = std::max(0.0, -along - std::sqrt(discriminant));
  const double end = -along + std::sqrt(discriminant);
  constexpr int steps = 200000;
  const double step = (end - begin) / steps;
  std::vector<double> sums(medium.components.size(), 0.0);
  for (int i = 0; i < steps; ++i) {
    const double height =
        glm::length(from + (begin + (i + 0.5) * step) * direction) - medium.ground_radius.to(kilometre);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      sums[k] += medium.components[k].profile.at(height);
    }
  }
  double depth = 0.0;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    depth += sums[k] * step * medium.components[k].extinction_per_km(nm);
  }
  return depth;
}

struct RayToSpace {
  double height_km;
  double altitude_deg;
};

void compare(const Medium& medium, const char* name) {
  test::ErrorSum transmittance;
  test::ErrorSum depth;
  test::ErrorSum bound;
  const double ground = medium.ground_radius.to(kilometre);
  const double top = medium.top_radius.to(kilometre) - ground;
  const auto add = [&](const Vec3& from, const Vec3& direction) {
    const OpticalDepth ours = optical_depth(medium, columns_to_space(medium, from, direction), 550.0);
    const double fine = fine_depth(medium, from, direction, 550.0);
    transmittance.add(ours.transmittance() - std::exp(-fine));
    depth.add(ours.value / fine - 1.0);
    bound.add(ours.error / ours.value);
  };
  for (const double height : {0.0, 0.002, 2.4, 11.0, 25.0, top}) {
    // Down to the limb, which grazes the ground.
    const double limb = -std::acos(ground / (ground + height)) + 1.0e-9;
    for (const double altitude : {limb, 0.5 * limb, 0.0, 0.001, 0.02, 0.2, 0.8, 0.5 * std::numbers::pi}) {
      if (height < top || altitude < -1.0e-3) {
        add({0.0, 0.0, ground + height}, {std::cos(altitude), 0.0, std::sin(altitude)});
      }
    }
  }
  // From outside along rays that pass at these heights.
  for (const double pass : {0.0001, 1.0, 10.0, 24.999, 40.0, 0.99 * top}) {
    add({-40000.0, 0.0, ground + pass}, {1.0, 0.0, 0.0});
  }
  transmittance.hold(std::string("transmittance of ") + name + " against midpoints", 1.0e-5, "");
  depth.hold(std::string("optical depth of ") + name + " against midpoints, relative", 1.0e-5, "");
  bound.hold(std::string("own bound of the optical depth of ") + name + ", relative", 1.0e-8, "");
}

TEST(Transmittance, AgreesWithAFineQuadrature) {
  compare(published_medium(), "published");
  compare(clear_medium(), "clear");
}

TEST(Transmittance, OfTheWholePathIsThatOfItsParts) {
  const Medium air = clear_medium();
  const double ground = air.ground_radius.to(kilometre);
  const Vec3 eye(0.0, 0.0, ground);
  test::ErrorSum error;
  for (const double altitude : {0.0, 0.01, 0.3, 1.5}) {
    const Vec3 direction(std::cos(altitude), 0.0, std::sin(altitude));
    for (const double middle_km : {0.001, 3.0, 100.0, 900.0, 400000.0}) {
      const Vec3 middle = eye + middle_km * direction;
      const double near = optical_depth(air, columns_between(air, eye, middle), 440.0).value;
      const double back = optical_depth(air, columns_between(air, middle, eye), 440.0).value;
      const double far = optical_depth(air, columns_to_space(air, middle, direction), 440.0).value;
      const double whole = optical_depth(air, columns_to_space(air, eye, direction), 440.0).value;
      error.add((near + far) / whole - 1.0);
      error.add(back / near - 1.0);
    }
  }
  error.hold("optical depth by parts and backwards, relative", 1.0e-8, "");
}

} // namespace
} // namespace vesper
