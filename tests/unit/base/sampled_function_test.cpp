// Functions known by samples, against closed forms.
#include "vesper/base/sampled_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

template <class Function> SampledFunction sampled(Function&& function) {
  SampledFunction::Samples samples{};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples.at(i) = function(SampledFunction::points().at(i));
  }
  return SampledFunction(samples);
}

TEST(SampledFunction, PointsAscendFromEndToEnd) {
  const auto& points = SampledFunction::points();
  EXPECT_EQ(points.front(), -1.0);
  EXPECT_EQ(points.back(), 1.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LT(points.at(i - 1), points.at(i));
  }
}

TEST(SampledFunction, FollowsSlowWavesAsPromised) {
  struct Case {
    double wave, error;
  };
  for (const Case& c : {Case{0.5, 2e-15}, Case{1.0, 1e-13}, Case{2.0, 3e-8}}) {
    const double w = c.wave * std::numbers::pi;
    double worst = 0.0;
    double worst_slope = 0.0;
    const SampledFunction f = sampled([&](double x) { return std::cos(w * x + 0.3); });
    const SampledFunction slope = f.derivative();
    for (double x = -1.0; x <= 1.0; x += 1.0 / 512.0) {
      worst = std::max(worst, std::abs(f.value(x) - std::cos(w * x + 0.3)));
      worst_slope = std::max(worst_slope, std::abs(slope.value(x) + w * std::sin(w * x + 0.3)));
      EXPECT_NEAR(slope.value(x), f.slope(x), 1e-13);
    }
    std::printf("cos(%.1f pi x): worst %.2g, slope %.2g\n", c.wave, worst, worst_slope);
    EXPECT_LT(worst, c.error);
    EXPECT_LT(worst_slope, 400.0 * c.error); // the derivative loses up to the square of the degree
  }
}

TEST(SampledFunction, FindsEverySignChange) {
  const auto changes = sampled([](double x) { return std::sin(5.0 * x + 0.1); }).sign_changes();
  ASSERT_EQ(changes.size(), 3U);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    EXPECT_EQ(changes[i].upward, i == 1);
    EXPECT_NEAR(changes[i].x, ((static_cast<double>(i) - 1.0) * std::numbers::pi - 0.1) / 5.0, 1e-10);
  }
}

TEST(SampledFunction, TwoZerosHoweverNearAreFound) {
  for (const double centre : {-0.97, -0.2, 0.0, 1.0 / 3.0, 0.5}) {
    for (double apart = 0.5; apart > 1e-6; apart *= 0.3) {
      const double depth = 0.25 * apart * apart;
      const auto wave = [&](double x) { return 0.5 * (x - centre) * (x - centre); };
      const bool inside = centre - 0.5 * apart > -1.0 && centre + 0.5 * apart < 1.0;
      const auto touching = sampled([&](double x) { return wave(x) - 0.5 * depth; }).sign_changes();
      if (inside) {
        ASSERT_EQ(touching.size(), 2U) << centre << " " << apart;
        EXPECT_NEAR(touching[1].x - touching[0].x, apart, 4e-15 / apart + 1e-13) << centre;
      }
      EXPECT_TRUE(sampled([&](double x) { return wave(x) + 0.5 * depth; }).sign_changes().empty());
    }
  }
}

TEST(SampledFunction, AZeroAtTheEndBelongsToTheNextPiece) {
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(sampled([&](double x) { return sign * (x - 1.0); }).sign_changes().empty());
    EXPECT_EQ(sampled([&](double x) { return sign * (x + 1.0); }).sign_changes().size(), 1U);
  }
}

TEST(SampledFunction, WhatNeverMovesHasNoSignChange) {
  EXPECT_TRUE(sampled([](double) { return 0.0; }).sign_changes().empty());
  EXPECT_TRUE(sampled([](double) { return -1e-300; }).sign_changes().empty());
  EXPECT_TRUE(sampled([](double x) { return 0.3 + 1e-17 * x; }).sign_changes().empty());
}

TEST(SampledFunction, ATripleZeroIsOneSignChange) {
  const auto changes = sampled([](double x) { return x * x * x; }).sign_changes();
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NEAR(changes[0].x, 0.0, 1e-5); // all that rounding leaves of it
}

} // namespace
} // namespace vesper
