// Moons at the limits of what maps can hold.
#include "support/expect_error.hpp"
#include "support/moon_inputs.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/catalog_tools/moon_products.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

namespace vesper {
namespace {

using test::globe_grid;

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

GlobeGrid grey(int height = 32) {
  return globe_grid(height, 0.0, [](const Vec3&) { return 0.5; });
}

/// Every texel within the rules of a map.
void expect_sound(const MoonMap& map) {
  for (std::size_t i = 0; i < cube_texel_count(map.face_size); ++i) {
    const float* texel = &map.texels[4 * i];
    const Vec3 normal(texel[1], texel[2], texel[3]);
    ASSERT_GT(texel[0], 0.0F) << i;
    ASSERT_NEAR(glm::length(normal), 1.0, 1e-3) << i;
    ASSERT_GT(glm::dot(normal, cube_texel(map.face_size, i).direction), 0.0) << i;
  }
}

TEST(MoonMapStability, MeansAreFiniteEverywhere) {
  const GlobeGrid grid = globe_grid(32, 123.4, [](const Vec3& d) { return 2.0 + d.x * d.z; });
  const GlobeMeans means(grid);
  for (const double size : {0.0, 1e-300, 1e-9, 0.01, 1.0, 3.0, 100.0}) {
    for (const Vec3& d : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(-1, 0, 0), Vec3(-1, -1e-300, 0), Vec3(-1, -0.0, 0),
                          Vec3(1e-300, 0, 1), Vec3(1e-9, -1e-9, -1), Vec3(0, 1, 0)}) {
      const double mean = means.mean(d, size);
      EXPECT_GE(mean, 1.4) << size;
      EXPECT_LE(mean, 2.6) << size;
    }
  }
}

TEST(MoonMapStability, NoSeamWhereverTheMapBegins) {
  const auto hills = [](const Vec3& d) { return 5000.0 * (d.x * d.y + d.z); };
  const auto albedo = [](const Vec3& d) { return 1.0 + 0.5 * d.y; };
  const MoonMap expected = make_moon_product(globe_grid(180, 0.0, albedo), globe_grid(180, 0.0, hills), {32}).map;
  for (const double west : {-360.0, -180.0, 90.0, 360.0, 720.0}) {
    const MoonMap map = make_moon_product(globe_grid(180, west, albedo), globe_grid(180, west, hills), {32}).map;
    double worst = 0.0;
    for (std::size_t i = 0; i < map.texels.size(); ++i) {
      worst = std::max(worst, std::abs(static_cast<double>(map.texels[i]) - static_cast<double>(expected.texels[i])));
    }
    EXPECT_LE(worst, 0x1p-11) << west; // one step of a 16-bit float
  }
}

TEST(MoonMapStability, AMapFinerThanItsPictureIsSmooth) {
  const MoonMap map = make_moon_product(globe_grid(32, 0.0, [](const Vec3& d) { return 1.0 + 0.5 * d.x; }),
                                        globe_grid(32, 0.0, [](const Vec3& d) { return 9000.0 * d.y * d.z; }), {128})
                          .map;
  expect_sound(map);
  double jump = 0.0;
  for (std::size_t i = 0; i < cube_texel_count(128); ++i) {
    if (i % 128 != 127) {
      jump =
          std::max(jump, std::abs(static_cast<double>(map.texels[4 * i + 4]) - static_cast<double>(map.texels[4 * i])));
    }
  }
  EXPECT_LT(jump, 0.002);
}

TEST(MoonMapStability, CliffsAndSpikes) {
  // From the lowest to the highest place of the Moon between neighbours.
  int flip = 0;
  expect_sound(make_moon_product(grey(),
                                 globe_grid(256, 0.0, [&](const Vec3&) { return ++flip % 2 == 0 ? -9500.0 : 11000.0; }),
                                 {128})
                   .map);
  GlobeGrid spike = globe_grid(720, 0.0, [](const Vec3&) { return -9500.0; });
  spike.values[0] = 11000.0F;
  expect_sound(make_moon_product(grey(), spike, {256}).map);
}

TEST(MoonMapStability, HolesAreFilled) {
  const auto with_hole = [](const Vec3& hole, double angle, double value) {
    return globe_grid(180, 0.0,
                      [=](const Vec3& d) { return glm::dot(d, hole) > std::cos(angle) ? std::nan("") : value; });
  };
  // Over both poles, the map's edge and the corner of three faces.
  for (const Vec3& hole : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), glm::normalize(Vec3(1, 1, 1))}) {
    const MoonProduct product = make_moon_product(with_hole(hole, 0.5, 0.4), with_hole(hole, 0.5, 700.0), {32});
    const double cap = 0.5 * (1.0 - std::cos(0.5));
    EXPECT_NEAR(product.report.albedo_fill.area_share / cap, 1.0, 0.035); // half a pixel around the hole
    EXPECT_EQ(product.report.albedo_fill.filled, product.map.provenance.elevation_filled);
    for (std::size_t i = 0; i < cube_texel_count(32); ++i) {
      ASSERT_NEAR(product.map.texels[4 * i], 0.1207, 6e-5);
    }
    expect_sound(product.map);
  }
  GlobeGrid crumbs = grey();
  for (std::size_t i = 0; i < crumbs.values.size(); ++i) {
    crumbs.values[i] = i % 3 == 0 ? crumbs.values[i] : missing;
  }
  test::expect_error(ErrorKind::input, {"of the albedo map is missing", "allowed are 50 %"},
                     [&] { return make_moon_product(crumbs, grey(), {16}); });
  test::expect_error(ErrorKind::input, {"100.0 % of the elevation grid is missing"}, [&] {
    return make_moon_product(grey(), globe_grid(32, 0, [](const Vec3&) { return std::nan(""); }), {16});
  });
}

TEST(MoonMapStability, RefusesWhatNoMapCanHold) {
  for (const int face : {-2, 0, 14, 17, 4098}) {
    test::expect_error(ErrorKind::argument, {"is not allowed", "even numbers from 16 to 4096"},
                       [&] { return make_moon_product(grey(), grey(), {face}); });
  }
  // One bright face: white would not be enough.
  test::expect_error(ErrorKind::input, {"the brightest texel has an albedo of", "allowed is 1"}, [] {
    return make_moon_product(globe_grid(90, 0.0, [](const Vec3& d) { return d.x < -0.9 ? 1.0 : 1e-3; }), grey(), {16});
  });
}

TEST(MoonMapStability, ProgressAddsUp) {
  std::atomic<std::size_t> units = 0;
  static_cast<void>(make_moon_product(grey(), grey(), {16, [&](std::size_t more) { units += more; }}));
  EXPECT_EQ(units, moon_product_work(16));
}

} // namespace
} // namespace vesper
