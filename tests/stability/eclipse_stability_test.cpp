// Eclipses where formulas like to break: straight lines, tangent and concentric discs, points, poles, far years.
#include "support/truth.hpp"

#include "vesper/astro/local_solar_eclipse.hpp"
#include "vesper/astro/lunar_eclipse.hpp"
#include "vesper/astro/spherical.hpp"
#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace vesper {
namespace {

using test::ErrorSum;

/// The common area of two discs over the first one's, by adding up chords (midpoint rule in the angle).
double covered_by_chords(double radius, double other, double separation) {
  constexpr int steps = 200000;
  double area = 0.0;
  for (int i = 0; i < steps; ++i) {
    // Chords across the line of centres; x = -radius cos(angle) crowds them at the limb.
    const double angle = (i + 0.5) * std::numbers::pi / steps;
    const double x = -radius * std::cos(angle);
    const double half = radius * std::sin(angle);
    const double left = other * other - (x - separation) * (x - separation);
    area += 2.0 * std::min(half, std::sqrt(std::max(left, 0.0))) * half * std::numbers::pi / steps;
  }
  return area / (std::numbers::pi * radius * radius);
}

TEST(DiscCovered, MatchesTheAreaByChords) {
  ErrorSum errors;
  ErrorSum single;
  for (const double other : {0.05, 0.5, 0.98, 1.0, 1.02, 3.67, 40.0}) {
    for (int i = 0; i <= 40; ++i) {
      const double separation = (other + 1.05) * i / 40.0;
      const double expected = covered_by_chords(1.0, other, separation);
      errors.add(f64::disc_covered(1.0, other, separation) - expected);
      single.add(
          static_cast<double>(f32::disc_covered(1.0F, static_cast<float>(other), static_cast<float>(separation))) -
          expected);
    }
  }
  errors.print("covered share against chords", "");
  single.print("the same in single precision", "");
  EXPECT_LT(errors.worst(), 1e-7);
  EXPECT_LT(single.worst(), 4e-6);
}

TEST(DiscCovered, HoldsAtTangencyConcentricityAndForPoints) {
  EXPECT_EQ(f64::disc_covered(1.0, 1.0, 0.0), 1.0);
  EXPECT_EQ(f64::disc_covered(1.0, 2.0, 0.5), 1.0);
  EXPECT_EQ(f64::disc_covered(2.0, 1.0, 0.5), 0.25);
  EXPECT_EQ(f64::disc_covered(2.0, 1.0, 1.0), 0.25);
  EXPECT_EQ(f64::disc_covered(1.0, 1.0, 2.0), 0.0);
  EXPECT_EQ(f64::disc_covered(1.0, 1.0, 3.0), 0.0);
  EXPECT_EQ(f64::disc_covered(0.0, 1.0, 0.5), 1.0); // a star behind the Moon
  EXPECT_EQ(f64::disc_covered(0.0, 1.0, 1.5), 0.0);
  EXPECT_EQ(f64::disc_covered(1.0, 0.0, 0.5), 0.0);
  EXPECT_EQ(f64::disc_covered(0.0, 0.0, 0.0), 0.0);
  // The first bite is (4/3 pi) sqrt(2 h^3 r1 r2/(r1 + r2)) over r1^2: a depth h of 1e-10 must not drown in rounding.
  for (const double depth : {1e-4, 1e-7, 1e-10}) {
    const double bite = 4.0 / (3.0 * std::numbers::pi) * std::sqrt(2.0 * depth * depth * depth * 0.5);
    EXPECT_NEAR(f64::disc_covered(1.0, 1.0, 2.0 - depth) / bite, 1.0, 1e-4) << depth;
  }
}

template <class Covered> void expect_smooth(Covered covered, double tolerance) {
  for (const double other : {0.9, 1.0, 1.1}) {
    double before = covered(other, 0.0);
    for (int i = 1; i <= 20000; ++i) {
      const double now = covered(other, 2.2 * i / 20000.0);
      ASSERT_LE(now, before + tolerance);
      ASSERT_LT(before - now, 2e-4); // no step: the slope is below 2/pi
      before = now;
    }
    ASSERT_EQ(before, 0.0);
  }
}

TEST(DiscCovered, FallsSmoothlyWithTheSeparation) {
  expect_smooth([](double other, double separation) { return f64::disc_covered(1.0, other, separation); }, 1e-14);
  expect_smooth(
      [](double other, double separation) {
        return static_cast<double>(f32::disc_covered(1.0F, static_cast<float>(other), static_cast<float>(separation)));
      },
      3e-6);
}

/// Share of the Sun's disc that is seen past the Earth from a point outside it (km, from the Earth's centre).
double sunlight_past_earth(const Vec3& point_km, const f64::EarthShadow& shadow) {
  const Vec3 to_sun = -shadow.sun_distance_km * shadow.axis - point_km;
  return 1.0 - f64::disc_covered(std::asin(shadow.sun_radius_km / glm::length(to_sun)),
                                 std::asin(shadow.edge_radius_km / glm::length(point_km)),
                                 angle_between(to_sun, -point_km).to(rad));
}

TEST(EarthShadow, SunlightEndsAtTheConesEdges) {
  const LunarEclipse eclipse = lunar_eclipse_near(parse_instant("2026-03-03T12:00:00Z"));
  const LunarEclipseState state = lunar_eclipse_state(apparent_sun_moon(eclipse.greatest.tt));
  const f64::EarthShadow shadow = earth_shadow(state);
  const Vec3 across = glm::normalize(glm::cross(state.axis, Vec3(0.3, 0.2, 0.9)));
  for (const double along : {10000.0, 384400.0, 1.2e6}) {
    const f64::vec2 radii = f64::earth_shadow_radii_km(along, shadow);
    const auto light = [&](double distance) {
      return sunlight_past_earth(along * state.axis + distance * across, shadow);
    };
    EXPECT_EQ(light(0.0), 0.0);
    EXPECT_EQ(light(radii.x - 2.0), 0.0) << along;
    EXPECT_GT(light(radii.x + 2.0), 0.0) << along;
    EXPECT_LT(light(radii.y - 2.0), 1.0) << along;
    EXPECT_EQ(light(radii.y + 2.0), 1.0) << along;
    double before = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      const double now = light(radii.x + 0.001 * i * (radii.y - radii.x));
      ASSERT_GE(now, before);
      ASSERT_LT(now - before, 0.003);
      before = now;
    }
  }
  // Beyond the umbra's tip the Earth hides part of the Sun; before the Earth, nothing.
  const double beyond = sunlight_past_earth(2.0e6 * state.axis, shadow);
  EXPECT_GT(beyond, 0.1);
  EXPECT_LT(beyond, 0.9);
  EXPECT_EQ(sunlight_past_earth(-384400.0 * state.axis, shadow), 1.0);
  // The cones at the Moon are the state's radii.
  const double moon_km = glm::length(state.moon_km);
  const f64::vec2 at_moon = f64::earth_shadow_radii_km(moon_km, shadow);
  EXPECT_NEAR(at_moon.x / moon_km / state.umbra_radius.to(rad), 1.0, 2e-4);
  EXPECT_NEAR(at_moon.y / moon_km / state.penumbra_radius.to(rad), 1.0, 2e-4);
}

constexpr double au_km = astronomical_unit.to(kilometre);

TEST(LunarEclipseState, HoldsInLineWithTheSunOnEitherSide) {
  const LunarEclipseState full = lunar_eclipse_state({Vec3(au_km, 0.0, 0.0), Vec3(-384400.0, 0.0, 0.0)});
  EXPECT_EQ(full.axis_distance.to(rad), 0.0);
  // By hand: parallax 3422.5", umbra 1.01 x 3422.5 + 8.79 - 959.63, Moon 932.7".
  EXPECT_NEAR(full.umbral_magnitude, (2505.9 + 932.7) / (2.0 * 932.7), 0.0003);
  const LunarEclipseState new_moon = lunar_eclipse_state({Vec3(au_km, 0.0, 0.0), Vec3(384400.0, 0.0, 0.0)});
  EXPECT_NEAR(new_moon.axis_distance.to(deg), 180.0, 1e-12);
  EXPECT_LT(new_moon.penumbral_magnitude, -300.0);
  // Without a step through the axis: the magnitude has a peak there and falls by the same either way.
  const auto off = [](double angle) {
    return lunar_eclipse_state({Vec3(au_km, 0.0, 0.0), 384400.0 * Vec3(-std::cos(angle), std::sin(angle), 0.0)});
  };
  EXPECT_NEAR(off(1e-9).umbral_magnitude, off(-1e-9).umbral_magnitude, 1e-12);
  EXPECT_NEAR(off(1e-9).umbral_magnitude, full.umbral_magnitude, 1e-6);
}

TEST(LunarEclipseState, IsSmoothOverAMonthAndAMicrosecond) {
  const Instant start = parse_instant("2026-03-01");
  double before = lunar_eclipse_state(apparent_sun_moon(start.tt)).umbral_magnitude;
  for (int hour = 1; hour < 30 * 24; ++hour) {
    const Instant now = later(start, hour * 3600.0);
    const LunarEclipseState state = lunar_eclipse_state(apparent_sun_moon(now.tt));
    ASSERT_LT(std::abs(state.umbral_magnitude - before), 1.5);
    ASSERT_GT(state.penumbral_magnitude, state.umbral_magnitude);
    before = state.umbral_magnitude;
    const double next = lunar_eclipse_state(apparent_sun_moon(later(now, 1e-6).tt)).umbral_magnitude;
    ASSERT_LT(std::abs(next - before), 1e-8);
  }
}

TEST(SolarEclipseState, HoldsForDiscsInLine) {
  const Vec3 sun(0.0, au_km, 0.0);
  const SolarEclipseState total = solar_eclipse_state(sun, Vec3(0.0, 360000.0, 0.0));
  EXPECT_EQ(total.separation.to(rad), 0.0);
  EXPECT_EQ(total.obscuration, 1.0);
  EXPECT_GT(total.magnitude, 1.0);
  const SolarEclipseState annular = solar_eclipse_state(sun, Vec3(0.0, 400000.0, 0.0));
  const double ratio = annular.moon_semidiameter / annular.sun_semidiameter;
  EXPECT_NEAR(annular.obscuration, ratio * ratio, 1e-14);
  EXPECT_NEAR(annular.magnitude, 0.5 * (1.0 + ratio), 1e-14);
  const SolarEclipseState opposite = solar_eclipse_state(sun, Vec3(0.0, -400000.0, 0.0));
  EXPECT_EQ(opposite.obscuration, 0.0);
  EXPECT_LT(opposite.magnitude, -300.0);
}

void expect_ordered(const LocalSolarEclipse& local) {
  const auto& [c1, c2, c3, c4] = local.contacts;
  const bool inner = local.type == SolarEclipseType::total || local.type == SolarEclipseType::annular;
  EXPECT_EQ(c1.has_value() && c4.has_value(), local.type != SolarEclipseType::none);
  EXPECT_EQ(c2.has_value() && c3.has_value(), inner);
  if (c1 && c4) {
    EXPECT_LT(test::seconds_between(c1->instant, local.maximum.instant), 0.0);
    EXPECT_GT(test::seconds_between(c4->instant, local.maximum.instant), 0.0);
    EXPECT_LT(test::seconds_between(c4->instant, c1->instant), 4.5 * 3600.0);
  }
  if (c2 && c3) {
    EXPECT_LE(test::seconds_between(c2->instant, local.maximum.instant), 0.0);
    EXPECT_GE(test::seconds_between(c3->instant, local.maximum.instant), 0.0);
    EXPECT_LT(test::seconds_between(c1->instant, c2->instant), 0.0);
    EXPECT_GT(test::seconds_between(c4->instant, c3->instant), 0.0);
  }
  EXPECT_TRUE(local.state.obscuration >= 0.0 && local.state.obscuration <= 1.0);
  EXPECT_TRUE(local.position_angle.to(deg) >= 0.0 && local.position_angle.to(deg) <= 360.0);
  EXPECT_TRUE(std::isfinite(local.state.magnitude));
  EXPECT_LE(std::abs(local.maximum.sun_altitude.to(deg)), 90.0);
}

TEST(LocalSolarEclipse, HoldsAtPolesDateLineAndHeights) {
  for (const char* time : {"-2000-01-01", "0000-06-01", "1961-02-15", "2026-08-12", "2021-06-10", "9998-01-01"}) {
    const SolarEclipse eclipse = solar_eclipses(parse_instant(time), later(parse_instant(time), 400 * 86400.0)).front();
    for (const double latitude : {-90.0, -89.9999, -45.0, 0.0, 45.0, 89.9999, 90.0}) {
      SCOPED_TRACE(std::string(time) + " " + std::to_string(latitude));
      for (const double height : {-400.0, 9000.0}) {
        const LocalSolarEclipse east =
            local_solar_eclipse(eclipse.greatest, {latitude * deg, 180.0 * deg, height * metre});
        const LocalSolarEclipse west =
            local_solar_eclipse(eclipse.greatest, {latitude * deg, -180.0 * deg, height * metre});
        expect_ordered(east);
        EXPECT_EQ(east.type, west.type);
        EXPECT_NEAR(test::seconds_between(east.maximum.instant, west.maximum.instant), 0.0, 1e-3);
        EXPECT_NEAR(east.state.magnitude, west.state.magnitude, 1e-9);
      }
    }
    // At the place of greatest eclipse there is one, at that instant or close to it.
    const LocalSolarEclipse there = local_solar_eclipse(eclipse.greatest, eclipse.place);
    EXPECT_NE(there.type, SolarEclipseType::none) << time;
    EXPECT_LT(std::abs(test::seconds_between(there.maximum.instant, eclipse.greatest)), 120.0) << time;
  }
}

TEST(LocalSolarEclipse, TotalityShrinksToNothingAtThePathsEdge) {
  // From south of Dallas towards the edge of 2024 April 8 in steps of some 200 m.
  const Instant greatest = parse_instant("2024-04-08T18:17:00Z");
  double before = 1e9;
  int total = 0;
  int partial = 0;
  for (double latitude = 32.0; latitude > 30.7; latitude -= 0.002) {
    const LocalSolarEclipse local = local_solar_eclipse(greatest, {latitude * deg, -96.8 * deg, 100.0 * metre});
    expect_ordered(local);
    if (local.type == SolarEclipseType::total) {
      ASSERT_EQ(partial, 0);
      const double lasts = test::seconds_between(local.contacts[2]->instant, local.contacts[1]->instant);
      ASSERT_LT(lasts, before);
      before = lasts;
      ++total;
    } else {
      ++partial;
    }
  }
  EXPECT_GT(total, 10);
  EXPECT_GT(partial, 10);
  EXPECT_LT(before, 20.0);
}

TEST(EclipseSearch, HoldsInFarYears) {
  for (const char* time : {"-4712-01-02", "-3000-01-01", "0000-01-01", "1582-10-01", "2060-01-01", "9979-01-01"}) {
    const Instant from = parse_instant(time);
    const Instant to = later(from, 20.0 * 365.25 * 86400.0);
    const std::vector<LunarEclipse> lunar = lunar_eclipses(from, to);
    const std::vector<SolarEclipse> solar = solar_eclipses(from, to);
    std::printf("20 years from %s: %zu lunar eclipses, %zu solar\n", time, lunar.size(), solar.size());
    // Two to five of each a year; over the canons' centuries 2.2 to 2.7.
    EXPECT_TRUE(lunar.size() >= 40 && lunar.size() <= 60) << time;
    EXPECT_TRUE(solar.size() >= 40 && solar.size() <= 60) << time;
    for (std::size_t i = 1; i < solar.size(); ++i) {
      EXPECT_GT(test::seconds_between(solar[i].greatest, solar[i - 1].greatest), 29.0 * 86400.0);
    }
    for (std::size_t i = 0; i < lunar.size(); ++i) {
      EXPECT_TRUE(i == 0 || test::seconds_between(lunar[i].greatest, lunar[i - 1].greatest) > 29.0 * 86400.0);
      const Instant* previous = nullptr;
      for (const std::optional<Instant>& contact : lunar[i].contacts) {
        if (contact) {
          EXPECT_TRUE(previous == nullptr || test::seconds_between(*contact, *previous) > 0.0);
          previous = &*contact;
        }
      }
      ASSERT_NE(previous, nullptr);
      EXPECT_LT(test::seconds_between(*previous, *lunar[i].contact(LunarContact::p1)), 6.6 * 3600.0);
    }
  }
}

TEST(EclipseSearch, ASpanIsTheSumOfItsParts) {
  const Instant from = parse_instant("2020-01-01");
  const Instant to = parse_instant("2026-01-01");
  const std::vector<LunarEclipse> whole = lunar_eclipses(from, to);
  std::size_t lunar = 0;
  std::size_t solar = 0;
  // Cut also exactly at an eclipse: it belongs to the later part.
  std::vector<Instant> cuts{from, whole[4].greatest, parse_instant("2023-01-01"), to};
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    lunar += lunar_eclipses(cuts[i - 1], cuts[i]).size();
    solar += solar_eclipses(cuts[i - 1], cuts[i]).size();
  }
  EXPECT_EQ(lunar, whole.size());
  EXPECT_EQ(solar, solar_eclipses(from, to).size());
  EXPECT_TRUE(lunar_eclipses(from, from).empty());
}

TEST(SkyState, CarriesBothEclipses) {
  const SkyState sky = sky_state(parse_instant("2026-08-12T18:29:18Z"), {42.3439 * deg, -3.6969 * deg, 860.0 * metre});
  EXPECT_EQ(sky.solar_eclipse.obscuration, 1.0);
  EXPECT_NEAR(sky.solar_eclipse.magnitude, 1.01378, 0.0002);
  EXPECT_LT(sky.lunar_eclipse.penumbral_magnitude, -300.0);
  // What the sky says of itself is what the search says of the place.
  const LocalSolarEclipse local = local_solar_eclipse(sky.instant, sky.observer);
  const SkyState at_maximum = sky_state(local.maximum.instant, sky.observer);
  EXPECT_NEAR(at_maximum.solar_eclipse.magnitude, local.state.magnitude, 1e-7);
  EXPECT_NEAR(at_maximum.sun.altitude.to(arcsec), local.maximum.sun_altitude.to(arcsec), 0.5);
}

} // namespace
} // namespace vesper
