// What hides a star, in skies made by hand.
#include "vesper/sky/star_visibility.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vesper {
namespace {

const Vec4 night(0.0, 2.0e-4, 0.0, 4.0e-4);

StarView star_of(double magnitude, double share = 0.8) {
  return {magnitude, 40.0 * deg, usual_star(Vec4(share)), usual_star(Vec4(0.8))};
}

Hidden hidden_of(const StarView& star, const SkyBackground& sky, Angle sun = -30.0 * deg) {
  return star_sight(star, sky, sun, 0.0 * deg).hidden;
}

TEST(StarSight, TellsWhatHidesAStar) {
  SkyBackground sky;
  sky.airglow = night;
  EXPECT_EQ(hidden_of(star_of(5.0), sky), Hidden::no);
  EXPECT_EQ(hidden_of(star_of(7.5), sky), Hidden::too_faint);
  EXPECT_EQ(hidden_of(star_of(5.0, 0.1), sky), Hidden::low_in_the_air);

  SkyBackground lit = sky;
  lit.sun = 1.0e4 * night;
  EXPECT_EQ(hidden_of(star_of(5.0), lit, -5.0 * deg), Hidden::by_twilight);
  EXPECT_EQ(hidden_of(star_of(5.0), lit, 5.0 * deg), Hidden::by_daylight);
  EXPECT_EQ(hidden_of(star_of(7.5), lit, 5.0 * deg), Hidden::too_faint);
  EXPECT_EQ(hidden_of(star_of(5.0, 0.1), lit, 5.0 * deg), Hidden::by_daylight); // low too, but what matters
  lit = sky;
  lit.moon = 100.0 * night;
  EXPECT_EQ(hidden_of(star_of(5.8), lit), Hidden::by_moonlight);
  // Of two, each of which hides it, the brighter.
  lit.sky_glow = 50.0 * night;
  EXPECT_EQ(hidden_of(star_of(5.8), lit), Hidden::by_moonlight);
  lit.sky_glow = 200.0 * night;
  EXPECT_EQ(hidden_of(star_of(5.8), lit), Hidden::by_sky_glow);
  lit.moon = Vec4(0.0);
  EXPECT_EQ(hidden_of(star_of(5.8), lit), Hidden::by_sky_glow);

  StarView below = star_of(-1.0);
  below.altitude = -0.1 * deg;
  EXPECT_EQ(hidden_of(below, sky), Hidden::below_horizon);
  EXPECT_EQ(star_sight(below, sky, -30.0 * deg, -1.0 * deg).hidden, Hidden::no); // from a mountain
}

TEST(LimitingMagnitude, IsSoundInDarknessAndBeforeTheSun) {
  const StarLight star = usual_star(Vec4(1.0));
  // Without any background: the eye's own darkness.
  EXPECT_NEAR(limiting_magnitude(Vec4(0.0), star), 7.8, 0.05);
  EXPECT_TRUE(std::isfinite(limiting_magnitude(Vec4(2.0e9), star)));
  EXPECT_EQ(limiting_magnitude(night, usual_star(Vec4(0.0))), -HUGE_VAL);
  // A tenth of the light left is two and a half magnitudes.
  EXPECT_NEAR(limiting_magnitude(night, star) - limiting_magnitude(night, usual_star(Vec4(0.1))), 2.5, 1.0e-9);
  // In the dark a star without blue counts for less than its V, by day it does not.
  StarLight red = star;
  red.at_the_eye.w *= 0.5;
  EXPECT_LT(limiting_magnitude(night, red), limiting_magnitude(night, star) - 0.7);
  EXPECT_EQ(limiting_magnitude(1.0e6 * night, red), limiting_magnitude(1.0e6 * night, star));
}

} // namespace
} // namespace vesper
