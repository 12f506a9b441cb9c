// The reference transport against another Monte Carlo's figures, measured light, and what nature conserves.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/files.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/measured_light.hpp"
#include "support/thorough.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

constexpr double published_wavelengths[] = {440.0, 550.0, 680.0};

Vec3 at_altitude(double altitude_deg, double azimuth_from_light_deg = 0.0) {
  return test::direction(azimuth_from_light_deg * deg, altitude_deg * deg);
}

const ReferenceTransport& published_transport() {
  static const ReferenceTransport transport(published_medium(), published_medium().wavelengths_nm);
  return transport;
}

const ReferenceTransport& clear_transport() {
  static const ReferenceTransport transport(clear_medium(), clear_medium().wavelengths_nm);
  return transport;
}

TEST(ReferenceTransport, ZenithRadianceOfThePublishedMedium) {
  const CsvTable table = test::atmosphere_table("sky_zenith_radiance.csv");
  struct Row {
    double nm, total, standard_error;
  };
  std::map<double, std::vector<Row>> by_altitude;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const test::TruthRow row(table, i);
    by_altitude[row.number("sun_elevation_deg")].push_back(
        {row.number("channel_nm"), row.number("total"), row.number("standard_error")});
  }
  ASSERT_EQ(by_altitude.size(), 14U);
  test::ErrorSum deviations;
  test::ErrorSum shallow_errors;
  test::ErrorSum deep_errors;
  for (const auto& [altitude, rows] : by_altitude) {
    const SkyQuery query{0.01 * kilometre, at_altitude(altitude), 0.0 * deg, {0.0, 0.0, 1.0}};
    PathBudget budget;
    budget.relative_error = altitude >= -6.0 ? 0.004 : 0.01;
    const TransportResult result = published_transport().radiance(query, {}, budget);
    for (const Row& row : rows) {
      const auto i = static_cast<std::size_t>(
          std::find(std::begin(published_wavelengths), std::end(published_wavelengths), row.nm) -
          std::begin(published_wavelengths));
      const Estimate ours = result.spectrum.at(i);
      const double allowed = 1.0e-4 * row.total / 5.0;
      deviations.add((ours.mean - row.total) / std::sqrt(ours.standard_error * ours.standard_error +
                                                         row.standard_error * row.standard_error + allowed * allowed));
      (altitude >= -6.0 ? shallow_errors : deep_errors).add(100.0 * ours.standard_error / ours.mean);
    }
  }
  deviations.hold("zenith radiance of the published medium, Sun from 60 to -18 degrees", 5.0, "standard errors");
  shallow_errors.hold("our standard error, Sun above -6 degrees", 1.0, "%");
  deep_errors.hold("our standard error, Sun from -8 to -18 degrees", 5.0, "%");
}

/// A medium that keeps all light it gets.
Medium conservative(double thickness, double asymmetry) {
  Medium medium = published_medium();
  for (MediumComponent& part : medium.components) {
    part.absorption_per_km = [](double) { return 0.0; };
    part.scattering_per_km = [law = part.scattering_per_km, thickness](double nm) { return thickness * law(nm); };
  }
  medium.components[1].phase = {PhaseKind::henyey_greenstein, [asymmetry](double) { return asymmetry; }};
  medium.ground_albedo = [](double) { return 1.0; };
  return medium;
}

/// Sum over all places of the light of what it gives at its zenith angle, f(cosine, share of the piece in all): Gauss's
/// rule with 8 nodes in pieces that are short where the light goes down.
template <class Function> double over_all_lights(const Function& f) {
  constexpr std::array<double, 4> nodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr std::array<double, 4> weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                          0.1012285362903763};
  constexpr std::array<double, 6> cuts{-0.2, -0.1, 0.0, 0.1, 0.4, 1.0};
  double sum = 0.0;
  for (std::size_t piece = 1; piece < cuts.size(); ++piece) {
    const double middle = 0.5 * (cuts[piece] + cuts[piece - 1]);
    const double half = 0.5 * (cuts[piece] - cuts[piece - 1]);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const double node : {-nodes[i], nodes[i]}) {
        sum += 2.0 * pi * half * weights[i] * f(middle + half * node, half);
      }
    }
  }
  return sum;
}

enum class Look { down_from_the_top, up_from_the_ground, level };

/// What an observer receives of lights of irradiance 1 all around, over what a field of radiance 1 gives, less 1.
double surplus(const Medium& medium, Look look, double relative_error) {
  const ReferenceTransport transport(medium, {550.0});
  SkyQuery query{0.0 * kilometre, {0.0, 0.0, 1.0}, 0.0 * deg, {0.0, 0.0, 1.0}};
  if (look == Look::down_from_the_top) {
    query.height = 100.0 * kilometre;
    query.view_direction = {0.0, 0.0, -1.0};
  }
  const double straight = look == Look::up_from_the_ground ? transport.direct_irradiance(query)[0] : 0.0;
  PathBudget budget;
  const double sum = over_all_lights([&](double cos_zenith, double share) {
    query.light_direction = {std::sqrt(1.0 - cos_zenith * cos_zenith), 0.0, cos_zenith};
    ++budget.stream;
    // The sum is soonest known when squares of errors go with what a light has in it: those that are down, a hundredth.
    budget.relative_error = relative_error * (cos_zenith < -0.03 ? 10.0 : 1.0 / std::sqrt(share));
    if (look == Look::level) {
      return transport.direct_irradiance(query)[0] + transport.diffuse_irradiance(query, {}, budget).spectrum[0].mean;
    }
    return transport.radiance(query, {}, budget).spectrum[0].mean;
  });
  return look == Look::level ? sum / pi - 1.0 : sum + straight - 1.0;
}

TEST(ReferenceTransport, ConservativeAirReturnsWhatItReceives) {
  // Lights of irradiance 1 over the whole sphere are a field of radiance 1 per steradian and stay one in air and over
  // ground that absorb nothing, wherever one looks.
  test::ErrorSum sum;
  if (test::thorough()) {
    for (const Look look : {Look::down_from_the_top, Look::up_from_the_ground, Look::level}) {
      for (const auto& [thickness, asymmetry] : {std::pair{1.0, 0.8}, {4.0, 0.0}, {1.0, -0.5}}) {
        sum.add(100.0 * surplus(conservative(thickness, asymmetry), look, 0.0012));
      }
    }
  } else {
    sum.add(100.0 * surplus(conservative(1.0, 0.8), Look::down_from_the_top, 0.0024));
    sum.add(100.0 * surplus(conservative(1.0, -0.5), Look::level, 0.0024));
  }
  sum.hold("conservative air between lights all around: light received", 0.3, "%");
}

TEST(ReferenceTransport, IlluminanceUnderClearSky) {
  const CsvTable table = test::atmosphere_table("illuminance_clear_sky.csv");
  const std::vector<double> wavelengths = clear_transport().wavelengths_nm();
  const SpectralFunctional sun = spectral_weights(solar_irradiance_1au(), wavelengths).y;
  const SpectralFunctional full_moon = spectral_weights(test::full_moon_without_surge(), wavelengths).y;
  const SpectralFunctional quarter_moon =
      spectral_weights(moon_irradiance(89.85 * deg, moon_mean_distance, astronomical_unit), wavelengths).y;
  const auto logarithm = [](double ours, double theirs) { return std::abs(std::log10(ours / theirs)); };
  test::ErrorSum day;
  test::ErrorSum civil;
  test::ErrorSum nautical;
  test::ErrorSum moon;
  PathBudget budget;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const test::TruthRow row(table, i);
    const double altitude = row.number("apparent_altitude_deg");
    budget.relative_error = altitude > 0.0 ? 0.01 : 0.03;
    const SkyQuery query{0.0 * metre, at_altitude(test::airless_altitude_deg(altitude)), 0.2666 * deg, {0.0, 0.0, 1.0}};
    const TransportResult diffuse = clear_transport().diffuse_irradiance(query, {sun, full_moon, quarter_moon}, budget);
    const std::vector<double> direct = clear_transport().direct_irradiance(query);
    const auto lux_of = [&](std::size_t k, const SpectralFunctional& light) {
      double sum = diffuse.functionals[k].mean;
      for (std::size_t j = 0; j < direct.size(); ++j) {
        sum += light[j] * direct[j];
      }
      return sum;
    };
    const double ours = lux_of(0, sun);
    std::printf("altitude %5.1f: %.5g lx, fit %.5g, ratio %.3f\n", altitude, ours, row.number("sun_lux"),
                ours / row.number("sun_lux"));
    (altitude >= 0.0 ? day : altitude >= -8.0 ? civil : nautical).add(logarithm(ours, row.number("sun_lux")));
    if (altitude > 5.0) {
      moon.add(logarithm(lux_of(1, full_moon), row.number("full_moon_lux")));
      moon.add(logarithm(lux_of(2, quarter_moon), row.number("quarter_moon_lux_elongation90")));
    }
  }
  day.hold("illuminance of clear sky against the Circular's fit, Sun above 0 degrees", std::log10(1.4), "dex");
  civil.hold("illuminance of clear sky against the Circular's fit, 0 to -8 degrees", std::log10(2.5), "dex");
  nautical.hold("illuminance of clear sky against the Circular's fit, -8 to -12 degrees", std::log10(4.5), "dex");
  moon.hold("illuminance by full and quarter Moon against the Circular's fit, above 5 degrees", std::log10(1.4), "dex");
}

TEST(ReferenceTransport, DoesNotDependOnTheNumberOfThreads) {
  const SkyQuery query{1.0 * kilometre, at_altitude(-7.0), 0.2666 * deg, at_altitude(10.0, 40.0)};
  PathBudget budget;
  budget.relative_error = 0.02;
  budget.threads = 1;
  const TransportResult one = published_transport().radiance(query, {}, budget);
  budget.threads = 3;
  const TransportResult three = published_transport().radiance(query, {}, budget);
  EXPECT_EQ(one.paths, three.paths);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one.spectrum[i].mean, three.spectrum[i].mean);
    EXPECT_EQ(one.spectrum[i].standard_error, three.spectrum[i].standard_error);
  }
  budget.stream = 1;
  EXPECT_NE(published_transport().radiance(query, {}, budget).spectrum[0].mean, one.spectrum[0].mean);
}

TEST(ReferenceTransport, StandardErrorsAreHonest) {
  // Many short answers scatter about a long one, ten times better known, as they say they do.
  const SkyQuery query{0.0 * kilometre, at_altitude(-9.0), 0.0 * deg, at_altitude(30.0, 90.0)};
  PathBudget budget;
  budget.relative_error = 0.005;
  const TransportResult fine = published_transport().radiance(query, {}, budget);
  constexpr int count = 200;
  budget.least_paths = 1024;
  budget.most_paths = 1024;
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    budget.stream = 1U + static_cast<unsigned>(i);
    const TransportResult quick = published_transport().radiance(query, {}, budget);
    const double deviation = (quick.spectrum[1].mean - fine.spectrum[1].mean) /
                             std::hypot(quick.spectrum[1].standard_error, fine.spectrum[1].standard_error);
    squares += deviation * deviation;
  }
  // The scatter of a root mean square of 200 is 5 %.
  const double rms = std::sqrt(squares / count);
  std::printf("deviations of %d short answers: RMS %.3f of their standard errors\n", count, rms);
  EXPECT_GT(rms, 0.8);
  EXPECT_LT(rms, 1.2);
}

TEST(ReferenceTransport, WhatIsSeenOnTheGroundIsWhatItReflects) {
  // Looking straight down from just above the ground: albedo over pi times its irradiance.
  const SkyQuery down{1.0 * metre, at_altitude(20.0), 0.0 * deg, {0.0, 0.0, -1.0}};
  SkyQuery level = down;
  level.height = 0.0 * metre;
  PathBudget budget;
  budget.relative_error = 0.003;
  const TransportResult seen = published_transport().radiance(down, {}, budget);
  const TransportResult sky = published_transport().diffuse_irradiance(level, {}, budget);
  const std::vector<double> sun = published_transport().direct_irradiance(level);
  for (std::size_t i = 0; i < 3; ++i) {
    const double reflected = 0.3 / pi * (sky.spectrum[i].mean + sun[i]);
    const double error = std::hypot(seen.spectrum[i].standard_error, 0.3 / pi * sky.spectrum[i].standard_error);
    // A metre of air in between weighs 1e-4.
    EXPECT_NEAR(seen.spectrum[i].mean, reflected, 4.0 * error + 1.0e-4 * reflected);
  }
}

} // namespace
} // namespace vesper
