#include "report/scene_text.hpp"
#include "report/sky_figures.hpp"

#include "vesper/assets/default_stars.hpp"
#include "vesper/base/vector.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace vesper {
namespace {

TEST(ReportText, CompassPointsGoRound) {
  EXPECT_EQ(compass_point(0.0 * deg), "N");
  EXPECT_EQ(compass_point(11.2 * deg), "N");
  EXPECT_EQ(compass_point(11.3 * deg), "NNE");
  EXPECT_EQ(compass_point(90.0 * deg), "E");
  EXPECT_EQ(compass_point(225.0 * deg), "SW");
  EXPECT_EQ(compass_point(348.8 * deg), "N");
  EXPECT_EQ(compass_point(-90.0 * deg), "W");
}

TEST(ReportText, SkyConditionsChangeAtTheTwilightBorders) {
  EXPECT_EQ(sky_condition(-0.8 * deg), "day");
  EXPECT_EQ(sky_condition(-0.9 * deg), "civil twilight");
  EXPECT_EQ(sky_condition(-6.1 * deg), "nautical twilight");
  EXPECT_EQ(sky_condition(-12.1 * deg), "astronomical twilight");
  EXPECT_EQ(sky_condition(-18.1 * deg), "night");
}

TEST(ReportText, ALowSunHasAnApparentAltitude) {
  // Sunset at Greenwich: airless 0.55 degrees below, seen on the horizon under ordinary air.
  SkyState sky = sky_state(parse_instant("2026-03-20T18:14:00Z"), {51.4769 * deg, 0.0 * deg, 0.0 * metre});
  const double altitude = sky.sun.altitude.to(deg);
  ASSERT_GT(altitude, -2.0);
  ASSERT_LT(altitude, 0.0);
  const auto sun_line = [&] {
    const std::string text = scene_text(sky, default_star_catalogue(), {}, {});
    const std::size_t at = text.find("Sun ");
    return text.substr(at, text.find('\n', at) - at);
  };
  const std::string with_air = sun_line();
  const std::size_t at = with_air.find("apparent altitude ");
  ASSERT_NE(at, std::string::npos) << with_air;
  // 0.5 to 0.7 degrees at and just below the horizon.
  const double raised = std::stod(with_air.substr(at + 18)) - altitude;
  EXPECT_GT(raised, 0.45);
  EXPECT_LT(raised, 0.75);
  sky.refraction = Refraction{};
  EXPECT_EQ(sun_line().find("apparent"), std::string::npos);
  sky = sky_state(parse_instant("2026-03-20T23:00:00Z"), sky.observer);
  EXPECT_EQ(sun_line().find("apparent"), std::string::npos);
}

TEST(ReportText, ItIsNotDayInTotality) {
  const Observer burgos{42.34 * deg, -3.70 * deg, 860.0 * metre};
  const auto text_at = [&](const char* stamp) {
    return scene_text(sky_state(parse_instant(stamp), burgos), default_star_catalogue(), {}, {}, std::nullopt);
  };
  const std::string totality = text_at("2026-08-12T18:29:30Z");
  EXPECT_NE(totality.find("Sky     dark in a total eclipse of the Sun"), std::string::npos) << totality;
  EXPECT_NE(text_at("2026-08-12T18:00:00Z").find("Sky     day"), std::string::npos);
}

TEST(ReportText, StarsThatTheSkyOutshinesAreSaidToBeTooFaint) {
  const SkyState sky = sky_state(parse_instant("2026-08-12T22:00:00Z"), {42.34 * deg, -3.70 * deg, 860.0 * metre});
  const auto too_faint = [&](std::optional<double> limit) {
    return scene_text(sky, default_star_catalogue(), {}, {}, limit).find("too faint to be seen") != std::string::npos;
  };
  EXPECT_TRUE(too_faint(-3.0));
  EXPECT_FALSE(too_faint(6.0));
  EXPECT_FALSE(too_faint(std::nullopt));
}

TEST(ReportText, MoonPhasesHaveTheirNames) {
  EXPECT_EQ(moon_phase_name(0.01, true), "new Moon");
  EXPECT_EQ(moon_phase_name(0.3, true), "waxing crescent");
  EXPECT_EQ(moon_phase_name(0.5, false), "last quarter");
  EXPECT_EQ(moon_phase_name(0.8, false), "waning gibbous");
  EXPECT_EQ(moon_phase_name(0.99, true), "full Moon");
}

/// The catalogue's entry of a number, nullptr if it has none.
const StarRecord* record_of(std::uint32_t hr) {
  const StarCatalogue& catalogue = default_star_catalogue();
  const auto found = std::find_if(catalogue.identities.begin(), catalogue.identities.end(),
                                  [&](const StarIdentity& star) { return star.hr == hr; });
  return found == catalogue.identities.end()
             ? nullptr
             : &catalogue.stars[static_cast<std::size_t>(found - catalogue.identities.begin())];
}

TEST(SkyFigures, AreBrightStarsOfOneCorner) {
  const double limit_lux = 2.54e-6 * 0.01; // fifth magnitude
  for (const SkyFigure& figure : sky_figures()) {
    const StarRecord* first = record_of(figure.stars.front());
    ASSERT_NE(first, nullptr) << figure.name;
    for (const std::uint16_t hr : figure.stars) {
      const StarRecord* star = record_of(hr);
      ASSERT_NE(star, nullptr) << figure.name << " HR " << hr;
      EXPECT_GT(static_cast<double>(star->illuminance), limit_lux) << figure.name << " HR " << hr;
      const Vec3 a(first->position[0], first->position[1], first->position[2]);
      const Vec3 b(star->position[0], star->position[1], star->position[2]);
      EXPECT_GT(glm::dot(a, b), 0.88) << figure.name << " HR " << hr; // 28 degrees
    }
  }
}

TEST(SkyFigures, NamedStarsAreBright) {
  for (const NamedStar& named : named_stars()) {
    const StarRecord* star = record_of(named.hr);
    ASSERT_NE(star, nullptr) << named.name;
    EXPECT_GT(static_cast<double>(star->illuminance), 2.54e-6 * 0.063) << named.name; // magnitude 3
  }
  EXPECT_EQ(proper_name(7001), "Vega");
  EXPECT_EQ(proper_name(1), "");
}

} // namespace
} // namespace vesper
