#include "vesper/base/units.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

namespace vesper {
namespace {

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Dividable = requires(A a, B b) {
  a / b;
};

// What the types are for: no arithmetic across dimensions, no silent conversion from or to plain numbers.
static_assert(Addable<Angle, Angle> && !Addable<Angle, Length> && !Addable<Angle, double>);
static_assert(!Addable<Luminance, Illuminance> && !Dividable<Luminance, Illuminance>);
static_assert(std::is_same_v<decltype(std::declval<Angle>() / std::declval<Angle>()), double>);
static_assert(!std::is_convertible_v<double, Angle> && !std::is_convertible_v<Angle, double>);
static_assert(sizeof(Angle) == sizeof(double) && std::is_trivially_copyable_v<Angle>);

TEST(Units, AnglesConvertBetweenTheirUnits) {
  EXPECT_DOUBLE_EQ((180.0 * deg).to(rad), 3.14159265358979323846);
  EXPECT_DOUBLE_EQ((1.0 * deg).to(arcmin), 60.0);
  EXPECT_DOUBLE_EQ((1.0 * deg).to(arcsec), 3600.0);
  EXPECT_DOUBLE_EQ((1.0 * arcsec).to(milliarcsec), 1000.0);
  EXPECT_DOUBLE_EQ((1.0 * rad).to(arcsec), 206264.80624709635516); // the parsec in astronomical units
}

TEST(Units, LengthsConvertBetweenTheirUnits) {
  EXPECT_DOUBLE_EQ((1.0 * astronomical_unit).to(kilometre), 149597870.7);
  EXPECT_DOUBLE_EQ((2500.0 * metre).to(kilometre), 2.5);
}

TEST(Units, ArithmeticAndOrderFollowTheNumbers) {
  EXPECT_DOUBLE_EQ((1.0 * deg + 30.0 * arcmin - 900.0 * arcsec).to(deg), 1.25);
  EXPECT_DOUBLE_EQ((-(2.0 * deg)).to(deg), -2.0);
  EXPECT_DOUBLE_EQ((3.0 * (deg * 2.0) / 4.0).to(deg), 1.5);
  EXPECT_DOUBLE_EQ((1.0 * deg) / (1.0 * arcmin), 60.0);
  EXPECT_LT(59.0 * arcmin, deg);
  EXPECT_EQ(Angle{}, 0.0 * deg);
}

} // namespace
} // namespace vesper
