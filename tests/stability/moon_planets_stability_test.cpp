// The Moon and the planets where their angles are undefined or turn fast.
#include "support/truth.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace vesper {
namespace {

void expect_within(Angle angle, double low_deg, double high_deg) {
  EXPECT_TRUE(angle.to(deg) >= low_deg && angle.to(deg) <= high_deg) << angle.to(deg);
}

void expect_sound(const MoonState& moon) {
  expect_within(moon.phase_angle, 0.0, 180.0);
  EXPECT_TRUE(moon.illuminated_fraction >= 0.0 && moon.illuminated_fraction <= 1.0);
  for (const Angle angle : {moon.bright_limb, moon.axis, moon.colongitude}) {
    expect_within(angle, 0.0, 360.0);
    EXPECT_LT(angle, 360.0 * deg);
  }
  expect_within(moon.parallactic, -180.0, 180.0);
  for (const Selenographic& point : {moon.libration, moon.geocentric_libration}) {
    expect_within(point.longitude, -10.0, 10.0);
    expect_within(point.latitude, -10.0, 10.0);
  }
  expect_within(moon.subsolar.longitude, -180.0, 180.0);
  expect_within(moon.subsolar.latitude, -1.7, 1.7);
}

void expect_sound(const PlanetState& planet) {
  expect_within(planet.appearance.phase_angle, 0.0, 180.0);
  EXPECT_TRUE(planet.appearance.illuminated_fraction >= 0.0 && planet.appearance.illuminated_fraction <= 1.0);
  expect_within(planet.appearance.diameter, 1.0 / 3600.0, 70.0 / 3600.0);
  expect_within(planet.bright_limb, 0.0, 360.0);
  EXPECT_TRUE(planet.appearance.magnitude > -5.5 && planet.appearance.magnitude < 12.0) << planet.appearance.magnitude;
  EXPECT_NEAR(glm::length(planet.place.direction_horizon), 1.0, 1e-12);
}

TEST(MoonPlanetsStability, SoundAtPolesAndFarDates) {
  for (const char* time :
       {"1000-01-01", "1582-10-15", "1960-01-01", "2026-12-31T23:59:59Z", "2060-01-01", "3000-01-01"}) {
    for (const double latitude : {-90.0, -89.999999999, 0.0, 90.0}) {
      for (const double longitude : {-180.0, 180.0, 360.0}) {
        for (const double height : {-400.0, 9000.0}) {
          SCOPED_TRACE(std::string(time) + " " + std::to_string(latitude) + " " + std::to_string(longitude));
          const SkyState sky = sky_state(parse_instant(time), {latitude * deg, longitude * deg, height * metre});
          expect_sound(sky.moon);
          for (const PlanetState& planet : sky.planets) {
            expect_sound(planet);
          }
        }
      }
    }
  }
}

TEST(MoonPlanetsStability, AtThePolesTheParallacticAngleIsThatOfThePole) {
  const Instant instant = parse_instant("2026-08-12T22:00:00Z");
  // The zenith is the celestial pole there: north of everything, or south.
  EXPECT_NEAR(sky_state(instant, {90.0 * deg, 0.0 * deg, 0.0 * metre}).moon.parallactic.to(deg), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(sky_state(instant, {-90.0 * deg, 0.0 * deg, 0.0 * metre}).moon.parallactic.to(deg)), 180.0,
              1e-9);
}

class Alignment : public testing::Test {
protected:
  EarthState earth = earth_state(parse_instant("2026-08-12T17:46:00Z"), {45.0 * deg, -25.0 * deg, 0.0 * metre});
  StarFrame frame = star_frame(earth);
  Vec3 moon_au = moon_from_observer_au(earth);
};

TEST_F(Alignment, ExactConjunctionAndOpposition) {
  for (const double sun_at : {400.0, -400.0}) {
    const MoonState moon = moon_state(earth, frame, moon_au, sun_at * moon_au);
    expect_sound(moon);
    EXPECT_NEAR(moon.phase_angle.to(deg), sun_at > 0.0 ? 180.0 : 0.0, 1e-6);
    EXPECT_NEAR(moon.illuminated_fraction, sun_at > 0.0 ? 0.0 : 1.0, 1e-12);
  }
}

TEST_F(Alignment, ZenithAndNadir) {
  const Vec3 zenith = glm::transpose(frame.horizon_from_icrs)[2];
  // Aberration moves them off by 20 arcsec at most: the Moon is put where it cancels, too.
  const BodyPlace shifted = apparent_place(zenith, frame);
  const Vec3 counter = glm::transpose(frame.horizon_from_icrs) * (Vec3(0.0, 0.0, 2.0) - shifted.direction_horizon);
  for (const Vec3& direction : {zenith, -zenith, counter, -counter}) {
    const MoonState moon = moon_state(earth, frame, 0.00257 * glm::normalize(direction), sun_from_observer_au(earth));
    expect_within(moon.parallactic, -180.0, 180.0);
    expect_within(moon.axis, 0.0, 360.0);
    EXPECT_GT(std::abs(moon.place.altitude.to(deg)), 89.98);
  }
}

TEST_F(Alignment, PlanetInFrontOfTheSunAndBehindIt) {
  const Vec3 venus(0.3, 0.0, 0.0);
  const PlanetAppearance front = planet_appearance(Planet::venus, venus, -2.0 * venus, earth.tdb);
  const PlanetAppearance behind = planet_appearance(Planet::venus, 5.0 * venus, 2.0 * venus, earth.tdb);
  EXPECT_EQ(front.phase_angle.to(deg), 180.0);
  EXPECT_NEAR(front.illuminated_fraction, 0.0, 1e-12);
  EXPECT_EQ(behind.phase_angle.to(deg), 0.0);
  EXPECT_EQ(behind.illuminated_fraction, 1.0);
  EXPECT_TRUE(std::isfinite(front.magnitude) && std::isfinite(behind.magnitude));
}

TEST(MoonPlanetsStability, TwoInstantsAMicrosecondApartDifferSmoothly) {
  const Instant instant = parse_instant("2026-08-12T22:00:00Z");
  const Observer observer{50.0 * deg, 10.0 * deg, 100.0 * metre};
  const MoonState before = sky_state(instant, observer).moon;
  const MoonState after = sky_state(later(instant, 1e-6), observer).moon;
  // The Moon turns by 0.5 arcsec a second, the sky above it by 15.
  EXPECT_LT(std::abs((after.libration.longitude - before.libration.longitude).to(arcsec)), 1e-5);
  EXPECT_LT(std::abs((after.axis - before.axis).to(arcsec)), 1e-4);
  EXPECT_LT(std::abs((after.parallactic - before.parallactic).to(arcsec)), 1e-3);
}

} // namespace
} // namespace vesper
