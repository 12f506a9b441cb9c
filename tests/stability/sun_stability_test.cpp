// The Sun's disc, corona and eclipses where formulas like to break: the limb, tangent and concentric discs, equal ones,
// single precision, directions away from the Sun.
#include "support/truth.hpp"

#include "vesper/base/error.hpp"
#include "vesper/light/corona.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/corona_streamers.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/sun_disc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vesper {
namespace {

using test::ErrorSum;

constexpr std::array laws{LimbDarkening::neckel, LimbDarkening::hestroffer_magnan};

SkyState sky_at(const std::string& time) {
  return sky_state(parse_instant(time), {42.34 * deg, -3.70 * deg, 860.0 * metre});
}

SunDisc sun_of(LimbDarkening law) {
  SunOptions options;
  options.law = law;
  return sun_disc(sky_at("2026-03-01T12:00:00Z"), options);
}

template <class Vec> bool sane(const Vec& light) {
  for (int i = 0; i < 4; ++i) {
    if (!(light[i] >= 0 && light[i] < 1.0e10F)) { // a NaN fails
      return false;
    }
  }
  return true;
}

TEST(SunStability, LimbAndCentreAreThoseOfTheLaw) {
  for (double nm = 300.0; nm <= 1200.0; nm += 20.0) {
    for (const LimbDarkening law : laws) {
      EXPECT_NEAR(solar_limb_darkening(nm, 1.0, law), 1.0, 1e-12);
      EXPECT_GE(solar_limb_darkening(nm, 0.0, law), 0.0);
      double before = -1.0;
      for (double mu = 0.0; mu <= 1.0; mu += 1.0 / 64.0) {
        const double here = solar_limb_darkening(nm, mu, law);
        EXPECT_GE(here, before) << nm << " " << mu; // never darker inward
        before = here;
      }
    }
  }
  EXPECT_EQ(solar_limb_darkening(550.0, 0.0, LimbDarkening::neckel), 0.0);
  EXPECT_EQ(f64::sun_disc_luminance(1.0, sun_of(LimbDarkening::neckel).shading).y, 0.0);
  EXPECT_GT(f64::sun_disc_luminance(1.0, sun_of(LimbDarkening::hestroffer_magnan).shading).y, 4.0e8);
}

TEST(SunStability, SinglePrecisionIsThatOfTheReference) {
  for (const LimbDarkening law : laws) {
    const SunDisc sun = sun_of(law);
    const f32::SunShading single = in_single(sun.shading);
    const double mean = 1.96e9;
    ErrorSum disc;
    ErrorSum corona;
    for (double mu = 1.0; mu > 1.0e-6; mu *= 0.9) {
      const auto r = static_cast<float>(std::sqrt(1.0 - mu * mu));
      const f64::vec4 reference = f64::sun_disc_luminance(static_cast<double>(r), sun.shading);
      const f32::vec4 found = f32::sun_disc_luminance(r, single);
      EXPECT_TRUE(sane(found)) << mu;
      disc.add((static_cast<double>(found.y) - reference.y) / mean);
    }
    for (const float r : {0.0F, 1.0F, std::nextafter(1.0F, 0.0F), std::nextafter(1.0F, 2.0F)}) {
      EXPECT_TRUE(sane(f32::sun_disc_luminance(r, single))) << r;
    }
    disc.hold("disc in single precision", 1.0e-5, "of the mean");

    for (const double r : {1.001, 1.5, 3.0, 20.0, 59.0}) {
      const Vec2 place(0.28 * r, -0.96 * r);
      corona.add(static_cast<double>(f32::corona_luminance(f32::vec2(place), single).y) /
                     f64::corona_luminance(place, sun.shading).y -
                 1.0);
    }
    corona.hold("corona in single precision", 1.0e-4, "");
  }
}

TEST(SunStability, CoronaEndsAndNeverExplodes) {
  const SunDisc sun = sun_of(LimbDarkening::hestroffer_magnan);
  const f32::SunShading single = in_single(sun.shading);
  double before = std::numeric_limits<double>::infinity();
  for (double r = 1.0; r <= 60.0; r += 0.01) {
    const double here = f64::k_corona(r) + f64::f_corona(r);
    EXPECT_LT(here, before);
    before = here;
    EXPECT_TRUE(sane(f32::corona_luminance({static_cast<float>(r), 0.0F}, single))) << r;
  }
  EXPECT_NEAR(f64::k_corona(1.0) + f64::f_corona(1.0), 0.0532 + 1.425 + 2.565, 1e-12);
  for (const float r : {0.0F, 0.999F, 60.1F, 1.0e10F, 1.0e38F}) {
    EXPECT_EQ(f32::corona_luminance({0.0F, r}, single).y, 0.0F) << r;
  }
}

TEST(SunStability, RefusesAnActivityThatIsNone) {
  EXPECT_THROW((void)corona_streamers(-0.01, 0), Error);
  EXPECT_THROW((void)corona_streamers(1.01, 0), Error);
  EXPECT_THROW((void)corona_streamers(std::numeric_limits<double>::quiet_NaN(), 0), Error);
  for (const char* time : {"1900-01-01T00:00:00Z", "2019-12-15T00:00:00Z", "2100-01-01T00:00:00Z"}) {
    const double activity = solar_activity(parse_instant(time));
    EXPECT_GE(activity, 0.0);
    EXPECT_LE(activity, 1.0);
  }
  EXPECT_LT(solar_activity(parse_instant("2019-12-15T00:00:00Z")), 0.01);
}

/// Seconds of arc.
SolarEclipseState discs(double sun, double moon, double separation) {
  SolarEclipseState eclipse;
  eclipse.sun_semidiameter = sun * arcsec;
  eclipse.moon_semidiameter = moon * arcsec;
  eclipse.separation = separation * arcsec;
  return eclipse;
}

TEST(SunStability, EclipsesAreContinuousForAnyDiscs) {
  constexpr double sun = 960.0;
  for (const LimbDarkening law : laws) {
    for (const double moon : {1.0e-3, 480.0, 900.0, 959.999, 960.0, 960.001, 1010.0, 9600.0}) {
      double blue = -1.0;
      double red = -1.0;
      const double end = sun + moon;
      for (int i = 0; i <= 600; ++i) {
        const Spectrum left = sunlight_past_moon(discs(sun, moon, end * i / 590.0), law);
        for (double nm = 360.0; nm <= 830.0; nm += 47.0) {
          EXPECT_GT(left(nm), 0.0) << moon << " " << i; // never without its corona, unless that is covered too
          EXPECT_LT(left(nm), 1.0 + 2.0e-6);
        }
        EXPECT_GT(left(440.0), blue - 2.0e-5) << moon << " " << i;
        EXPECT_GT(left(680.0), red - 2.0e-5) << moon << " " << i;
        blue = left(440.0);
        red = left(680.0);
      }
      EXPECT_NEAR(blue, 1.0, 2.0e-6);
    }
  }
}

TEST(SunStability, EclipsesHoldAtTangency) {
  constexpr double sun = 960.0;
  for (const double moon : {900.0, 960.0, 1000.0}) {
    for (const double tangent : {std::abs(sun - moon), sun + moon}) {
      const double here = sunlight_past_moon(discs(sun, moon, tangent))(550.0);
      for (const double off : {-1.0e-6, 1.0e-6}) {
        const double beside = sunlight_past_moon(discs(sun, moon, std::abs(tangent + off)))(550.0);
        EXPECT_NEAR(beside, here, 1.0e-7) << moon << " " << tangent;
      }
    }
  }
  // Outside of any eclipse the light is the disc's and all of the corona's; a Moon that covers all leaves a corona.
  const double corona = sunlight_past_moon(discs(sun, 1000.0, 20.0))(550.0);
  EXPECT_GT(corona, 5.0e-7);
  EXPECT_LT(corona, 1.5e-6);
  EXPECT_GT(sunlight_past_moon(discs(sun, 1000.0, 648000.0))(550.0), 1.0);
  EXPECT_LT(sunlight_past_moon(discs(sun, 1000.0, 648000.0))(550.0), 1.0 + 1.5e-6);
}

TEST(SunStability, ThinnerCrescentsAreRedder) {
  constexpr double sun = 950.0;
  constexpr double moon = 980.0;
  double before = 0.0;
  for (const double separation : {1500.0, 1000.0, 500.0, 200.0, 100.0, 50.0, 35.0}) {
    const Spectrum left = sunlight_past_moon(discs(sun, moon, separation));
    const double red_over_blue = left(680.0) / left(440.0);
    if (separation < 1500.0) {
      EXPECT_GT(red_over_blue, before) << separation;
    }
    before = red_over_blue;
  }
  EXPECT_GT(before, 1.5);
}

TEST(SunStability, CoronaIsCoveredFromTheInside) {
  double before = std::numeric_limits<double>::infinity();
  for (const double moon : {0.0, 0.5, 0.999, 1.0, 1.001, 1.05, 2.0, 30.0, 59.9, 60.0, 61.0}) {
    const CoronaLight seen = corona_seen(1.0, moon, 0.0);
    EXPECT_LE(seen.electrons + seen.dust, before) << moon;
    EXPECT_GE(seen.dust, 0.0);
    before = seen.electrons + seen.dust;
  }
  EXPECT_EQ(before, 0.0);
  EXPECT_EQ(corona_seen(1.0, 1.0, 100.0).dust, corona_seen(1.0, 0.5, 0.0).dust);
}

} // namespace
} // namespace vesper
