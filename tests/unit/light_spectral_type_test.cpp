#include "vesper/light/spectral_type.hpp"

#include <gtest/gtest.h>

namespace vesper {
namespace {

double b_v(const char* type) { return b_v_of_spectral_type(type).value(); }

TEST(SpectralType, ReadsPlainTypes) {
  EXPECT_DOUBLE_EQ(b_v("G2V"), 0.63);
  EXPECT_DOUBLE_EQ(b_v("K0III"), 1.00);
  EXPECT_DOUBLE_EQ(b_v("M2Iab"), 1.71);
  EXPECT_DOUBLE_EQ(b_v("B0V"), -0.30);
  EXPECT_DOUBLE_EQ(b_v("  G2V   "), 0.63);
}

TEST(SpectralType, InterpolatesSubtypesAndRanges) {
  EXPECT_NEAR(b_v("K2.5III"), 0.5 * (1.16 + 1.27), 1e-12);
  EXPECT_NEAR(b_v("A7/8V"), 0.5 * (0.20 + 0.25), 1e-12);
  EXPECT_NEAR(b_v("K1-2III"), 0.5 * (1.07 + 1.16), 1e-12);
  EXPECT_DOUBLE_EQ(b_v("K2-III"), b_v("K2III"));
  EXPECT_DOUBLE_EQ(b_v("F4-G1Ib"), b_v("F4Ib"));
}

TEST(SpectralType, ReadsLuminosityClasses) {
  EXPECT_NEAR(b_v("G8IV"), 0.5 * (b_v("G8III") + b_v("G8V")), 1e-12);
  EXPECT_NEAR(b_v("G8II"), 0.5 * (b_v("G8III") + b_v("G8Ib")), 1e-12);
  EXPECT_NEAR(b_v("G8II-III"), 0.5 * (b_v("G8II") + b_v("G8III")), 1e-12);
  EXPECT_NEAR(b_v("K1-2IIIb-IVa"), 0.5 * (b_v("K1-2III") + b_v("K1-2IV")), 1e-12);
  EXPECT_DOUBLE_EQ(b_v("K0II-IIICNIV"), b_v("K0II-III"));
  EXPECT_DOUBLE_EQ(b_v("K0+II"), b_v("K0II"));
}

TEST(SpectralType, TakesTheFirstComponent) {
  EXPECT_DOUBLE_EQ(b_v("K3III+F7V"), b_v("K3III"));
  EXPECT_DOUBLE_EQ(b_v("G5-8III+G:"), b_v("G5-8III"));
  // The class of the second component is not the first one's.
  EXPECT_DOUBLE_EQ(b_v("A5+K0III"), b_v("A5V"));
}

TEST(SpectralType, UnderstandsPrefixesAndMissingClasses) {
  EXPECT_DOUBLE_EQ(b_v("gG9"), b_v("G9III"));
  EXPECT_DOUBLE_EQ(b_v("g:K0"), b_v("K0III"));
  EXPECT_DOUBLE_EQ(b_v("dF5"), b_v("F5V"));
  EXPECT_DOUBLE_EQ(b_v("d:F2"), b_v("F2V"));
  EXPECT_DOUBLE_EQ(b_v("cK2"), b_v("K2I"));
  EXPECT_DOUBLE_EQ(b_v("sgG6"), b_v("G6IV"));
  EXPECT_DOUBLE_EQ(b_v("sdB"), b_v("B5V"));
  EXPECT_DOUBLE_EQ(b_v("K0"), b_v("K0III"));
  EXPECT_DOUBLE_EQ(b_v("F5"), b_v("F5V"));
}

TEST(SpectralType, KnowsStarsOutsideTheSequence) {
  EXPECT_LT(b_v("WN7-A"), -0.1);
  EXPECT_LT(b_v("WC8+O9I"), -0.1);
  EXPECT_NEAR(b_v("DA"), 0.0, 0.3);
  EXPECT_GT(b_v("C6II"), b_v("C5II"));
  EXPECT_GT(b_v("N0:"), 2.0);
  EXPECT_GT(b_v("S3.9e"), 1.6);
}

TEST(SpectralType, SaysWhenThereIsNoClass) {
  for (const char* type : {"", "   ", "pec", "g", "sg", ":", "?", "123", "+", "IV"}) {
    EXPECT_FALSE(b_v_of_spectral_type(type).has_value()) << type;
  }
}

TEST(SpectralType, GrowsRedderAlongTheSequence) {
  for (const char* luminosity : {"V", "III", "Ib"}) {
    double before = -1.0;
    for (const char* type :
         {"O5", "O9", "B0", "B2", "B5", "B8", "A0", "A5", "F0", "F5", "G0", "G5", "K0", "K5", "M0"}) {
      const double now = b_v((std::string(type) + luminosity).c_str());
      EXPECT_GT(now, before) << type << luminosity;
      before = now;
    }
  }
}

} // namespace
} // namespace vesper
