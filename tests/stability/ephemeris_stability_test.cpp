// The embedded ephemeris where its pieces meet: segments, the ends of its span, and steps of a microsecond.
#include "support/truth.hpp"

#include "vesper/astro/ephemeris_series.hpp"
#include "vesper/astro/ephemeris_table.hpp"
#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace vesper {
namespace {

using test::ErrorSum;

constexpr double microsecond_days = 1e-6 / 86400.0;

/// How far a place jumps between two instants beyond its motion, seen from the origin, and its velocity's change.
struct Jump {
  Angle place;
  double velocity_ratio = 0.0;
};

Jump jump(const StateVector& before, const StateVector& after, double days) {
  const Vec3 expected = before.position_au + days * before.velocity_au_d;
  return {test::separation(expected, after.position_au),
          glm::length(after.velocity_au_d - before.velocity_au_d) / glm::length(before.velocity_au_d)};
}

StateVector sun_from_earth(const SunEarthMoon& at) {
  return {at.sun.position_au - at.earth.position_au, at.sun.velocity_au_d - at.earth.velocity_au_d};
}

TEST(EphemerisStability, SegmentsMeet) {
  const EphemerisTable& table = EphemerisTable::embedded();
  ErrorSum moon, moon_velocity, sun, sun_velocity, planets, planets_velocity, nutation, axes;
  // All segments are multiples of 8 days long.
  for (double days = 8.0; table.covers(table.begin().plus_days(days + 1.0)); days += 8.0) {
    const JulianDate<TDB> border{table.begin().day + days, 0.0};
    const JulianDate<TDB> before = border.plus_days(-microsecond_days);
    const SunEarthMoon a = *table.sun_earth_moon(before);
    const SunEarthMoon b = *table.sun_earth_moon(border);
    const Jump moon_jump = jump(a.moon, b.moon, microsecond_days);
    moon.add(moon_jump.place.to(arcsec));
    moon_velocity.add(moon_jump.velocity_ratio);
    const Jump sun_jump = jump(sun_from_earth(a), sun_from_earth(b), microsecond_days);
    sun.add(sun_jump.place.to(arcsec));
    sun_velocity.add(sun_jump.velocity_ratio);
    for (int i = 0; i < planet_count; ++i) {
      const auto planet = static_cast<Planet>(i);
      const Jump planet_jump = jump(*table.planet_heliocentric(planet, before),
                                    *table.planet_heliocentric(planet, border), microsecond_days);
      planets.add(planet_jump.place.to(arcsec));
      planets_velocity.add(planet_jump.velocity_ratio);
    }
    const Nutation n0 = *table.nutation({before.day, before.fraction});
    const Nutation n1 = *table.nutation({border.day, border.fraction});
    nutation.add(
        (std::hypot(n1.longitude_rad - n0.longitude_rad, n1.obliquity_rad - n0.obliquity_rad) * rad).to(arcsec));
    const LunarAngles l0 = *table.lunar_angles(before);
    const LunarAngles l1 = *table.lunar_angles(border);
    axes.add(std::hypot((l1.phi_rad - l0.phi_rad) * rad / arcsec, (l1.theta_rad - l0.theta_rad) * rad / arcsec,
                        test::angle_difference(l1.psi_rad * rad, l0.psi_rad * rad).to(arcsec)));
  }
  moon.print("Moon, step at segment borders", "arcsec");
  moon_velocity.print("Moon, step of velocity", "of itself");
  sun.print("Sun from the Earth, step at segment borders", "arcsec");
  sun_velocity.print("Sun from the Earth, step of velocity", "of itself");
  planets.print("planets, step at segment borders", "arcsec");
  planets_velocity.print("planets, step of velocity", "of themselves");
  nutation.print("nutation, step at segment borders", "arcsec");
  axes.print("Moon's axes, step at segment borders", "arcsec");
  EXPECT_EQ(moon.count(), 4571U);
  EXPECT_LT(moon.worst(), 0.002);
  EXPECT_LT(moon_velocity.worst(), 1e-6);
  EXPECT_LT(sun.worst(), 0.002);
  EXPECT_LT(sun_velocity.worst(), 1e-6);
  EXPECT_LT(planets.worst(), 0.003);
  EXPECT_LT(planets_velocity.worst(), 1e-5);
  EXPECT_LT(nutation.worst(), 0.0001);
  EXPECT_LT(axes.worst(), 0.05);
}

TEST(EphemerisStability, TableAndSeriesMeetAtTheEndsOfTheSpan) {
  const EphemerisTable& table = EphemerisTable::embedded();
  for (const JulianDate<TDB> end : {table.begin(), table.end()}) {
    const SunEarthMoon inside = *table.sun_earth_moon(end);
    const SunEarthMoon outside = sun_earth_moon_series(end);
    ErrorSum moon, moon_km, sun;
    moon.add(test::separation(inside.moon.position_au, outside.moon.position_au).to(arcsec));
    moon_km.add(((glm::length(inside.moon.position_au) - glm::length(outside.moon.position_au)) * astronomical_unit)
                    .to(kilometre));
    sun.add(test::separation(sun_from_earth(inside).position_au, sun_from_earth(outside).position_au).to(arcsec));
    moon.print("Moon, step at an end of the span", "arcsec");
    moon_km.print("Moon's distance, step at an end of the span", "km");
    sun.print("Sun, step at an end of the span", "arcsec");
    EXPECT_LT(moon.worst(), 5.0);
    EXPECT_LT(moon_km.worst(), 15.0);
    EXPECT_LT(sun.worst(), 1.0);
  }
}

/// A microsecond's motion is a millionth of a second's, inside a segment, in every number of the state.
TEST(EphemerisStability, AMicrosecondGivesASmoothDifference) {
  const Observer observer{35.0 * deg, 139.0 * deg, 0.0 * metre};
  const auto direction_after = [&](double seconds, bool moon) {
    // Noon keeps most digits in the fraction; 2026-05-04 12:00 lies inside segments of all series.
    const double days = seconds / 86400.0;
    const SkyState sky = sky_state(instant_from({2461165.0, days}, {2461165.0, days - 69.0 / 86400.0}), observer);
    return moon ? sky.moon.place.direction_horizon : sky.sun.direction_horizon;
  };
  for (const bool moon : {false, true}) {
    const Vec3 velocity = 0.5 * (direction_after(1.0, moon) - direction_after(-1.0, moon));
    ErrorSum errors;
    for (int i = -20; i < 20; ++i) {
      const double t = 1e-6 * i;
      const Vec3 difference = direction_after(t + 1e-6, moon) - direction_after(t, moon);
      errors.add(glm::length(difference - 1e-6 * velocity) / (1e-6 * glm::length(velocity)));
    }
    errors.print(moon ? "Moon's microsecond" : "Sun's microsecond", "of its motion");
    EXPECT_LT(errors.worst(), 1e-3);
  }
}

TEST(EphemerisStability, DatesThatAreNoNumbersGiveNoNumbers) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    EXPECT_FALSE(std::isfinite(sun_earth_moon({2451545.0, bad}).moon.position_au.x));
    EXPECT_FALSE(std::isfinite(planet_heliocentric(Planet::mars, {2451545.0, bad}).position_au.x));
    EXPECT_FALSE(std::isfinite(greenwich_apparent_sidereal_time_rad(instant_from({2451545.0, bad}, {2451545.0, bad}))));
  }
}

} // namespace
} // namespace vesper
