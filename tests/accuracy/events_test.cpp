// Rise, set and twilights against JPL DE431.
#include "support/truth.hpp"

#include "vesper/astro/sky_events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

namespace vesper {
namespace {

using test::ErrorSum;
using test::TruthRow;

constexpr double seconds_per_day = 86400.0;

/// The date of a row, in its own scale and with its own Delta-T, so that only the events are tested.
struct Day {
  Instant begin, end;
  bool in_ut1 = false;

  explicit Day(const TruthRow& row) : in_ut1(row.text("scale") == "UT1") {
    const double delta_t_d = row.number("delta_t") / seconds_per_day;
    const Instant midnight = parse_instant(row.text("date_utc"), in_ut1 ? TimeScale::ut1 : TimeScale::utc);
    const auto own = [&](double days) {
      if (in_ut1) {
        const JulianDate<UT1> ut1 = midnight.ut1.plus_days(days);
        return instant_from({ut1.day, ut1.fraction + delta_t_d}, ut1);
      }
      const JulianDate<TT> tt = midnight.tt.plus_days(days);
      return instant_from(tt, {tt.day, tt.fraction - delta_t_d});
    };
    begin = own(0.0);
    end = own(1.0);
  }

  [[nodiscard]] double seconds_into(const Instant& instant) const {
    return seconds_per_day * (in_ut1 ? instant.ut1.days_since(begin.ut1) : instant.tt.days_since(begin.tt));
  }
};

/// Seconds since midnight of "10:55:43Z".
double seconds_of(const std::string& stamp) {
  return 3600.0 * std::stod(stamp.substr(0, 2)) + 60.0 * std::stod(stamp.substr(3, 2)) + std::stod(stamp.substr(6, 2));
}

struct Column {
  const char* name;
  std::size_t body;
  SkyEventKind kind;
};
constexpr std::array columns{
    Column{"sun_rise", 0, SkyEventKind::rise},
    Column{"sun_set", 0, SkyEventKind::set},
    Column{"civil_dawn", 0, SkyEventKind::civil_dawn},
    Column{"civil_dusk", 0, SkyEventKind::civil_dusk},
    Column{"naut_dawn", 0, SkyEventKind::nautical_dawn},
    Column{"naut_dusk", 0, SkyEventKind::nautical_dusk},
    Column{"astro_dawn", 0, SkyEventKind::astronomical_dawn},
    Column{"astro_dusk", 0, SkyEventKind::astronomical_dusk},
    Column{"moon_rise", 1, SkyEventKind::rise},
    Column{"moon_set", 1, SkyEventKind::set},
};
constexpr std::array<SkyBody, 2> sun_and_moon{Luminary::sun, Luminary::moon};

/// Of the airless altitude of the Sun at every second minute of the day, which is how the reference's extremes were
/// found.
std::pair<Angle, Angle> sampled_extremes(const Day& day, const Observer& observer) {
  std::pair<Angle, Angle> extremes{90.0 * deg, -90.0 * deg};
  for (int minute = 0; minute <= 1440; minute += 2) {
    const EarthState earth = earth_state(later(day.begin, 60.0 * minute), observer);
    const Angle altitude = horizontal_of(horizon_place(Luminary::sun, earth, star_frame(earth)).direction).altitude;
    extremes = {std::min(extremes.first, altitude), std::max(extremes.second, altitude)};
  }
  return extremes;
}

TEST(SkyEvents, MatchTheReference) {
  const CsvTable table = test::truth_table("riseset.csv");
  std::array<ErrorSum, columns.size()> errors;
  ErrorSum lowest;
  ErrorSum highest;
  ErrorSum all;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    SCOPED_TRACE(row.text("place") + " " + row.text("date_utc"));
    const Day day(row);
    const Observer observer{row.degrees("lat"), row.degrees("lon"), 0.0 * metre};
    const auto bodies = sky_events(day.begin, day.end, observer, sun_and_moon);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const Column& column = columns.at(c);
      const auto& events = bodies.at(column.body).events;
      const auto first =
          std::find_if(events.begin(), events.end(), [&](const SkyEvent& event) { return event.kind == column.kind; });
      const std::string stamp = row.text(column.name);
      ASSERT_EQ(first == events.end(), stamp.empty()) << column.name;
      if (!stamp.empty()) {
        // The reference drops the fraction of a second.
        const double error = day.seconds_into(first->instant) - (seconds_of(stamp) + 0.5);
        EXPECT_LT(std::abs(error), 5.0) << column.name;
        errors.at(c).add(error);
        all.add(error);
      }
    }
    const auto [low, high] = sampled_extremes(day, observer);
    lowest.add((low - row.degrees("sun_alt_min")).to(arcsec));
    highest.add((high - row.degrees("sun_alt_max")).to(arcsec));
    EXPECT_LT((bodies[0].lowest.place.altitude - low).to(arcsec), 0.001);
    EXPECT_GT((bodies[0].highest.place.altitude - high).to(arcsec), -0.001);
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    errors.at(c).hold(columns.at(c).name, 5.0, "s");
  }
  all.hold("all events", 5.0, "s");
  lowest.hold("lowest Sun of every second minute", 0.2, "arcsec"); // the reference is rounded to 0.0001 degree, 0.18"
  highest.hold("highest Sun of every second minute", 0.2, "arcsec");
  EXPECT_EQ(table.row_count(), 30U);
  EXPECT_EQ(all.count(), 219U);
}

} // namespace
} // namespace vesper
