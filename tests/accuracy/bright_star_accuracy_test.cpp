// The embedded star buffer against the Hipparcos catalogue, and the light that conversion loses.

#include "vesper/assets/default_stars.hpp"
#include "vesper/assets/star_catalogue_check.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/files.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/catalog_tools/bright_star_catalogue.hpp"
#include "vesper/catalog_tools/star_products.hpp"
#include "vesper/light/photometry.hpp"

#include "support/truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace vesper {
namespace {

const StarRecord& star_of_hr(unsigned hr, std::size_t& index) {
  const StarCatalogue& c = default_star_catalogue();
  const auto found =
      std::find_if(c.identities.begin(), c.identities.end(), [&](const StarIdentity& s) { return s.hr == hr; });
  index = static_cast<std::size_t>(found - c.identities.begin());
  return c.stars.at(index);
}

Vec3 to_vec3(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

// The catalogue rounds to 0.1 s (1.5") and 1": places cannot be better than about 1" for single stars. Bright double
// stars are listed at the centre of light or at a component: up to 2".
TEST(BrightStarAccuracy, PlacesMotionsAndMagnitudesMatchHipparcos) {
  const std::string path = VESPER_TEST_DATA "/catalogue/hipparcos_bright.csv";
  const CsvTable table(read_file(path), path);
  test::ErrorSum place;
  test::ErrorSum motion;
  test::ErrorSum magnitude;
  const auto number = [&](std::size_t row, const char* column) { return table.number(row, table.column(column)); };
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto hr = static_cast<unsigned>(number(row, "hr"));
    std::size_t index = 0;
    const StarRecord& star = star_of_hr(hr, index);
    const double ra = (number(row, "ra_j1991_25_deg") * deg).to(rad);
    const double dec = (number(row, "dec_j1991_25_deg") * deg).to(rad);
    const Vec3 east(-std::sin(ra), std::cos(ra), 0.0);
    const Vec3 north(-std::sin(dec) * std::cos(ra), -std::sin(dec) * std::sin(ra), std::cos(dec));
    const Vec3 rate = (number(row, "pm_ra_cosdec_mas_yr") * milliarcsec).to(rad) * east +
                      (number(row, "pm_dec_mas_yr") * milliarcsec).to(rad) * north;
    const Vec3 at_1991(std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec));
    const Vec3 expected = glm::normalize(at_1991 + 8.75 * rate);
    const double error = (glm::length(to_vec3(star.position) - expected) * rad).to(arcsec);
    EXPECT_LT(error, 2.0) << "HR " << hr;
    place.add(error);
    motion.add((glm::length(to_vec3(star.proper_motion) - rate) * rad).to(milliarcsec));
    const auto v = static_cast<double>(default_star_catalogue().identities[index].magnitude);
    magnitude.add(v - number(row, "v_magnitude"));
  }
  std::printf("%zu bright stars against Hipparcos: place worst %.2f\", RMS %.2f\"; proper motion worst %.0f, RMS %.0f "
              "mas/year; V worst %.2f, RMS %.2f mag\n",
              place.count(), place.worst(), place.rms(), motion.worst(), motion.rms(), magnitude.worst(),
              magnitude.rms());
  EXPECT_LT(place.rms(), 0.7);
  // Motions of close doubles differ by their orbits; the catalogue's are of 1988.
  EXPECT_LT(motion.rms(), 40.0);
  EXPECT_LT(magnitude.rms(), 0.15);
}

TEST(BrightStarAccuracy, IlluminanceIsPreserved) {
  const StarCatalogue& c = default_star_catalogue();
  const double before = c.provenance.illuminance_lux;
  const double after = total_illuminance_lux(c);
  std::printf("total illuminance: %.9e lx before, %.9e lx after, relative change %+.1e\n", before, after,
              (after - before) / before);
  EXPECT_NEAR(after / before, 1.0, 1e-6);
}

// Independent of the conversion: the sum over magnitudes alone, with lux per V between that of the bluest and the
// reddest stars.
TEST(BrightStarAccuracy, IlluminanceAgreesWithTheMagnitudes) {
  const StarCatalogue& c = default_star_catalogue();
  double a0_lux = 0.0;
  for (const StarIdentity& star : c.identities) {
    a0_lux += 2.54e-6 * std::pow(10.0, -0.4 * static_cast<double>(star.magnitude));
  }
  const double ratio = total_illuminance_lux(c) / a0_lux;
  std::printf("total illuminance: %.4f of the same magnitudes at B-V = 0\n", ratio);
  EXPECT_GT(ratio, 0.99);
  EXPECT_LT(ratio, 1.05);
}

// On the original file, where a person names it.
TEST(BrightStarAccuracy, TheOriginalFileGivesTheEmbeddedBuffer) {
  const char* path = std::getenv("VESPER_BSC5");
  if (path == nullptr) {
    GTEST_SKIP() << "set VESPER_BSC5 to the catalogue's original file to run this test";
  }
  const StarProduct product = make_star_product(read_bright_star_catalogue(read_file(path), path), {});
  EXPECT_EQ(product.report.read, 9110U);
  EXPECT_EQ(product.report.kept, 9096U);
  EXPECT_EQ(product.report.dropped_without_position, 14U);
  EXPECT_EQ(product.report.inferred_colors + product.report.assumed_colors, 9096U - 8786U);
  const StarCatalogue& embedded = default_star_catalogue();
  ASSERT_EQ(embedded.stars.size(), product.catalogue.stars.size());
  for (std::size_t i = 0; i < embedded.stars.size(); ++i) {
    ASSERT_EQ(embedded.identities[i].hr, product.catalogue.identities[i].hr);
    ASSERT_EQ(embedded.stars[i].illuminance, product.catalogue.stars[i].illuminance);
  }
}

} // namespace
} // namespace vesper
