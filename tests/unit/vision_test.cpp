// The eye's mathematics (visibility, mesopic and vision of shaders/lib): limits, order, continuity, in both precisions.
#include "vesper/base/shader_math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vesper {
namespace {

/// Luminances a decade apart by `steps`, 1e-9 to 2e9 cd/m2.
template <class Check> void over_luminances(int steps, const Check& check) {
  for (int i = -9 * steps; i <= 9 * steps + 3; ++i) {
    check(std::pow(10.0, static_cast<double>(i) / steps));
  }
}

TEST(ThresholdOfAPoint, NeverFallsAndHasNoStep) {
  double last = f64::threshold_illuminance_lux(0.0, 1.7);
  EXPECT_GT(last, 0.0);
  EXPECT_EQ(f64::threshold_illuminance_lux(-1.0, 1.7), last);
  over_luminances(200, [&](double cd_m2) {
    const double threshold = f64::threshold_illuminance_lux(cd_m2, 1.7);
    ASSERT_TRUE(std::isfinite(threshold));
    ASSERT_GE(threshold, last) << cd_m2;
    ASSERT_LT(threshold, 1.02 * last) << cd_m2; // 1.2 % a step is Weber's law
    const auto single = static_cast<double>(f32::threshold_illuminance_lux(static_cast<float>(cd_m2), 1.7F));
    ASSERT_NEAR(single / threshold, 1.0, 2.0e-5) << cd_m2;
    last = threshold;
  });
  // Weber's law in the end.
  EXPECT_NEAR(f64::threshold_illuminance_lux(2.0e9, 1.0) / f64::threshold_illuminance_lux(1.0e9, 1.0), 2.0, 0.02);
  EXPECT_DOUBLE_EQ(f64::threshold_illuminance_lux(3.0, 2.0), 2.0 * f64::threshold_illuminance_lux(3.0, 1.0));
}

TEST(MesopicShare, GoesFromDarknessToDayWithoutAStep) {
  EXPECT_EQ(f64::mesopic_cone_share(0.0, 0.0), 0.0);
  EXPECT_EQ(f64::mesopic_cone_share(0.001, 0.0049), 0.0);
  EXPECT_EQ(f64::mesopic_cone_share(5.01, 0.1), 1.0);
  for (const double ratio : {0.05, 0.3, 1.0, 2.3, 8.0}) {
    double last = 0.0;
    over_luminances(50, [&](double cd_m2) {
      const double share = f64::mesopic_cone_share(cd_m2, ratio * cd_m2);
      ASSERT_GE(share, last - 3.0e-4) << ratio << " " << cd_m2;
      // Light that rods hardly see hands over quickly, as CIE 191 has it.
      ASSERT_LT(share, last + (ratio < 0.5 ? 1.0 : 0.03)) << ratio << " " << cd_m2;
      const auto single =
          static_cast<double>(f32::mesopic_cone_share(static_cast<float>(cd_m2), static_cast<float>(ratio * cd_m2)));
      ASSERT_NEAR(single, share, 5.0e-4) << ratio << " " << cd_m2;
      if (share > 0.0 && share < 1.0 && ratio > 0.5) {
        const double seen = f64::mesopic_luminance(cd_m2, ratio * cd_m2, share);
        ASSERT_NEAR(0.7670 + 0.3334 * std::log10(seen), share, 3.0e-4);
      }
      last = share;
    });
  }
}

TEST(SeenColor, KeepsColoursByDayAndLosesThemAtNight) {
  const f64::vec4 grey(0.9505, 1.0, 1.0891, 2.47);
  const f64::vec4 red(0.4124, 0.2126, 0.0193, 0.1);
  for (const double level : {5.0, 50.0, 1.0e4, 2.0e9}) {
    const f64::vec3 day = f64::seen_color(level * grey, f64::mesopic_cone_share(level, level * grey.w));
    EXPECT_NEAR(day.x / (day.x + day.y + day.z), 0.3127, 0.001);
    EXPECT_NEAR(day.y / (day.x + day.y + day.z), 0.3290, 0.001);
    EXPECT_NEAR(day.y / level, 1.0, 1.0e-6);
  }
  const f64::vec3 night = f64::seen_color(1.0e-4 * red, 0.0);
  // On the line from white (0.3127, 0.3290) to the mean of moonlit paintings (0.25, 0.25), 0.6 of the way.
  EXPECT_NEAR(night.x / (night.x + night.y + night.z), 0.3127 - 0.6 * 0.0627, 0.001);
  EXPECT_NEAR(night.y / (night.x + night.y + night.z), 0.3290 - 0.6 * 0.0790, 0.001);
  EXPECT_DOUBLE_EQ(night.y, 1.0e-4 * red.w);
  // Purkinje: of a red and a blue of one photopic luminance, the blue is the brighter in the dark.
  const f64::vec4 blue(0.1805, 0.0722, 0.9505, 0.8);
  EXPECT_GT((f64::seen_color(blue / blue.y, 0.2)).y, (f64::seen_color(red / red.y, 0.2)).y);
  EXPECT_EQ(f64::seen_color(f64::vec4(0.0), 0.5), f64::vec3(0.0));
}

TEST(SeenLight, OfAUsualStarIsItsPhotopicLight) {
  for (const double share : {0.0, 0.3, 1.0}) {
    EXPECT_NEAR(f64::seen_light(2.0, 2.0 * f64::usual_star_sp_ratio, share), 2.0, 1.0e-12);
  }
  EXPECT_LT(f64::seen_light(1.0, 0.2, 0.0), 0.1); // low-pressure sodium
  EXPECT_EQ(f64::seen_light(1.0, 0.2, 1.0), 1.0);
}

template <class Real> void expect_sound_thompson() {
  using Vec3 = std::conditional_t<std::is_same_v<Real, float>, f32::vec3, f64::vec3>;
  const auto scotopic = [](const Vec3& xyz) {
    if constexpr (std::is_same_v<Real, float>) {
      return f32::cheap_scotopic_luminance(xyz);
    } else {
      return f64::cheap_scotopic_luminance(xyz);
    }
  };
  const Real zero(0);
  const Real one(1);
  EXPECT_EQ(scotopic(Vec3(zero)), zero);
  EXPECT_NEAR(static_cast<double>(scotopic(Vec3(zero, one, one))), 7.6, 0.01); // the pole
  EXPECT_NEAR(static_cast<double>(scotopic(Vec3(Real(1.0e-30), one, zero))), 7.6, 0.01);
  EXPECT_EQ(scotopic(Vec3(one, Real(0.1), zero)), zero); // deep red
  EXPECT_EQ(scotopic(Vec3(Real(-1), Real(-2), Real(-3))), zero);
  // Where it is neither: the formula itself, for daylight.
  EXPECT_NEAR(static_cast<double>(scotopic(Vec3(Real(0.9505), one, Real(1.0891)))),
              1.33 * (1.0 + 2.0891 / 0.9505) - 1.68, 1.0e-5);
}

TEST(Thompson, HasNoPole) {
  expect_sound_thompson<float>();
  expect_sound_thompson<double>();
}

TEST(Thompson, IsNightBelowAndDayAbove) {
  const f64::vec3 dim(0.009505, 0.01, 0.010891);
  const double v = f64::cheap_scotopic_luminance(dim);
  const f64::vec3 night = f64::thompson_night(dim, 0.002, 0.02, 0.2);
  EXPECT_NEAR(night.y, v + 0.002, 1.0e-12);
  EXPECT_GT(night.z / night.x, dim.z / dim.x); // bluish
  EXPECT_EQ(f64::thompson_night(20.0 * dim, 0.002, 0.02, 0.2), 20.0 * dim);
  const f64::vec3 half = f64::thompson_night(11.0 * dim, 0.0, 0.02, 0.2);
  EXPECT_NEAR(half.y, 0.5 * (11.0 * dim.y + 11.0 * v), 1.0e-12);
  EXPECT_GE(f64::thompson_night(dim, -1.0, 0.02, 0.2).y, 0.0);
  // Borders that fall together switch.
  EXPECT_EQ(f64::thompson_night(dim, 0.0, 0.005, 0.005), dim);
}

TEST(Thresholds, AreThoseOfThePapers) {
  // Ferwerda et al. 1996: plateaus and the straight ends.
  EXPECT_NEAR(std::log10(f64::cone_threshold_cd_m2(1.0e-6)), -0.72, 1.0e-9);
  EXPECT_NEAR(std::log10(f64::cone_threshold_cd_m2(1.0e4)), 4.0 - 1.255, 1.0e-9);
  EXPECT_NEAR(std::log10(f64::rod_threshold_cd_m2(1.0e-6)), -2.86, 1.0e-9);
  EXPECT_NEAR(std::log10(f64::rod_threshold_cd_m2(1.0)), -0.395, 1.0e-9);
  // Larson, Rushmeier and Piatko 1997 change over at 10^-0.0184 cd/m2.
  EXPECT_NEAR(std::log10(f64::cone_threshold_cd_m2(std::pow(10.0, -0.0184)) /
                         f64::rod_threshold_cd_m2(std::pow(10.0, -0.0184))),
              0.0, 0.001);
  double last = 0.0;
  over_luminances(100, [&](double cd_m2) {
    const double step = f64::just_noticeable_cd_m2(cd_m2);
    ASSERT_TRUE(std::isfinite(step));
    ASSERT_GE(step, 0.995 * last) << cd_m2; // the printed digits of the pieces
    ASSERT_LT(last == 0.0 ? 0.0 : step / last, 1.04) << cd_m2;
    ASSERT_NEAR(static_cast<double>(f32::just_noticeable_cd_m2(static_cast<float>(cd_m2))) / step, 1.0, 5.0e-4);
    last = step;
  });
}

TEST(Acuity, IsShlaers) {
  // "About 50 cycles per degree" by day and two near the end of vision (Larson et al. 1997).
  EXPECT_NEAR(f64::acuity_cycles_per_degree(1.0e3), 50.0, 1.5);
  EXPECT_NEAR(f64::acuity_cycles_per_degree(1.0e-4), 2.0, 0.2);
  EXPECT_GT(f64::acuity_cycles_per_degree(0.0), 1.0);
  double last = 0.0;
  over_luminances(20, [&](double cd_m2) {
    const double acuity = f64::acuity_cycles_per_degree(cd_m2);
    ASSERT_GE(acuity, last);
    last = acuity;
  });
  EXPECT_LT(last, 53.0);
}

TEST(Grain, IsAThresholdInTheDarkAndGoneByDay) {
  EXPECT_EQ(f64::visual_noise_cd_m2(100.0, 1.0), 0.0);
  EXPECT_NEAR(f64::visual_noise_cd_m2(0.01, 0.0), f64::rod_threshold_cd_m2(0.01), 1.0e-12);
  EXPECT_EQ(f64::visual_noise_cd_m2(0.0, 0.0), 0.0);
}

TEST(Adaptation, AddsUpInStepsOfAnyLength) {
  const f64::vec2 day(3000.0, 7000.0);
  const f64::vec2 night(2.0e-4, 4.0e-4);
  const f64::vec2 at_once = f64::adapted(night, day, 600.0);
  f64::vec2 in_steps = day;
  for (const double dt : {0.01, 99.99, 400.0, 0.0, 100.0}) {
    in_steps = f64::adapted(night, in_steps, dt);
  }
  EXPECT_NEAR(in_steps.x / at_once.x, 1.0, 1.0e-9);
  EXPECT_NEAR(in_steps.y / at_once.y, 1.0, 1.0e-9);
  EXPECT_NEAR(f64::adapted(night, day, 0.0).x, day.x, 1.0e-9);
}

TEST(Adaptation, TakesSecondsToLightAndMinutesToDarkness) {
  const f64::vec2 day(3000.0, 7000.0);
  const f64::vec2 night(2.0e-4, 4.0e-4);
  const f64::vec2 lit = f64::adapted(day, night, 3.0);
  EXPECT_NEAR(lit.x / day.x, 1.0, 0.01);
  EXPECT_NEAR(lit.y / day.y, 1.0, 0.01);
  // Cones are done in 8 to 10 minutes, rods in half an hour and more.
  EXPECT_LT(std::log10(f64::adapted(night, day, 600.0).x / night.x), 0.1);
  EXPECT_GT(std::log10(f64::adapted(night, day, 600.0).y / night.y), 1.0);
  EXPECT_LT(std::log10(f64::adapted(night, day, 2400.0).y / night.y), 0.1);
  EXPECT_TRUE(std::isfinite(f64::adapted(f64::vec2(0.0), day, 1.0e9).y));
  EXPECT_NEAR(f64::adapted(f64::vec2(0.0), day, 1.0e9).y, 1.0e-5, 1.0e-9);
}

} // namespace
} // namespace vesper
