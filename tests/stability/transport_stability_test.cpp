// The reference transport where methods fail: extreme phase functions and densities, the ends of the air, lights at the
// poles of the sky.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/base/error.hpp"

#include "support/media.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

Vec3 at_altitude(double altitude_deg) {
  const double a = altitude_deg * pi / 180.0;
  return {std::cos(a), 0.0, std::sin(a)};
}

const Vec3 up(0.0, 0.0, 1.0);
const Vec3 down(0.0, 0.0, -1.0);

PathBudget quick(double relative_error = 0.05) {
  PathBudget budget;
  budget.relative_error = relative_error;
  budget.least_paths = 1024;
  budget.most_paths = 8192;
  return budget;
}

void expect_possible(const std::vector<Estimate>& values, const std::string& where) {
  for (const Estimate& value : values) {
    EXPECT_TRUE(std::isfinite(value.mean) && value.mean >= 0.0) << where << ": " << value.mean;
    EXPECT_TRUE(std::isfinite(value.standard_error) && value.standard_error >= 0.0) << where;
  }
}

/// Radiance and irradiance from many places toward many directions, under lights everywhere.
void expect_possible_everywhere(const Medium& medium, const std::vector<double>& wavelengths, const std::string& name) {
  const ReferenceTransport transport(medium, wavelengths);
  const double top = (medium.top_radius - medium.ground_radius).to(kilometre);
  for (const double height : {0.0, 1.0e-9, 5.0, top, top + 1.0e-9, 40000.0}) {
    for (const double light : {90.0, 30.0, 0.0, -1.0e-7, -6.0, -90.0}) {
      const std::string where = name + ", height " + std::to_string(height) + " km, light at " + std::to_string(light);
      for (const double view : {90.0, 0.0, -1.0e-7, -8.0, -90.0}) {
        const SkyQuery query{height * kilometre, at_altitude(light), 0.2666 * deg, at_altitude(view)};
        PathBudget budget = quick();
        budget.least_paths = 128;
        budget.most_paths = 128;
        expect_possible(transport.radiance(query, {}, budget).spectrum, where + ", view at " + std::to_string(view));
        if (view == 90.0) {
          expect_possible(transport.diffuse_irradiance(query, {}, budget).spectrum, where);
          for (const double direct : transport.direct_irradiance(query)) {
            EXPECT_TRUE(direct >= 0.0 && direct <= 1.0) << where;
          }
        }
      }
    }
  }
}

TEST(TransportStability, BothPresetsFromEverywhere) {
  expect_possible_everywhere(published_medium(), published_medium().wavelengths_nm, "published");
  expect_possible_everywhere(clear_medium(), {360.0, 440.0, 550.0, 680.0, 830.0}, "clear");
}

TEST(TransportStability, AsymmetriesFromMinus099To099) {
  for (const PhaseKind kind : {PhaseKind::henyey_greenstein, PhaseKind::cornette_shanks, PhaseKind::schlick}) {
    for (const double g : {-0.99, 0.0, 0.99}) {
      Medium medium = published_medium();
      medium.components[1].phase = {kind, [g](double) { return g; }};
      expect_possible_everywhere(medium, {550.0}, "g = " + std::to_string(g));
    }
  }
}

TEST(TransportStability, NoAirAtAllLeavesTheGround) {
  const ReferenceTransport transport(test::scaled(published_medium(), 0.0), {550.0});
  for (const double light : {90.0, 10.0, -1.0}) {
    const double lit = std::max(0.0, std::sin(light * pi / 180.0));
    SkyQuery query{10.0 * kilometre, at_altitude(light), 0.0 * deg, down};
    const Estimate ground = transport.radiance(query, {}, quick()).spectrum[0];
    EXPECT_NEAR(ground.mean, 0.3 / pi * lit, 4.0 * ground.standard_error + 1.0e-12);
    query.view_direction = up;
    EXPECT_EQ(transport.radiance(query, {}, quick()).spectrum[0].mean, 0.0);
    EXPECT_EQ(transport.diffuse_irradiance(query, {}, quick()).spectrum[0].mean, 0.0);
    EXPECT_NEAR(transport.direct_irradiance(query)[0], lit, 1.0e-9);
  }
}

TEST(TransportStability, AHundredTimesTheAir) {
  expect_possible_everywhere(test::scaled(published_medium(), 100.0), published_medium().wavelengths_nm,
                             "a hundredfold");
  // The ground is out of sight: what a white one and a black one send to the top is the same.
  std::vector<Estimate> back;
  for (const double albedo : {0.0, 1.0}) {
    Medium medium = test::scaled(published_medium(), 100.0);
    medium.ground_albedo = [albedo](double) { return albedo; };
    const ReferenceTransport transport(medium, {440.0});
    PathBudget budget;
    budget.relative_error = 0.04;
    budget.least_paths = 1024;
    budget.stream = back.size();
    back.push_back(transport.radiance({100.0 * kilometre, up, 0.0 * deg, down}, {}, budget).spectrum[0]);
  }
  EXPECT_GT(back[0].mean, 0.1 / pi);
  EXPECT_LT(back[0].mean, 1.0 / pi);
  EXPECT_NEAR(back[0].mean, back[1].mean, 4.0 * std::hypot(back[0].standard_error, back[1].standard_error));
}

TEST(TransportStability, LayersWithoutThicknessAndOverEachOther) {
  Medium medium = published_medium();
  const Medium plain = published_medium();
  // Without thickness a layer holds nothing.
  medium.components.push_back({"sheet",
                               HeightProfile::table({5.0, 5.0}, {1.0e3, 1.0e3}, HeightProfile::Between::linear),
                               [](double) { return 1.0; }, [](double) { return 0.0; }, medium.components[0].phase});
  // Two halves in one place are the whole.
  medium.components[0].scattering_per_km = [law = plain.components[0].scattering_per_km](double nm) {
    return 0.5 * law(nm);
  };
  medium.components.push_back(medium.components[0]);
  const ReferenceTransport split(medium, {550.0});
  const ReferenceTransport whole(plain, {550.0});
  PathBudget budget;
  budget.relative_error = 0.005;
  for (const double light : {30.0, -5.0}) {
    const SkyQuery query{0.0 * kilometre, at_altitude(light), 0.0 * deg, at_altitude(40.0)};
    const Estimate a = split.radiance(query, {}, budget).spectrum[0];
    budget.stream = 1;
    const Estimate b = whole.radiance(query, {}, budget).spectrum[0];
    EXPECT_NEAR(a.mean, b.mean, 4.0 * std::hypot(a.standard_error, b.standard_error));
  }
}

TEST(TransportStability, AlbedoZeroAndOne) {
  for (const double albedo : {0.0, 1.0}) {
    Medium medium = published_medium();
    medium.ground_albedo = [albedo](double) { return albedo; };
    expect_possible_everywhere(medium, {550.0}, "albedo " + std::to_string(albedo));
  }
}

TEST(TransportStability, GrazingRaysFromOutside) {
  const ReferenceTransport transport(published_medium(), {550.0});
  const double height = 36000.0;
  const double distance = 6360.0 + height;
  const auto toward_limb = [&](double radius) {
    const double nadir_angle = std::asin(radius / distance);
    return Vec3(std::sin(nadir_angle), 0.0, -std::cos(nadir_angle));
  };
  const auto seen = [&](double radius) {
    const SkyQuery query{height * kilometre, up, 0.0 * deg, toward_limb(radius)};
    return transport.radiance(query, {}, quick(0.02)).spectrum[0];
  };
  // The Sun stands behind the observer: the limb fades from the ground to the top and is dark beyond.
  EXPECT_GT(seen(6360.001).mean, seen(6400.0).mean);
  EXPECT_GT(seen(6400.0).mean, seen(6450.0).mean);
  EXPECT_GT(seen(6459.99).mean, 0.0);
  EXPECT_EQ(seen(6460.0 + 1.0e-6).mean, 0.0);
  // Ground and limb meet without a seam as far as single scattering goes: the grazing ground is hidden in the air.
  const Estimate above = seen(6360.001);
  const Estimate below = seen(6359.999);
  EXPECT_NEAR(below.mean, above.mean, 0.2 * above.mean);
}

TEST(TransportStability, MovingThroughTheTopIsNoJump) {
  const ReferenceTransport transport(published_medium(), {550.0});
  PathBudget budget;
  budget.relative_error = 0.004;
  for (const double view : {-10.0, -60.0}) {
    const auto seen = [&](double height) {
      const SkyQuery query{height * kilometre, at_altitude(20.0), 0.0 * deg, at_altitude(view)};
      return transport.radiance(query, {}, budget).spectrum[0];
    };
    const Estimate inside = seen(99.999);
    const Estimate outside = seen(100.001);
    EXPECT_NEAR(inside.mean, outside.mean, 4.0 * std::hypot(inside.standard_error, outside.standard_error));
  }
}

TEST(TransportStability, AnAzimuthMattersNotWithTheLightOverhead) {
  const ReferenceTransport transport(published_medium(), {550.0});
  PathBudget budget;
  budget.relative_error = 0.003;
  const auto toward = [&](double azimuth) {
    const double a = azimuth * pi / 180.0;
    const SkyQuery query{0.0 * kilometre, up, 0.0 * deg, {std::cos(a) * 0.6, std::sin(a) * 0.6, 0.8}};
    ++budget.stream;
    return transport.radiance(query, {}, budget).spectrum[0];
  };
  const Estimate north = toward(0.0);
  const Estimate elsewhere = toward(123.0);
  EXPECT_NEAR(north.mean, elsewhere.mean, 4.0 * std::hypot(north.standard_error, elsewhere.standard_error));
}

TEST(TransportStability, WhatScattersAtOneWavelengthAlone) {
  // Paths are drawn for other wavelengths, at which this medium is dark.
  Medium medium = published_medium();
  for (MediumComponent& part : medium.components) {
    part.scattering_per_km = [law = part.scattering_per_km](double nm) { return nm == 700.0 ? law(550.0) : 0.0; };
    part.absorption_per_km = [law = part.absorption_per_km](double) { return law(550.0); };
  }
  medium.ground_albedo = [](double nm) { return nm == 700.0 ? 0.3 : 0.0; };
  const ReferenceTransport lonely(medium, {400.0, 450.0, 500.0, 550.0, 600.0, 650.0, 700.0});
  const ReferenceTransport plain(medium, {700.0});
  PathBudget budget;
  budget.relative_error = 0.01;
  const SkyQuery query{0.0 * kilometre, at_altitude(20.0), 0.0 * deg, at_altitude(50.0)};
  const std::vector<double> last{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
  const TransportResult result = lonely.radiance(query, {last}, budget);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(result.spectrum[i].mean, 0.0);
  }
  const Estimate expected = plain.radiance(query, {}, budget).spectrum[0];
  EXPECT_NEAR(result.spectrum[6].mean, expected.mean,
              4.0 * std::hypot(result.spectrum[6].standard_error, expected.standard_error));
}

TEST(TransportStability, DeepNightEndsByItself) {
  const ReferenceTransport transport(published_medium(), {550.0});
  PathBudget budget;
  budget.relative_error = 0.01;
  budget.most_paths = 1U << 14U;
  const SkyQuery query{0.0 * kilometre, down, 0.0 * deg, up};
  const TransportResult result = transport.radiance(query, {}, budget);
  EXPECT_LE(result.paths, budget.most_paths);
  expect_possible(result.spectrum, "the Sun at the nadir");
  EXPECT_LT(result.spectrum[0].mean, 1.0e-12);
}

TEST(TransportStability, RefusesWhatIsNoQuery) {
  const ReferenceTransport transport(published_medium(), {550.0});
  const SkyQuery good{0.0 * kilometre, up, 0.0 * deg, up};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Length height : {-1.0 * metre, nan * metre, std::numeric_limits<double>::infinity() * metre}) {
    SkyQuery query = good;
    query.height = height;
    EXPECT_THROW((void)transport.radiance(query, {}, {}), Error);
  }
  for (const Vec3& direction : {Vec3(0.0), Vec3(0.0, 0.0, 2.0), Vec3(nan, 0.0, 0.0)}) {
    SkyQuery query = good;
    query.light_direction = direction;
    EXPECT_THROW((void)transport.radiance(query, {}, {}), Error);
    query = good;
    query.view_direction = direction;
    EXPECT_THROW((void)transport.diffuse_irradiance(query, {}, {}), Error);
  }
  SkyQuery wide = good;
  wide.light_angular_radius = 2.0 * deg;
  EXPECT_THROW((void)transport.direct_irradiance(wide), Error);
  EXPECT_THROW((void)transport.radiance(good, {{1.0, 2.0}}, {}), Error);
  PathBudget none;
  none.orders = 0;
  EXPECT_THROW((void)transport.radiance(good, {}, none), Error);
  EXPECT_THROW(ReferenceTransport(published_medium(), {}), Error);
  EXPECT_THROW(ReferenceTransport(published_medium(), {550.0, 440.0}), Error);
  Medium crowded = published_medium();
  while (crowded.components.size() < 9) {
    crowded.components.push_back(crowded.components[0]);
  }
  EXPECT_THROW(ReferenceTransport(crowded, {550.0}), Error);
  Medium bright = published_medium();
  bright.ground_albedo = [](double) { return 1.5; };
  EXPECT_THROW(ReferenceTransport(bright, {550.0}), Error);
}

} // namespace
} // namespace vesper
