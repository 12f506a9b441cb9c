// The table of the stars' extinction: its rays against published air masses and other quadratures, its shares of light
// against integrals over the spectrum.
#include "vesper/astro/refraction.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/refracted_columns.hpp"
#include "vesper/atmosphere/star_extinction_table.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vesper {
namespace {

/// Nothing but molecules.
Medium pure_air() {
  ClearAir air;
  air.aerosol_optical_depth = 0.0;
  air.stratospheric_optical_depth = 0.0;
  air.ozone_dobson = 0.0;
  return clear_medium(air);
}

double sine_of_degrees(double degrees) { return std::sin((degrees * deg).to(rad)); }

/// Relative optical air mass against the apparent altitude: Kasten and Young 1989 (Appl. Opt. 28, 4735, eq. 3).
double kasten_young_air_mass(double altitude_deg) {
  return 1.0 / (sine_of_degrees(altitude_deg) + 0.50572 * std::pow(altitude_deg + 6.07995, -1.6364));
}

/// The same against the true altitude: Young 1994 (Appl. Opt. 33, 1108, eq. 5).
double young_air_mass(double true_altitude_deg) {
  const double c = sine_of_degrees(true_altitude_deg);
  return (1.002432 * c * c + 0.148386 * c + 0.0096467) / (c * c * c + 0.149864 * c * c + 0.0102963 * c + 0.000303978);
}

TEST(RefractedColumns, OfMoleculesHaveThePublishedAirMass) {
  const RefractionConditions conditions = standard_conditions(0.0 * metre);
  const RefractedColumns air(pure_air(), 0.0 * metre, conditions);
  const RefractedColumns straight(pure_air(), 0.0 * metre, std::nullopt);
  const RefractionTable refraction = make_refraction_table(conditions);
  const double zenith = air.columns_km(1.0).front();
  test::ErrorSum apparent;
  test::ErrorSum from_true;
  test::ErrorSum unbent;
  for (double altitude = 0.0; altitude <= 90.0; altitude += 0.125) {
    const double sine = sine_of_degrees(altitude);
    const double published = kasten_young_air_mass(altitude);
    apparent.add(100.0 * (air.columns_km(sine).front() / zenith / published - 1.0));
    unbent.add(100.0 * (straight.columns_km(sine).front() / zenith / published - 1.0));
    const double seen = apparent_altitude(altitude * deg, refraction).to(deg);
    from_true.add(100.0 * (air.columns_km(sine_of_degrees(seen)).front() / zenith / young_air_mass(altitude) - 1.0));
  }
  std::printf("air mass at the apparent horizon: %.2f, without bending %.2f\n", air.columns_km(0.0).front() / zenith,
              straight.columns_km(0.0).front() / zenith);
  apparent.hold("air mass at apparent altitudes against Kasten and Young 1989", 1.0, "%");
  from_true.hold("air mass at true altitudes against Young 1994", 1.0, "%");
  // What bending is worth.
  EXPECT_GT(unbent.worst(), 5.0);
}

TEST(RefractedColumns, WithoutBendingAgreeWithAdaptiveQuadrature) {
  test::ErrorSum error;
  for (const Medium& medium : {clear_medium(), published_medium()}) {
    for (const double height_km : {0.0, 0.002, 2.4, 12.0, 45.0, 400.0}) {
      const RefractedColumns air(medium, height_km * kilometre, std::nullopt);
      const Vec3 eye(0.0, 0.0, medium.ground_radius.to(kilometre) + height_km);
      for (int i = 1; i <= 60; ++i) {
        const double sine = air.sin_horizon() + (1.0 - air.sin_horizon()) * std::pow(i / 60.0, 4);
        const Vec3 direction = glm::normalize(Vec3(std::sqrt(std::max(1.0 - sine * sine, 0.0)), 0.0, sine));
        const AirColumns exact = columns_to_space(medium, eye, direction);
        ASSERT_FALSE(exact.blocked);
        const std::vector<double> ours = air.columns_km(sine);
        double deeper = 0.0;
        for (std::size_t k = 0; k < ours.size(); ++k) {
          deeper += medium.components[k].extinction_per_km(450.0) * (ours[k] - exact.km[k]);
        }
        error.add(100.0 * (std::exp(-deeper) - 1.0));
      }
    }
  }
  error.hold("light of 450 nm along straight rays against adaptive quadrature", 0.05, "%");
}

/// Where a ray is, in a plane through the planet's centre, n times its direction, and what it has passed.
using RayState = std::array<double, 5>;

/// The eikonal equation by Runge and Kutta's steps: d(n t)/ds = grad n.
double followed_column_km(const AirProfile& air, const HeightProfile& profile, double ground_km, double height_km,
                          double altitude_deg) {
  const auto derivative = [&](const RayState& at) {
    const double radius = std::hypot(at[0], at[1]);
    const double height = radius - ground_km;
    const AirProfile::Air local = air.at(height);
    const double n = 1.0 + local.refractivity;
    return RayState{at[2] / n, at[3] / n, local.gradient_per_km * at[0] / radius,
                    local.gradient_per_km * at[1] / radius, profile.at(std::max(height, 0.0))};
  };
  const auto moved = [](const RayState& at, const RayState& by, double step) {
    RayState to{};
    for (std::size_t i = 0; i < to.size(); ++i) {
      to.at(i) = at.at(i) + step * by.at(i);
    }
    return to;
  };
  const double n = 1.0 + air.at(height_km).refractivity;
  const double sine = sine_of_degrees(altitude_deg);
  RayState at{0.0, ground_km + height_km, n * std::sqrt(1.0 - sine * sine), n * sine, 0.0};
  constexpr double step_km = 0.1;
  while (std::hypot(at[0], at[1]) < ground_km + top_of_air_km) {
    const RayState k1 = derivative(at);
    const RayState k2 = derivative(moved(at, k1, 0.5 * step_km));
    const RayState k3 = derivative(moved(at, k2, 0.5 * step_km));
    const RayState k4 = derivative(moved(at, k3, step_km));
    for (std::size_t i = 0; i < at.size(); ++i) {
      at.at(i) += step_km / 6.0 * (k1.at(i) + 2.0 * k2.at(i) + 2.0 * k3.at(i) + k4.at(i));
    }
  }
  return at[4];
}

TEST(RefractedColumns, AgreeWithRaysFollowedStepByStep) {
  const Medium medium = clear_medium();
  const double ground_km = medium.ground_radius.to(kilometre);
  test::ErrorSum error;
  for (const double height_km : {0.0, 2.4, 12.0}) {
    const RefractionConditions conditions = standard_conditions(height_km * kilometre);
    const AirProfile profile(conditions);
    const RefractedColumns air(medium, height_km * kilometre, conditions);
    const double horizon_deg = (std::asin(air.sin_horizon()) * rad).to(deg);
    for (const double above_deg : {0.002, 0.1, 0.5, 1.5, 4.0, 12.0, 50.0}) {
      const std::vector<double> ours = air.columns_km(sine_of_degrees(horizon_deg + above_deg));
      for (std::size_t k = 0; k < ours.size(); ++k) {
        const double exact =
            followed_column_km(profile, medium.components[k].profile, ground_km, height_km, horizon_deg + above_deg);
        error.add(100.0 * (ours[k] / exact - 1.0));
      }
    }
  }
  error.hold("columns along bent rays against rays followed step by step", 0.1, "%");
}

/// The shares of X, Y, Z and S that columns leave, by sums over every nanometre.
Vec4 integrated_shares(const Medium& medium, const std::vector<double>& columns_km, const Spectrum& light) {
  std::vector<double> wavelengths;
  std::vector<double> above;
  std::vector<double> below;
  for (int nm = response_first_nm; nm <= response_last_nm; ++nm) {
    const double depth = optical_depth(medium, {columns_km, std::vector<double>(columns_km.size()), false}, nm).value;
    wavelengths.push_back(nm);
    above.push_back(light(nm));
    below.push_back(light(nm) * std::exp(-depth));
  }
  const Xyzs all = integrate_xyzs({wavelengths, above});
  const Xyzs left = integrate_xyzs({wavelengths, below});
  return {left.x / all.x, left.y / all.y, left.z / all.z, left.s / all.s};
}

double worst_percent(const Vec4& ours, const Vec4& exact) {
  double worst = 0.0;
  for (int channel = 0; channel < 4; ++channel) {
    const double error = 100.0 * (ours[channel] / exact[channel] - 1.0);
    worst = std::abs(error) > std::abs(worst) ? error : worst;
  }
  return worst;
}

TEST(StarExtinction, AgreesWithTheIntegralOverTheSpectrum) {
  constexpr std::array<double, 13> colors{-0.4, -0.23, 0.0, 0.31, 0.65, 1.13, 1.52, 1.85, 2.07, 2.5, 3.3, 4.7, 6.0};
  ClearAir haze;
  haze.aerosol_optical_depth = 0.4;
  test::ErrorSum high;
  test::ErrorSum low;
  for (const Medium& medium : {clear_medium(), clear_medium(haze), published_medium()}) {
    for (const double height_km : {0.0, 0.002, 2.4, 12.0, 40.0}) {
      const RefractionConditions conditions = standard_conditions(height_km * kilometre);
      const RefractedColumns air(medium, height_km * kilometre, conditions);
      const StarExtinction table = make_star_extinction(medium, height_km * kilometre, conditions);
      const double horizon_deg = (std::asin(air.sin_horizon()) * rad).to(deg);
      for (double above = 0.0; horizon_deg + above <= 90.0; above += above < 6.0 ? 0.173 : 2.31) {
        const double sine = sine_of_degrees(horizon_deg + above);
        const std::vector<double> columns = air.columns_km(sine);
        for (const double b_v : colors) {
          const Xyzs color = star_color(b_v);
          const Vec4 exact = integrated_shares(medium, columns, planck_spectrum(star_temperature_k(b_v)));
          const Vec4 ours = star_extinction(table, sine, vector_of(color));
          (horizon_deg + above >= 5.0 ? high : low).add(worst_percent(ours, exact));
        }
      }
    }
  }
  high.hold("X, Y, Z, S of stars above 5 degrees against their spectra through the medium", 0.2, "%");
  low.hold("X, Y, Z, S of stars from the horizon to 5 degrees against their spectra through the medium", 2.0, "%");
}

/// Sunlight and the geometric albedos of planets at 360, 436, 549, 641, 700, 798 and 900 nm (Mallama, Krobusek and
/// Pavlov 2017, Icarus 282, 19).
TEST(StarExtinction, OfPlanetsIsNearlyThatOfABlackBodyOfTheirColor) {
  const std::vector<double> bands{360.0, 436.0, 549.0, 641.0, 700.0, 798.0, 900.0};
  const std::vector<std::pair<std::string, std::vector<double>>> albedos{
      {"sunlight", {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}},
      {"Venus", {0.348, 0.658, 0.689, 0.658, 0.708, 0.640, 0.584}},
      {"Mars", {0.060, 0.088, 0.170, 0.250, 0.288, 0.285, 0.330}},
      {"Jupiter", {0.358, 0.443, 0.538, 0.513, 0.495, 0.389, 0.321}},
      {"Saturn", {0.203, 0.339, 0.499, 0.646, 0.568, 0.543, 0.423}},
      {"Uranus", {0.502, 0.561, 0.488, 0.264, 0.202, 0.089, 0.079}},
      {"Neptune", {0.578, 0.562, 0.442, 0.226, 0.181, 0.072, 0.067}}};
  const Medium medium = clear_medium();
  const RefractionConditions conditions = standard_conditions(0.0 * metre);
  const RefractedColumns air(medium, 0.0 * metre, conditions);
  const StarExtinction table = make_star_extinction(medium, 0.0 * metre, conditions);
  test::ErrorSum high;
  test::ErrorSum low;
  test::ErrorSum outer_high;
  test::ErrorSum outer_low;
  for (const auto& [name, albedo] : albedos) {
    const bool outer = name == "Uranus" || name == "Neptune";
    const Spectrum light = filtered(solar_irradiance_1au(), {bands, albedo});
    const Xyzs color = integrate_xyzs(light);
    for (double altitude = 0.0; altitude <= 90.0; altitude += 0.5) {
      const double sine = sine_of_degrees(altitude);
      const Vec4 exact = integrated_shares(medium, air.columns_km(sine), light);
      const Vec4 ours = star_extinction(table, sine, vector_of(color));
      (altitude >= 5.0 ? (outer ? outer_high : high) : (outer ? outer_low : low)).add(worst_percent(ours, exact));
    }
  }
  // The worst of the four responses: Z above 5 degrees, X and Y of Jupiter at the horizon.
  high.hold("X, Y, Z, S of sunlight and bright planets above 5 degrees against their spectra", 3.0, "%");
  low.hold("X, Y, Z, S of sunlight and bright planets from the horizon to 5 degrees against their spectra", 8.0, "%");
  outer_high.hold("X, Y, Z, S of Uranus and Neptune above 5 degrees against their spectra", 6.0, "%");
  outer_low.hold("X, Y, Z, S of Uranus and Neptune from the horizon to 5 degrees against their spectra", 26.0, "%");
}

TEST(StarExtinction, LeavesAStarItsOrderOfColors) {
  // Reddened stars stay near the black bodies' locus or redder: no pink, which is Y too small for X and Z.
  const StarExtinction table = make_star_extinction(clear_medium(), 0.0 * metre, standard_conditions(0.0 * metre));
  for (const double b_v : {-0.3, 0.0, 0.6, 1.5}) {
    const Xyzs color = star_color(b_v);
    double last_x = chromaticity(color).x;
    for (double altitude = 60.0; altitude >= 0.0; altitude -= 0.5) {
      const Vec4 share = star_extinction(table, sine_of_degrees(altitude), vector_of(color));
      const Chromaticity seen = chromaticity({color.x * share.x, color.y * share.y, color.z * share.z, 0.0});
      EXPECT_GE(seen.x, last_x) << b_v << " at " << altitude;
      // Between white and red all black bodies have y above this line (the purples lie below).
      EXPECT_GT(seen.y, 0.26 + 0.14 * (seen.x - 0.25)) << b_v << " at " << altitude;
      last_x = seen.x;
    }
  }
}

} // namespace
} // namespace vesper
