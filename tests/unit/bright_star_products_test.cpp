#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/units.hpp"
#include "vesper/catalog_tools/star_products.hpp"
#include "vesper/light/spectral_type.hpp"
#include "vesper/light/star_color.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace vesper {
namespace {

BrightStar entry(unsigned hr, double v) {
  BrightStar star;
  star.hr = hr;
  star.has_position = true;
  star.right_ascension_deg = 90.0;
  star.declination_deg = 30.0;
  star.v_magnitude = v;
  star.b_v = 0.0;
  star.spectral_type = "A0V";
  return star;
}

TEST(StarProducts, SortsByMagnitudeThenNumber) {
  const std::vector<BrightStar> entries{entry(9, 3.0), entry(5, 1.0), entry(7, 3.0), entry(8, -1.0)};
  const StarProduct product = make_star_product(entries, {});
  std::vector<unsigned> order;
  for (const StarIdentity& star : product.catalogue.identities) {
    order.push_back(star.hr);
  }
  EXPECT_EQ(order, (std::vector<unsigned>{8, 5, 7, 9}));
}

TEST(StarProducts, CountsWhatIsDroppedAndWhy) {
  std::vector<BrightStar> entries{entry(1, 2.0), entry(2, 5.0), entry(3, 5.01), entry(4, 1.0), entry(5, 1.0)};
  entries[3].has_position = false;
  entries[4].v_magnitude.reset();
  const StarProductReport report = make_star_product(entries, {.limit_magnitude = 5.0}).report;
  EXPECT_EQ(report.read, 5U);
  EXPECT_EQ(report.kept, 2U);
  EXPECT_EQ(report.dropped_without_position, 1U);
  EXPECT_EQ(report.dropped_without_magnitude, 1U);
  EXPECT_EQ(report.dropped_by_limit, 1U);
  EXPECT_EQ(report.count_by_magnitude.at(2), 1U);
  EXPECT_EQ(report.count_by_magnitude.at(5), 1U);
}

TEST(StarProducts, PlacesTheStarAndItsMotion) {
  BrightStar star = entry(1, 0.0); // right ascension 90 deg, declination 30 deg
  star.pm_ra_arcsec_yr = 2.0;
  star.pm_dec_arcsec_yr = -1.0;
  star.parallax_arcsec = 0.5;
  star.radial_velocity_km_s = -12.0;
  const StarRecord record = make_star_product(std::vector{star}, {}).catalogue.stars.at(0);
  EXPECT_NEAR(record.position[0], 0.0, 1e-7);
  EXPECT_NEAR(record.position[1], std::sqrt(3.0) / 2.0, 1e-7);
  EXPECT_NEAR(record.position[2], 0.5, 1e-7);
  // East is -x there, north is (0, -sin 30, cos 30). The motion in right ascension is a true angle already.
  const double a = (1.0 * arcsec).to(rad);
  EXPECT_NEAR(record.proper_motion[0], -2.0 * a, 1e-12);
  EXPECT_NEAR(record.proper_motion[1], 0.5 * a, 1e-12);
  EXPECT_NEAR(record.proper_motion[2], -std::sqrt(3.0) / 2.0 * a, 1e-12);
  EXPECT_NEAR(record.parallax, 0.5 * a, 1e-12);
  EXPECT_EQ(record.radial_velocity, -12.0F);
}

TEST(StarProducts, IlluminanceFollowsMagnitudeAndColor) {
  std::vector<BrightStar> entries{entry(1, 0.0), entry(2, 5.0), entry(3, 5.0)};
  entries[2].b_v = 1.7;
  const StarProduct product = make_star_product(entries, {});
  EXPECT_NEAR(static_cast<double>(product.catalogue.stars[0].illuminance) / 2.54e-6, 1.0, 1e-6);
  EXPECT_NEAR(static_cast<double>(product.catalogue.stars[1].illuminance) / 2.54e-8, 1.0, 1e-6);
  EXPECT_NEAR(static_cast<double>(product.catalogue.stars[2].illuminance) / (2.54e-8 * 1.08), 1.0, 0.015);
  EXPECT_EQ(product.catalogue.stars[2].color[1], 1.0F);
  EXPECT_GT(product.catalogue.stars[2].color[0], product.catalogue.stars[1].color[0]);
}

TEST(StarProducts, InfersColorsAndSaysSo) {
  std::vector<BrightStar> entries{entry(1, 1.0), entry(2, 2.0), entry(3, 3.0)};
  entries[1].b_v.reset();
  entries[1].spectral_type = "K0III";
  entries[2].b_v.reset();
  entries[2].spectral_type = "pec";
  const StarProduct product = make_star_product(entries, {});
  EXPECT_EQ(product.report.inferred_colors, 1U);
  EXPECT_EQ(product.report.assumed_colors, 1U);
  EXPECT_FLOAT_EQ(product.catalogue.stars[1].color[0], static_cast<float>(star_color(1.0).x));
  EXPECT_FLOAT_EQ(product.catalogue.stars[2].color[0], static_cast<float>(star_color(0.65).x));
}

TEST(StarProducts, NegativeParallaxesAreUnknown) {
  std::vector<BrightStar> entries{entry(1, 1.0), entry(2, 2.0), entry(3, 3.0)};
  entries[0].parallax_arcsec = -0.01;
  entries[1].parallax_arcsec = 0.01;
  const StarProduct product = make_star_product(entries, {});
  EXPECT_EQ(product.catalogue.stars[0].parallax, 0.0F);
  EXPECT_GT(product.catalogue.stars[1].parallax, 0.0F);
  EXPECT_EQ(product.report.negative_parallaxes, 1U);
  EXPECT_EQ(product.report.without_parallax, 1U);
}

TEST(StarProducts, NothingLeftIsAnError) {
  EXPECT_THROW(static_cast<void>(make_star_product({}, {})), Error);
  EXPECT_THROW(static_cast<void>(make_star_product(std::vector{entry(1, 3.0)}, {.limit_magnitude = 1.0})), Error);
  EXPECT_THROW(static_cast<void>(make_star_product(std::vector{entry(1, 3.0)},
                                                   {.limit_magnitude = std::numeric_limits<double>::quiet_NaN()})),
               Error);
}

// The poles, where right ascension has no meaning but directions must still have length one.
TEST(StarProducts, PolesAndWrapsGiveValidRecords) {
  std::vector<BrightStar> entries;
  unsigned hr = 1;
  for (const double dec : {-90.0, -89.9999, 0.0, 89.9999, 90.0}) {
    for (const double ra : {0.0, 90.0, 179.9999, 270.0, 359.9999}) {
      BrightStar star = entry(hr++, 4.0);
      star.right_ascension_deg = ra;
      star.declination_deg = dec;
      star.pm_ra_arcsec_yr = 10.0;
      star.pm_dec_arcsec_yr = -10.0;
      entries.push_back(star);
    }
  }
  const StarProduct product = make_star_product(entries, {});
  EXPECT_NO_THROW(check_star_catalogue(product.catalogue, ErrorKind::argument, ""));
}

} // namespace
} // namespace vesper
