#include "vesper/astro/time.hpp"

#include "vesper/astro/delta_t.hpp"
#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vesper {
namespace {

constexpr double second = 1.0 / 86400.0;

double tt_seconds_between(const Instant& a, const Instant& b) { return b.tt.days_since(a.tt) * 86400.0; }

TEST(Time, UtcIsTtWithoutLeapSecondsAnd32Seconds) {
  // 37 leap seconds and 32.184 s since 2017; 10 at the start of 1972.
  const Instant t = parse_instant("2020-01-01T00:00:00Z");
  EXPECT_NEAR(t.tt.days_since({2458849.5, 0.0}) * 86400.0, 69.184, 1e-6);
  EXPECT_TRUE(t.note.empty());
  EXPECT_NEAR(parse_instant("1972-01-01").tt.days_since({2441317.5, 0.0}) * 86400.0, 42.184, 1e-6);
  EXPECT_NEAR(t.ut1.days_since({2458849.5, 0.0}) * 86400.0, -0.177, 0.002); // IERS: UT1-UTC on that day
}

TEST(Time, ReadsEveryAllowedForm) {
  const Instant t = parse_instant("2026-08-12T22:00:00Z");
  for (const char* text : {"2026-08-12T22:00:00", "2026-08-12T22:00", "2026-08-12T22:00Z", "2026-08-12 22:00:00.000Z",
                           "2026-08-12T22:00:00.0"}) {
    EXPECT_NEAR(tt_seconds_between(t, parse_instant(text)), 0.0, 1e-6) << text;
  }
  EXPECT_NEAR(tt_seconds_between(parse_instant("2026-08-12"), t), 22.0 * 3600.0, 1e-6);
  EXPECT_NEAR(tt_seconds_between(t, parse_instant("2026-08-12T22:00:00.125")), 0.125, 1e-6);
  EXPECT_NEAR(tt_seconds_between(parse_instant("JD2461265.5"), parse_instant("2026-08-13")), 0.0, 1e-6);
  EXPECT_NEAR(tt_seconds_between(parse_instant("JD2461265.4"), parse_instant("2026-08-12T21:36:00Z")), 0.0, 1e-5);
}

TEST(Time, ScalesAreTakenAsTold) {
  const Instant tt = parse_instant("2000-01-01T12:00:00", TimeScale::tt);
  EXPECT_EQ(tt.tt.days_since({2451545.0, 0.0}), 0.0);
  EXPECT_NEAR(tt.ut1.days_since({2451545.0, 0.0}) * 86400.0, -63.8285, 0.002);
  const Instant ut1 = parse_instant("JD2451545.0", TimeScale::ut1);
  EXPECT_EQ(ut1.ut1.days_since({2451545.0, 0.0}), 0.0);
  EXPECT_NEAR(ut1.tt.days_since({2451545.0, 0.0}) * 86400.0, 63.8285, 0.002);
}

TEST(Time, LeapSecondsHaveTheirOwnName) {
  const Instant before = parse_instant("2016-12-31T23:59:59Z");
  const Instant leap = parse_instant("2016-12-31T23:59:60Z");
  const Instant after = parse_instant("2017-01-01T00:00:00Z");
  EXPECT_NEAR(tt_seconds_between(before, leap), 1.0, 1e-5);
  EXPECT_NEAR(tt_seconds_between(leap, after), 1.0, 1e-5);
  EXPECT_EQ(to_iso8601(leap), "2016-12-31T23:59:60.000Z");
  EXPECT_EQ(to_iso8601(later(before, 1.5)), "2016-12-31T23:59:60.500Z");
  for (const char* text : {"2016-12-30T23:59:60Z", "2016-12-31T22:59:60Z", "2015-12-31T23:59:60Z",
                           "1960-12-31T23:59:60Z", "2030-12-31T23:59:60Z"}) {
    EXPECT_THROW((void)parse_instant(text), Error) << text;
  }
  EXPECT_THROW((void)parse_instant("2016-12-31T23:59:60", TimeScale::tt), Error);
}

TEST(Time, StampsOutsideTheLeapSecondsAreUt1AndSaySo) {
  for (const char* text : {"1971-12-31T23:59:59Z", "2027-01-01T00:00:00Z", "1066-10-14T09:00:00Z", "-0500-03-01"}) {
    const Instant t = parse_instant(text);
    EXPECT_FALSE(t.note.empty()) << text;
    EXPECT_NEAR(t.tt.days_since({t.ut1.day, t.ut1.fraction}), t.delta_t_s * second, 1e-12) << text;
    EXPECT_NEAR(t.delta_t_s, delta_t_s(t.tt), 1e-6) << text;
  }
  EXPECT_TRUE(parse_instant("2026-12-31T23:59:59Z").note.empty());
  EXPECT_TRUE(parse_instant("1972-01-01T00:00:00Z").note.empty());
  EXPECT_EQ(to_iso8601(parse_instant("2027-01-01T00:00:00Z")), "2027-01-01T00:00:00.000 UT1");
  EXPECT_EQ(to_iso8601(parse_instant("-0500-03-01")), "-0500-03-01T00:00:00.000 UT1");
  // Nobody sees a leap of more than a second at the borders.
  EXPECT_NEAR(tt_seconds_between(parse_instant("2026-12-31T23:59:59Z"), parse_instant("2027-01-01")), 1.0, 0.9);
}

TEST(Time, RejectsWhatIsNoTime) {
  for (const char* text : {"",
                           "nowish",
                           "2026",
                           "2026-08",
                           "2026-08-12T",
                           "2026-08-12T24:00:00Z",
                           "2026-08-12T22",
                           "2026-08-12T22:60",
                           "2026-08-12T22:00:61",
                           "2026-13-01",
                           "2026-00-01",
                           "2026-02-30",
                           "2100-02-29",
                           "2026-08-12T22:00:00ZZ",
                           "2026-08-12T22:00:00+02:00",
                           "2026-08-12T22:00:00.",
                           "26-08-12",
                           "12026-08-12",
                           "2026-8-12",
                           " 2026-08-12",
                           "2026-08-12 ",
                           "-5000-01-01",
                           "2026-08-12T-1:00",
                           "JD",
                           "JD-1",
                           "JD.5",
                           "JD2461265.4x",
                           "JD1e6",
                           "JD99999999",
                           "JD5373484.5",
                           "JD2461265.",
                           "2461265.4",
                           "2026/08/12",
                           "2026-08-12T22:00:00z"}) {
    try {
      (void)parse_instant(text);
      ADD_FAILURE() << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::argument);
      EXPECT_NE(std::string(e.what()).find("2026-08-12T22:00:00Z, JD2461265.4 or now"), std::string::npos);
    }
  }
}

TEST(Time, TextRoundTripsToTheMillisecond) {
  for (const char* text : {"1972-01-01T00:00:00.000Z", "1999-12-31T23:59:59.999Z", "2026-08-12T22:00:00.123Z",
                           "2016-12-31T23:59:60.500Z"}) {
    EXPECT_EQ(to_iso8601(parse_instant(text)), text);
  }
}

TEST(Time, CalendarsRunProlepticallyOverAllTime) {
  // The day after 1582-10-04 (Julian) was 1582-10-15 (Gregorian).
  EXPECT_EQ(midnight_jd({1582, 10, 15}, Calendar::gregorian), gregorian_reform_jd);
  EXPECT_EQ(midnight_jd({1582, 10, 4}, Calendar::julian), gregorian_reform_jd - 1.0);
  EXPECT_EQ(midnight_jd({-4712, 1, 1}, Calendar::julian), -0.5); // where Julian dates begin
  EXPECT_EQ(midnight_jd({2000, 1, 1}, Calendar::gregorian), 2451544.5);
  for (const Calendar calendar : {Calendar::gregorian, Calendar::julian}) {
    for (double jd = -31738.5 + 400.0; jd < 5373484.5; jd += 7.0) {
      const CalendarDate date = date_of_midnight(jd, calendar);
      ASSERT_EQ(midnight_jd(date, calendar), jd) << jd;
      ASSERT_TRUE(date.day >= 1 && date.day <= days_in_month(date.year, date.month, calendar)) << jd;
    }
  }
}

TEST(Time, JulianCalendarDatesAreReadAndWritten) {
  // The eclipse that Thales is said to have foretold: 28 May 585 BC, Julian.
  const Instant thales = parse_instant("-0584-05-28T12:00:00", TimeScale::utc, Calendar::julian);
  EXPECT_NEAR(thales.ut1.days_since({1507900.0, 0.0}), 0.0, 1e-9);
  EXPECT_EQ(to_iso8601(thales), "-0584-05-22T12:00:00.000 UT1");
  EXPECT_EQ(to_iso8601(thales, Calendar::julian), "-0584-05-28T12:00:00.000 UT1");
  EXPECT_NO_THROW((void)parse_instant("1500-02-29", TimeScale::utc, Calendar::julian));
  EXPECT_THROW((void)parse_instant("1500-02-29"), Error);
  EXPECT_EQ(to_iso8601(parse_instant("2026-07-30", TimeScale::utc, Calendar::julian)), "2026-08-12T00:00:00.000Z");
  // The calendars are 73 days apart when the years of four digits end.
  EXPECT_EQ(to_iso8601(parse_instant("9999-10-19", TimeScale::utc, Calendar::julian)), "9999-12-31T00:00:00.000 UT1");
  EXPECT_THROW((void)parse_instant("9999-10-20", TimeScale::utc, Calendar::julian), Error);
}

TEST(Time, RemarksSayWhatIsUncertain) {
  EXPECT_TRUE(time_remarks(parse_instant("2026-08-12")).empty());
  EXPECT_EQ(time_remarks(parse_instant("1950-01-01")).size(), 1U); // taken as UT1
  const auto future = time_remarks(parse_instant("2100-01-01"));
  ASSERT_EQ(future.size(), 2U);
  EXPECT_NE(future[1].find("known to about 10 s"), std::string::npos) << future[1];
  const auto ancient = time_remarks(parse_instant("-0584-05-22T12:00:00", TimeScale::ut1));
  ASSERT_EQ(ancient.size(), 2U);
  EXPECT_NE(ancient[1].find("in the Julian calendar -0584-05-28"), std::string::npos) << ancient[1];
  EXPECT_NE(time_remarks(parse_instant("1500-03-11", TimeScale::ut1)).back().find("1500-03-01"), std::string::npos);
}

TEST(Time, IsRefusedOutsideTheSupportedSpan) {
  for (const char* edge : {"-4712-01-01", "9999-12-31T23:59:59"}) {
    for (const TimeScale scale : {TimeScale::utc, TimeScale::ut1, TimeScale::tt}) {
      EXPECT_NO_THROW(require_supported(parse_instant(edge, scale).tt)) << edge;
    }
  }
  for (const double jd : {-100.0, 5.4e6, 1e300, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(require_supported({jd, 0.0}), Error) << jd;
  }
  EXPECT_EQ(time_remarks(parse_instant("-3000-01-01")).size(), 4U);
  EXPECT_EQ(time_remarks(parse_instant("9999-01-01")).size(), 3U);
}

TEST(Time, LaterKeepsAnOwnEarthRotation) {
  const Instant own = instant_from({2451545.0, 0.0}, {2451544.0, 0.5});
  EXPECT_DOUBLE_EQ(own.delta_t_s, 43200.0);
  const Instant day = later(own, 86400.0);
  EXPECT_DOUBLE_EQ(day.tt.days_since(own.tt), 1.0);
  EXPECT_NEAR(day.delta_t_s, 43200.0, 0.01);
  const Instant a = parse_instant("2026-06-01T00:00:00Z");
  EXPECT_NEAR(later(a, 3600.0).ut1.days_since(parse_instant("2026-06-01T01:00:00Z").ut1) * 86400.0, 0.0, 1e-6);
}

TEST(Time, NowLiesInThisCentury) {
  const Instant now = parse_instant("now");
  EXPECT_GT(now.tt.value(), 2460000.0);
  EXPECT_LT(now.tt.value(), 2488070.0);
}

} // namespace
} // namespace vesper
