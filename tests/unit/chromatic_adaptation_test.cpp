// The eye's adaptation to a white against worked figures and what defines it.
#include "vesper/plan/chromatic_adaptation.hpp"

#include "support/expect_error.hpp"
#include "support/truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace vesper {
namespace {

const Vec3 d65(0.3127 / 0.3290, 1.0, 0.3583 / 0.3290);
const Vec3 moonlight(0.9879, 1.0, 0.8249);
const Vec3 illuminant_a(1.09850, 1.0, 0.35585);

double largest_difference(const Vec3& a, const Vec3& b) {
  const Vec3 difference = glm::abs(a - b);
  return std::max({difference.x, difference.y, difference.z});
}

TEST(ChromaticAdaptation, IsThatOfWorkedFigures) {
  // CAT16 in one step with CIECAM02's D, F = 1: colour-science 0.4.7, the cases of its chromatic_adaptation_Li2025.
  struct Case {
    Vec3 color, from, to;
    double field_cd_m2;
    Vec3 adapted;
  };
  const std::vector<Case> cases{
      {{48.900, 43.620, 6.250}, illuminant_a, {0.95047, 1.0, 1.08883}, 318.31, {40.00725815, 43.70148954, 21.32902932}},
      {{52.034, 58.824, 23.703},
       {0.92288, 1.0, 0.38775},
       {1.05432, 1.0, 1.37392},
       318.31,
       {59.99869086, 58.81067197, 83.41018242}},
      {{48.900, 43.620, 6.250}, illuminant_a, {0.95047, 1.0, 1.08883}, 20.0, {41.22388901, 43.69034082, 19.26604215}}};
  test::ErrorSum error;
  for (const Case& known : cases) {
    const double degree = degree_of_adaptation(known.field_cd_m2 * candela_per_m2);
    const Vec3 adapted = chromatic_adaptation(known.from, known.to, degree) * known.color;
    error.add(largest_difference(adapted, known.adapted));
  }
  error.hold("adaptation of colours against worked figures, X, Y, Z of a white of 100", 1.0e-7, "");
}

TEST(ChromaticAdaptation, TakesWhiteToWhiteAsFarAsItGoes) {
  for (const Vec3& white : {illuminant_a, Vec3(0.9739, 1.0, 1.0), Vec3(1.0, 1.0, 1.0)}) {
    EXPECT_LT(largest_difference(chromatic_adaptation(white, d65, 1.0) * white, d65), 1.0e-12);
    EXPECT_LT(largest_difference(chromatic_adaptation(white, d65, 0.4) * white, 0.4 * d65 + 0.6 * white), 1.0e-12);
    for (const Mat3& nothing : {chromatic_adaptation(white, d65, 0.0), chromatic_adaptation(white, white, 0.8)}) {
      for (int column = 0; column < 3; ++column) {
        EXPECT_LT(largest_difference(nothing[column], Mat3(1.0)[column]), 1.0e-14);
      }
    }
  }
}

TEST(ChromaticAdaptation, GoesFurtherInMoreLight) {
  EXPECT_NEAR(degree_of_adaptation(Luminance()), 1.0 - std::exp(-42.0 / 92.0) / 3.6, 1.0e-15);
  EXPECT_LT(degree_of_adaptation(1.0 * candela_per_m2), degree_of_adaptation(100.0 * candela_per_m2));
  EXPECT_NEAR(degree_of_adaptation(1.0e4 * candela_per_m2), 1.0, 1.0e-15);
}

TEST(ChromaticAdaptation, OfADisplayIsThatTransformWithItsLuminanceKept) {
  const auto xy_of = [](const Vec3& xyz) { return Vec2(xyz) / (xyz.x + xyz.y + xyz.z); };
  const Mat3 xyz_from_rgb = f64::xyz_from_rgb(f64::chromaticities_of(f64::primaries_srgb));
  test::ErrorSum error;
  // Sunlight by day and moonlight by night: pi times 5 lux for each cd/m2 of the field.
  for (const auto& [white, field_cd_m2] : {std::pair(Vec3(0.9727, 1.0, 1.0336), 5000.0), std::pair(moonlight, 0.01)}) {
    const Mat3 cat16 = chromatic_adaptation(white, d65, degree_of_adaptation(field_cd_m2 * candela_per_m2));
    const Mat3 shown = adapted_to_light(5.0 * std::numbers::pi * field_cd_m2 * white, d65).shown_from_xyz;
    EXPECT_LT(largest_difference(shown * white, cat16 * white), 1.0e-6);
    for (int i = 1; i < 216; ++i) {
      const Vec3 color = xyz_from_rgb * Vec3(i % 6, i / 6 % 6, i / 36);
      EXPECT_DOUBLE_EQ((shown * color).y, color.y);
      const Vec2 difference = xy_of(shown * color) - xy_of(cat16 * color);
      error.add(difference.x);
      error.add(difference.y);
    }
  }
  error.hold("colours of sRGB adapted with their luminance kept against CAT16, x and y", 0.0015, "");
}

TEST(ChromaticAdaptation, LeavesWhatRodsSeeItsHue) {
  const ColorAdaptation by_moonlight = adapted_to_light(0.2 * moonlight, d65);
  const Vec3 shown = by_moonlight.shown_from_xyz * by_moonlight.rod_hue;
  EXPECT_LT(largest_difference(shown / shown.y, f64::night_hue), 1.0e-12);
  EXPECT_NEAR(by_moonlight.rod_hue.y, 1.0, 1.0e-15);
  EXPECT_EQ(ColorAdaptation{}.rod_hue, f64::night_hue);
}

TEST(ChromaticAdaptation, KnowsWhatIsNoLight) {
  for (const double bad :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int component = 0; component < 3; ++component) {
      Vec3 light(1.0);
      light[component] = bad;
      test::expect_error(ErrorKind::argument, {"no white"}, [&] { return adapted_to_light(light, d65); });
    }
  }
}

} // namespace
} // namespace vesper
