// Means over a globe's map, and what fills its holes.
#include "support/moon_inputs.hpp"

#include "vesper/catalog_tools/globe_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vesper {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

TEST(GlobeMeans, IsThePixelAtItsCentre) {
  const GlobeGrid grid = test::globe_grid(36, 10.0, [](const Vec3& d) { return 1.0 + 3.0 * d.x - d.y * d.z; });
  const GlobeMeans means(grid);
  // Up to 30 degrees from the equator, where a square on the ground is nearest to one pixel.
  for (int row = 12; row < 24; ++row) {
    for (const int column : {0, 1, 35, 70, 71}) {
      EXPECT_NEAR(means.mean(test::pixel_direction(grid, column, row), 0.0),
                  grid.values[static_cast<std::size_t>(row * 72 + column)], 2e-6);
    }
  }
}

TEST(GlobeMeans, JoinsPixelsLinearlyAcrossTheEdge) {
  GlobeGrid grid = test::globe_grid(36, -180.0, [](const Vec3&) { return 1.0; });
  const std::size_t row = 18UL * 72;
  grid.values[row] = 3.0F; // the first pixel east of longitude 180
  const GlobeMeans means(grid);
  const auto at = [&](double pixels_east) {
    const double longitude = std::numbers::pi + pixels_east * std::numbers::pi / 36.0;
    const double latitude = -0.5 * std::numbers::pi / 36.0; // the row's middle
    return means.mean(
        {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)}, 0.0);
  };
  EXPECT_NEAR(at(0.5), 3.0, 1e-3);
  EXPECT_NEAR(at(0.0), 2.0, 1e-3);
  EXPECT_NEAR(at(-0.25), 1.5, 1e-3);
  EXPECT_NEAR(at(-0.5), 1.0, 1e-3);
}

TEST(GlobeMeans, OverTheWholeSphereWeighsByArea) {
  // z^2 has the mean 1/3.
  const GlobeGrid grid = test::globe_grid(360, 0.0, [](const Vec3& d) { return d.z * d.z; });
  EXPECT_NEAR(GlobeMeans(grid).mean({1.0, 0.0, 0.0}, 2.0 * std::numbers::pi), 1.0 / 3.0, 1e-4);
}

TEST(FillMissing, LeavesAWholeMapAlone) {
  GlobeGrid grid = test::globe_grid(36, 0.0, [](const Vec3& d) { return d.x; });
  const GlobeGrid before = grid;
  EXPECT_EQ(fill_missing(grid).filled, 0U);
  EXPECT_EQ(grid.values, before.values);
}

TEST(FillMissing, TakesTheMeanOfTheNeighbours) {
  GlobeGrid grid = test::globe_grid(36, 0.0, [](const Vec3&) { return 2.0; });
  const std::size_t hole = 10UL * 72; // at the left edge: half of its neighbours are at the right
  grid.values[hole] = missing;
  grid.values[hole + 71] = 10.0F;
  const FillReport report = fill_missing(grid);
  EXPECT_EQ(report.filled, 1U);
  EXPECT_FLOAT_EQ(grid.values[hole], 3.0F);
  const double edge = 10.0 * std::numbers::pi / 36.0;
  EXPECT_NEAR(report.area_share, (std::cos(edge) - std::cos(edge + std::numbers::pi / 36.0)) / 144.0, 1e-12);
}

TEST(FillMissing, ReachesAcrossAPole) {
  GlobeGrid grid = test::globe_grid(36, 0.0, [](const Vec3& d) { return d.x > 0.0 ? 4.0 : 8.0; });
  for (std::size_t column = 0; column < 72; ++column) {
    grid.values[column] = missing;
  }
  const FillReport report = fill_missing(grid);
  EXPECT_EQ(report.filled, 72U);
  // From the second row alone: the first one is missing on the other side of the pole too.
  EXPECT_FLOAT_EQ(grid.values[0], 4.0F);
  EXPECT_FLOAT_EQ(grid.values[36], 8.0F);
}

} // namespace
} // namespace vesper
