// Colours at and beyond the ends of their range.

#include "vesper/base/error.hpp"
#include "vesper/light/spectral_type.hpp"
#include "vesper/light/star_color.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>

namespace vesper {
namespace {

TEST(LightStability, EveryColorIndexHasAPositiveFiniteColor) {
  for (double b_v = -2.0; b_v <= 12.0; b_v += 0.0137) {
    const Xyzs color = star_color(b_v);
    for (const double value : {color.x, color.y, color.z, color.s, star_lux_ratio(b_v), star_temperature_k(b_v)}) {
      ASSERT_TRUE(std::isfinite(value) && value > 0.0) << b_v;
    }
  }
}

TEST(LightStability, EndsOfTheRangeHold) {
  EXPECT_EQ(star_color(-100.0).x, star_color(min_star_b_v).x);
  EXPECT_EQ(star_color(100.0).x, star_color(max_star_b_v).x);
  EXPECT_EQ(star_lux_ratio(100.0), star_lux_ratio(max_star_b_v));
}

TEST(LightStability, NumbersThatAreNoneAreRefused) {
  for (const double b_v : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(static_cast<void>(star_color(b_v)), Error);
    EXPECT_THROW(static_cast<void>(star_lux_ratio(b_v)), Error);
    EXPECT_THROW(static_cast<void>(star_temperature_k(b_v)), Error);
  }
}

TEST(LightStability, AnyTextIsASpectralTypeOrNone) {
  std::mt19937 random(20260812);
  constexpr std::string_view letters = "OBAFGKMWCNRSDgdcsIVab0123456789.+-/: p";
  std::uniform_int_distribution<std::size_t> pick(0, letters.size() - 1);
  std::uniform_int_distribution<int> length(0, 20);
  for (int i = 0; i < 200000; ++i) {
    std::string type;
    for (int n = length(random); n > 0; --n) {
      type += letters[pick(random)];
    }
    if (const auto b_v = b_v_of_spectral_type(type)) {
      ASSERT_TRUE(*b_v > -0.5 && *b_v < 4.0) << type;
    }
  }
}

} // namespace
} // namespace vesper
