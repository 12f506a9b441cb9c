// Events where they are hard to find: at poles, borders, grazing, at the zenith, far away in time.
#include "support/truth.hpp"

#include "vesper/astro/sky_events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace vesper {
namespace {

using test::ErrorSum;

constexpr double day_s = 86400.0;
const std::array<SkyBody, 2> sun_and_moon{Luminary::sun, Luminary::moon};

Observer at(double latitude_deg, double longitude_deg, double height_m = 0.0) {
  return {latitude_deg * deg, longitude_deg * deg, height_m * metre};
}

BodyEvents events_of(const SkyBody& body, const Instant& begin, const Instant& end, const Observer& observer,
                     const HorizonRule& rule = HorizonRule::almanac()) {
  return sky_events(begin, end, observer, std::span(&body, 1), rule)[0];
}

std::ptrdiff_t count(const BodyEvents& body, SkyEventKind kind) {
  return std::count_if(body.events.begin(), body.events.end(), [&](const SkyEvent& e) { return e.kind == kind; });
}

const SkyEvent& first(const BodyEvents& body, SkyEventKind kind) {
  return *std::find_if(body.events.begin(), body.events.end(), [&](const SkyEvent& e) { return e.kind == kind; });
}

/// Computed for the very instant.
Vec3 exact_direction(const SkyBody& body, const Instant& instant, const Observer& observer) {
  const EarthState earth = earth_state(instant, observer);
  return horizon_place(body, earth, star_frame(earth)).direction;
}

Vec3 direction_of(const Horizontal& place) {
  const Vec3 v = test::direction(place.azimuth, place.altitude);
  return {v.y, v.x, v.z};
}

DatedStar star(double ra_deg, double dec_deg) {
  return {catalogue_star(ra_deg * deg, dec_deg * deg, 0.0 * arcsec, 0.0 * arcsec, 0.0 * arcsec, 0.0), 2000.0};
}

double seconds_between(const Instant& a, const Instant& b) { return b.tt.days_since(a.tt) * day_s; }

// Every event of a grid of places and dates against places computed for its instant, and the number of rises and sets
// against a walk in steps of five minutes.
TEST(EventStability, PlacesAndCountsHoldEverywhere) {
  const std::array<SkyBody, 6> bodies{Luminary::sun,
                                      Luminary::moon,
                                      Planet::mercury,
                                      Planet::neptune,
                                      SkyBody(star(101.3, -16.7)),
                                      SkyBody(star(37.9, 89.26))};
  ErrorSum moon;
  ErrorSum others;
  ErrorSum meridian;
  std::size_t missed = 0;
  for (const char* date :
       {"-1000-03-20", "1400-06-30", "1959-12-13", "2026-06-21", "2026-12-21", "2059-12-31", "5000-01-01"}) {
    const Instant begin = parse_instant(date);
    const Instant end = later(begin, 3.0 * day_s);
    for (const double latitude : {-90.0, -67.0, 0.0, 23.4, 66.0, 89.94, 90.0}) {
      for (const auto& [longitude, height] :
           {std::pair{-180.0, -400.0}, std::pair{0.0, 0.0}, std::pair{77.0, 9000.0}}) {
        const Observer observer = at(latitude, longitude, height);
        SCOPED_TRACE(std::string(date) + " " + std::to_string(latitude));
        const auto results = sky_events(begin, end, observer, bodies);
        for (std::size_t b = 0; b < bodies.size(); ++b) {
          const BodyEvents& found = results[b];
          for (const SkyEvent& event : found.events) {
            EXPECT_GE(seconds_between(begin, event.instant), 0.0);
            EXPECT_LT(seconds_between(event.instant, end), 3.0 * day_s + 1.0);
            const Vec3 exact = exact_direction(bodies[b], event.instant, observer);
            (b == 1 ? moon : others).add(test::separation(exact, direction_of(event.place)).to(arcsec));
            if (event.kind == SkyEventKind::upper_transit || event.kind == SkyEventKind::lower_transit) {
              meridian.add((exact.x * rad).to(arcsec));
            }
          }
          const Instant& top = found.highest.instant;
          const Instant& bottom = found.lowest.instant;
          EXPECT_LE(found.lowest.place.altitude, found.highest.place.altitude);
          EXPECT_TRUE(std::isfinite(seconds_between(top, bottom)));
          std::ptrdiff_t crossings = 0;
          if (latitude == 66.0 && height == 0.0 && b != 1) { // the Moon's threshold varies
            const double threshold = std::sin((b == 0 ? -50.0 * arcmin : -34.0 * arcmin).to(rad));
            bool above = exact_direction(bodies[b], begin, observer).z > threshold;
            for (double s = 300.0; s <= 3.0 * day_s; s += 300.0) {
              const bool now = exact_direction(bodies[b], later(begin, s), observer).z > threshold;
              crossings += now != above ? 1 : 0;
              above = now;
            }
            const auto events = count(found, SkyEventKind::rise) + count(found, SkyEventKind::set);
            EXPECT_GE(events, crossings);
            EXPECT_EQ((events - crossings) % 2, 0);
            missed += events < crossings ? 1U : 0U;
          }
        }
      }
    }
  }
  moon.print("Moon's events: places against places computed for their instants", "arcsec");
  others.print("others' events", "arcsec");
  meridian.print("distance from the meridian in transit", "arcsec");
  EXPECT_LT(moon.worst(), 0.003);
  EXPECT_LT(others.worst(), 0.00001);
  EXPECT_LT(meridian.worst(), 0.003);
  EXPECT_EQ(missed, 0U);
}

// The midnight Sun dips below a horizon that is raised to just above its lowest point.
TEST(EventStability, GrazingCrossingsAreFoundInPairs) {
  const Observer tromso = at(69.65, 18.96);
  const Instant begin = parse_instant("2026-06-20T12:00:00Z");
  const Instant end = later(begin, day_s);
  const BodyEvents plain = events_of(Luminary::sun, begin, end, tromso);
  ASSERT_EQ(plain.conduct, HorizonConduct::stays_above);
  const double altitude = plain.lowest.place.altitude.to(rad);
  const double declination = 23.43 * std::numbers::pi / 180.0;
  const double curvature =
      std::pow(7.2722e-5, 2) * std::cos(tromso.latitude.to(rad)) * std::cos(declination) / std::cos(altitude); // rad/s2
  for (double depth = 1e-3; depth > 1e-12; depth *= 0.1) {
    const HorizonRule below{(altitude - depth) * rad, 0.0 * deg};
    const HorizonRule above{(altitude + depth) * rad, 0.0 * deg};
    EXPECT_EQ(events_of(Luminary::sun, begin, end, tromso, below).conduct, HorizonConduct::stays_above);
    const BodyEvents dipping = events_of(Luminary::sun, begin, end, tromso, above);
    ASSERT_EQ(count(dipping, SkyEventKind::set), 1) << depth;
    ASSERT_EQ(count(dipping, SkyEventKind::rise), 1) << depth;
    const double apart =
        seconds_between(first(dipping, SkyEventKind::set).instant, first(dipping, SkyEventKind::rise).instant);
    const double expected = 2.0 * std::sqrt(2.0 * depth / curvature);
    EXPECT_NEAR(apart, expected, 0.02 * expected + 0.002) << depth;
  }
}

TEST(EventStability, AnEventOnABorderIsCountedOnce) {
  const Observer place = at(51.5, 10.0);
  const Instant begin = parse_instant("2026-03-10");
  const auto results = sky_events(begin, later(begin, day_s), place, sun_and_moon);
  for (std::size_t b = 0; b < sun_and_moon.size(); ++b) {
    for (const SkyEvent& event : results[b].events) {
      for (const double shift : {-1e-3, -1e-6, -1e-9, 0.0, 1e-9, 1e-6, 1e-3}) {
        const Instant border = later(event.instant, shift);
        const Instant early = later(border, -20000.0);
        const Instant late = later(border, 30000.0);
        const auto before = count(events_of(sun_and_moon[b], early, border, place), event.kind);
        const auto after = count(events_of(sun_and_moon[b], border, late, place), event.kind);
        EXPECT_EQ(before + after, 1) << name_of(event.kind) << " " << shift;
        if (std::abs(shift) > 1e-4) {
          EXPECT_EQ(before, shift > 0.0 ? 1 : 0) << name_of(event.kind) << " " << shift;
        }
      }
    }
  }
}

TEST(EventStability, AnEmptyIntervalHasNoEventsAndABackwardOneIsRefused) {
  const Instant now = parse_instant("2026-08-12");
  EXPECT_TRUE(events_of(Luminary::sun, now, now, at(50.0, 0.0)).events.empty());
  EXPECT_THROW(static_cast<void>(events_of(Luminary::sun, now, later(now, -1.0), at(50.0, 0.0))), Error);
  EXPECT_TRUE(sky_events(now, later(now, day_s), at(50.0, 0.0), {}).empty());
}

TEST(EventStability, AtThePolesTheSunRisesOnceAYear) {
  const Instant begin = parse_instant("2025-01-01");
  const Instant end = parse_instant("2026-01-01");
  const BodyEvents north = events_of(Luminary::sun, begin, end, at(90.0, 0.0));
  const BodyEvents south = events_of(Luminary::sun, begin, end, at(-90.0, -180.0));
  for (const BodyEvents* pole : {&north, &south}) {
    for (const SkyEventKind kind : {SkyEventKind::rise, SkyEventKind::set, SkyEventKind::civil_dawn,
                                    SkyEventKind::civil_dusk, SkyEventKind::astronomical_dusk}) {
      EXPECT_EQ(count(*pole, kind), 1) << name_of(kind);
    }
    EXPECT_NEAR(static_cast<double>(count(*pole, SkyEventKind::upper_transit)), 365.0, 1.0);
    EXPECT_NEAR(pole->highest.place.altitude.to(deg), 23.438, 0.003);
    EXPECT_NEAR(pole->lowest.place.altitude.to(deg), -23.438, 0.003);
  }
  // Equinoxes of 2025: March 20, 09:01, September 22, 18:19. The Sun climbs 0.395 degrees a day then: 50.8 hours
  // earlier and later it stands at -50'.
  EXPECT_EQ(to_iso8601(first(north, SkyEventKind::rise).instant).substr(0, 10), "2025-03-18");
  EXPECT_EQ(to_iso8601(first(north, SkyEventKind::set).instant).substr(0, 10), "2025-09-24");
  EXPECT_EQ(to_iso8601(first(south, SkyEventKind::set).instant).substr(0, 10), "2025-03-22");
}

TEST(EventStability, LongitudesThatAreTheSamePlaceAgree) {
  const Instant begin = parse_instant("2026-08-12");
  const Instant end = later(begin, 2.0 * day_s);
  const auto west = sky_events(begin, end, at(40.0, -180.0), sun_and_moon);
  const auto east = sky_events(begin, end, at(40.0, 180.0), sun_and_moon);
  for (std::size_t b = 0; b < west.size(); ++b) {
    ASSERT_EQ(west[b].events.size(), east[b].events.size());
    ASSERT_GE(west[b].events.size(), 6U);
    for (std::size_t i = 0; i < west[b].events.size(); ++i) {
      EXPECT_EQ(west[b].events[i].kind, east[b].events[i].kind);
      EXPECT_NEAR(seconds_between(west[b].events[i].instant, east[b].events[i].instant), 0.0, 1e-6);
    }
  }
}

TEST(EventStability, AnEventInsideALeapSecondBelongsToItsDay) {
  const Instant begin = parse_instant("2016-12-31");
  const Instant end = parse_instant("2017-01-01");
  EXPECT_NEAR(seconds_between(begin, end), 86401.0, 1e-4);
  const Instant middle = parse_instant("2016-12-31T23:59:60.5Z");
  // The longitude where the Sun's transit falls into the leap second: 1 s of time is 15".
  double longitude = -179.0;
  for (int i = 0; i < 4; ++i) {
    const BodyEvents found =
        events_of(Luminary::sun, later(middle, -20000.0), later(middle, 20000.0), at(20.0, longitude));
    ASSERT_EQ(count(found, SkyEventKind::upper_transit), 1);
    longitude += seconds_between(middle, first(found, SkyEventKind::upper_transit).instant) / 240.0;
  }
  const BodyEvents day = events_of(Luminary::sun, begin, end, at(20.0, longitude));
  ASSERT_GE(count(day, SkyEventKind::upper_transit), 1);
  std::string last;
  for (const SkyEvent& event : day.events) {
    last = event.kind == SkyEventKind::upper_transit ? to_iso8601(event.instant) : last;
  }
  EXPECT_EQ(last.substr(0, 21), "2016-12-31T23:59:60.5");
  const BodyEvents next = events_of(Luminary::sun, end, later(end, 40000.0), at(20.0, longitude));
  EXPECT_EQ(count(next, SkyEventKind::upper_transit), 0);
}

TEST(EventStability, StarsThatNeverSetOrRise) {
  const Instant begin = parse_instant("2026-08-12");
  const Instant end = later(begin, day_s);
  const BodyEvents polaris = events_of(star(37.95, 89.264), begin, end, at(50.0, 0.0));
  EXPECT_EQ(polaris.conduct, HorizonConduct::stays_above);
  EXPECT_NEAR((polaris.highest.place.altitude - polaris.lowest.place.altitude).to(deg), 2.0 * 0.63, 0.03);
  EXPECT_NEAR(0.5 * (polaris.highest.place.altitude + polaris.lowest.place.altitude).to(deg), 50.0, 0.01);
  const BodyEvents crux = events_of(star(186.65, -63.1), begin, end, at(50.0, 0.0));
  EXPECT_EQ(crux.conduct, HorizonConduct::stays_below);
  EXPECT_GE(count(crux, SkyEventKind::upper_transit), 1);
  // The celestial pole itself: nothing happens, nothing breaks.
  const BodyEvents pole =
      events_of(star(0.0, 90.0), parse_instant("2000-01-01"), parse_instant("2000-01-02"), at(45.0, 0.0));
  EXPECT_EQ(pole.conduct, HorizonConduct::stays_above);
  EXPECT_NEAR(pole.highest.place.altitude.to(deg), 45.0, 0.02);
}

TEST(EventStability, ThroughTheZenith) {
  const Instant begin = parse_instant("2026-08-12");
  const Instant end = later(begin, day_s);
  double latitude = 15.0;
  for (int i = 0; i < 4; ++i) { // to where the Sun culminates in the zenith
    const SkyEvent transit =
        first(events_of(Luminary::sun, begin, end, at(latitude, 0.0)), SkyEventKind::upper_transit);
    const double zenith_distance = 90.0 - transit.place.altitude.to(deg);
    latitude += std::abs(transit.place.azimuth.to(deg) - 180.0) < 90.0 ? -zenith_distance : zenith_distance;
  }
  const BodyEvents found = events_of(Luminary::sun, begin, end, at(latitude, 0.0));
  EXPECT_EQ(count(found, SkyEventKind::upper_transit), 1);
  EXPECT_EQ(count(found, SkyEventKind::rise), 1);
  EXPECT_EQ(count(found, SkyEventKind::set), 1);
  EXPECT_GT(first(found, SkyEventKind::upper_transit).place.altitude.to(arcsec), (90.0 * deg).to(arcsec) - 0.01);
  EXPECT_GT(found.highest.place.altitude.to(arcsec), (90.0 * deg).to(arcsec) - 0.01);
}

TEST(EventStability, TransitIsWhereTheSiderealTimeIsTheRightAscension) {
  const Observer place = at(-33.0, 151.0);
  const Instant begin = parse_instant("2026-08-12");
  const DatedStar sirius = star(101.287, -16.716);
  const Instant transit =
      first(events_of(sirius, begin, later(begin, day_s), place), SkyEventKind::upper_transit).instant;
  const EarthState earth = earth_state(transit, place);
  const StarFrame frame = star_frame(earth);
  const Vec3 icrs = star_place_icrs(sirius.star, place_frame(frame));
  const Angle hour_angle = test::angle_difference(
      earth.local_sidereal_time_rad * rad, equatorial_of(frame.equator_of_date_from_icrs * icrs).right_ascension);
  EXPECT_LT(std::abs(hour_angle.to(arcsec)), 0.001);
}

// At the traced sunset the upper limb is seen on the horizon.
TEST(EventStability, TracedRefractionPutsTheLimbOnTheHorizon) {
  for (const double height_m : {-400.0, 0.0, 2000.0, 9000.0}) {
    const Observer place = at(35.0, 20.0, height_m);
    const Refraction air = with_table({RefractionModel::traced, standard_conditions(place.height), nullptr});
    const Angle horizon = horizon_altitude(air, place.height);
    const HorizonRule rule = HorizonRule::seen(air, horizon);
    const Instant begin = parse_instant("2026-01-03");
    for (const Luminary body : {Luminary::sun, Luminary::moon}) {
      const BodyEvents found = events_of(body, begin, later(begin, 1.1 * day_s), place, rule);
      ASSERT_GE(count(found, SkyEventKind::set), 1);
      const SkyEvent& set = first(found, SkyEventKind::set);
      const EarthState earth = earth_state(set.instant, place);
      const HorizonPlace seen = horizon_place(body, earth, star_frame(earth));
      const double radius_km = body == Luminary::sun ? 695998.0 : 1737.4; // 959.63" at 1 au
      const Angle semidiameter = std::asin(radius_km * kilometre / (seen.distance_au * astronomical_unit)) * rad;
      const Angle limb = apparent_altitude(horizontal_of(seen.direction).altitude + semidiameter, *air.table);
      EXPECT_NEAR(limb.to(arcsec), horizon.to(arcsec), 0.02) << height_m;
    }
  }
}

} // namespace
} // namespace vesper
