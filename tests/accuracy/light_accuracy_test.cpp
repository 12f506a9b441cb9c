// Colours and lux of stars against figures from outside (tests/data/README.md).

#include "vesper/base/csv.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectral_type.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace vesper {
namespace {

CsvTable test_table(const std::string& name) {
  const std::string path = VESPER_TEST_DATA "/" + name;
  return {read_file(path), path};
}

TEST(LightAccuracy, SolarColorIndexHasTheSolarChromaticity) {
  const Chromaticity sun = chromaticity(integrate_xyzs(solar_irradiance_1au()));
  const Chromaticity star = chromaticity(star_color(0.65));
  std::printf("B-V = 0.65: x, y = %.4f, %.4f; Sun (E-490) %.4f, %.4f; error %+.4f, %+.4f\n", star.x, star.y, sun.x,
              sun.y, star.x - sun.x, star.y - sun.y);
  EXPECT_NEAR(star.x, sun.x, 0.01);
  EXPECT_NEAR(star.y, sun.y, 0.01);
}

// The stated domain of the approximation, star_color.hpp.
TEST(LightAccuracy, SolarColorIndexIsAsGoodAsTheHeaderSays) {
  const Chromaticity sun = chromaticity(integrate_xyzs(solar_irradiance_1au()));
  const Chromaticity star = chromaticity(star_color(0.65));
  EXPECT_NEAR(star.x, sun.x, 0.004);
  EXPECT_NEAR(star.y, sun.y, 0.004);
}

TEST(LightAccuracy, LuxPerVGrowsWithColor) {
  struct Anchor {
    double b_v, ratio;
  };
  constexpr double tolerance = 0.015;
  double worst = 0.0;
  double square = 0.0;
  constexpr Anchor anchors[] = {{0.0, 1.0}, {0.65, 1.02}, {1.1, 1.04}, {1.7, 1.08}};
  for (const auto& [b_v, ratio] : anchors) {
    const double error = star_lux_ratio(b_v) - ratio;
    std::printf("B-V = %.2f: lux per V %.4f of an A0 star's, literature %.2f\n", b_v, star_lux_ratio(b_v), ratio);
    worst = std::max(worst, std::abs(error));
    square += error * error;
  }
  std::printf("lux per V: worst error %.4f, RMS %.4f\n", worst, std::sqrt(square / 4.0));
  EXPECT_LT(worst, tolerance);
  const Spectrum a0 = planck_spectrum(star_temperature_k(0.0));
  const double sun = lux_per_v_flux(solar_irradiance_1au()) / lux_per_v_flux(a0);
  std::printf("Sun (E-490): %.4f\n", sun);
  EXPECT_NEAR(star_lux_ratio(0.65), sun, 0.01);
}

// Along the locus the chromaticity must move one way and turn gently: x and y grow (y until the red end bends over, far
// beyond B-V = 2), and neighbouring steps differ little.
TEST(LightAccuracy, LocusIsSmoothAndMonotonic) {
  constexpr double step = 0.01;
  Chromaticity last_step{};
  double roughest = 0.0;
  for (int i = 0; i < 240; ++i) {
    const Chromaticity a = chromaticity(star_color(-0.4 + step * i));
    const Chromaticity b = chromaticity(star_color(-0.4 + step * (i + 1)));
    const Chromaticity now{b.x - a.x, b.y - a.y};
    EXPECT_GT(now.x, 0.0) << i;
    EXPECT_GT(now.y, 0.0) << i;
    if (i > 0) {
      const double change = std::hypot(now.x - last_step.x, now.y - last_step.y) / std::hypot(now.x, now.y);
      roughest = std::max(roughest, change);
    }
    last_step = now;
  }
  std::printf("locus: largest change of direction and pace from one step of 0.01 to the next: %.1f %%\n",
              100.0 * roughest);
  EXPECT_LT(roughest, 0.05);
}

// Intrinsic colours against the medians of the real catalogue. Reddening by interstellar dust is not in ours: it moves
// distant luminous stars (classes O, B and supergiants), for which only the order of magnitude is held.
TEST(LightAccuracy, SpectralTypesMatchTheMediansOfTheCatalogue) {
  const CsvTable table = test_table("light/bsc5_median_color.csv");
  double worst = 0.0;
  double square = 0.0;
  double weight = 0.0;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string type(table.cell(row, table.column("spectral_type")));
    const double median = table.number(row, table.column("median_b_v"));
    const double stars = table.number(row, table.column("stars"));
    const auto b_v = b_v_of_spectral_type(type);
    ASSERT_TRUE(b_v.has_value()) << type;
    const double error = *b_v - median;
    const bool reddened = type[0] == 'B' || type == "B1I";
    const bool carbon = type[0] == 'C';
    const bool unclassified = type.size() == 2 && !carbon;
    // The prefix g comes from older classifications, half a class away from the present ones.
    const bool old_style = type[0] == 'g';
    const double tolerance = carbon ? 0.8 : (reddened || unclassified) ? 0.35 : old_style ? 0.2 : 0.12;
    EXPECT_NEAR(*b_v, median, tolerance) << type;
    if (!reddened && !carbon && !unclassified && !old_style) {
      worst = std::max(worst, std::abs(error));
    }
    square += stars * error * error;
    weight += stars;
  }
  std::printf("B-V from the spectral type: worst %.3f mag (A to M with a luminosity class), RMS over all %.0f stars "
              "%.3f mag\n",
              worst, weight, std::sqrt(square / weight));
  EXPECT_LT(std::sqrt(square / weight), 0.08);
}

} // namespace
} // namespace vesper
