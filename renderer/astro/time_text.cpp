#include "vesper/astro/time.hpp"

#include "vesper/astro/delta_t.hpp"
#include "vesper/base/error.hpp"

#include <erfa.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>

namespace vesper {
namespace {

constexpr double year_minus_1000_jd = 1355807.5; // -1000-01-01, Gregorian
constexpr double year_3000_jd = 2816787.5;       // 3000-01-01
constexpr double end_of_dates_jd = 5373484.5;    // 10000-01-01
constexpr const char* beyond_dates = "dates end with 9999-12-31 of the Gregorian calendar";
constexpr const char* allowed_form = "Write 2026-08-12T22:00:00Z, JD2461265.4 or now";

[[noreturn]] void fail(std::string_view text, const std::string& what) {
  throw Error(ErrorKind::argument, fmt::format("'{}' is not a time: {}", text, what), {"", "", allowed_form});
}

/// Reads a stamp from left to right; every reader fails with the whole text in its message.
class StampReader {
public:
  explicit StampReader(std::string_view text) : text_(text), rest_(text) {}

  [[nodiscard]] bool done() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }

  bool accept(char c) {
    if (rest_.empty() || rest_.front() != c) {
      return false;
    }
    rest_.remove_prefix(1);
    return true;
  }

  /// Exactly `digits` digits that lie in [lowest, highest].
  int field(const char* name, std::size_t digits, int lowest, int highest) {
    const std::string_view token = rest_.substr(0, digits);
    int value = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (token.size() != digits || error != std::errc() || end != token.data() + digits || token.front() == '-') {
      fail(text_, fmt::format("the {} needs {} digits", name, digits));
    }
    rest_.remove_prefix(digits);
    if (value < lowest || value > highest) {
      fail(text_, fmt::format("the {} {} is not in {} to {}", name, value, lowest, highest));
    }
    return value;
  }

  /// The digits after a decimal point as a fraction of one.
  double fraction() {
    const std::size_t digits = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    if (digits == 0) {
      fail(text_, "digits are missing after the decimal point");
    }
    const std::string number = "0." + std::string(rest_.substr(0, digits));
    rest_.remove_prefix(digits);
    double value = 0.0;
    std::from_chars(number.data(), number.data() + number.size(), value);
    return value;
  }

private:
  std::string_view text_;
  std::string_view rest_;
};

struct Stamp {
  CalendarDate date;
  int hour = 0;
  int minute = 0;
  double second = 0.0;
};

void read_time_of_day(StampReader& reader, std::string_view text, Stamp& stamp) {
  stamp.hour = reader.field("hour", 2, 0, 23);
  if (!reader.accept(':')) {
    fail(text, "':' and the minute must follow the hour");
  }
  stamp.minute = reader.field("minute", 2, 0, 59);
  if (reader.accept(':')) {
    stamp.second = reader.field("second", 2, 0, 60);
    if (reader.accept('.')) {
      stamp.second += reader.fraction();
    }
  }
}

Stamp read_stamp(std::string_view text) {
  StampReader reader(text);
  Stamp stamp;
  const bool negative = reader.accept('-');
  stamp.date.year = reader.field("year", 4, 0, negative ? 4712 : 9999);
  stamp.date.year = negative ? -stamp.date.year : stamp.date.year;
  if (!reader.accept('-')) {
    fail(text, "'-' and the month must follow the year");
  }
  stamp.date.month = reader.field("month", 2, 1, 12);
  if (!reader.accept('-')) {
    fail(text, "'-' and the day must follow the month");
  }
  stamp.date.day = reader.field("day", 2, 1, 31);
  if (!reader.done() && reader.rest() != "Z") {
    if (!reader.accept('T') && !reader.accept(' ')) {
      fail(text, fmt::format("'T' and a time of day must follow the date, not '{}'", reader.rest()));
    }
    read_time_of_day(reader, text, stamp);
  }
  reader.accept('Z');
  if (!reader.done()) {
    fail(text, fmt::format("'{}' at the end cannot be read", reader.rest()));
  }
  return stamp;
}

Instant instant_of(double day, double fraction, TimeScale scale) {
  switch (scale) {
  case TimeScale::ut1:
    return instant_from_ut1({day, fraction});
  case TimeScale::tt:
    return instant_from_tt({day, fraction});
  case TimeScale::utc:
    break;
  }
  return instant_from_utc({day, fraction});
}

Instant parse_stamp(std::string_view text, TimeScale scale, Calendar calendar) {
  const Stamp stamp = read_stamp(text);
  if (stamp.date.day > days_in_month(stamp.date.year, stamp.date.month, calendar)) {
    fail(text, fmt::format("month {} has no day {}", stamp.date.month, stamp.date.day));
  }
  const double midnight = midnight_jd(stamp.date, calendar);
  if (midnight >= end_of_dates_jd) { // a Julian one
    fail(text, beyond_dates);
  }
  const bool leap_seconds = scale == TimeScale::utc && utc_is_defined({midnight, 0.0});
  const CalendarDate date = date_of_midnight(midnight, Calendar::gregorian);
  double day = 0.0;
  double fraction = 0.0;
  const int status = eraDtf2d(leap_seconds ? "UTC" : "TT", date.year, date.month, date.day, stamp.hour, stamp.minute,
                              stamp.second, &day, &fraction);
  // +1 says that the library is older than the date, +2 that the second lies beyond the end of the minute or day.
  if (status < 0 || status > 1 || (stamp.second >= 60.0 && !(stamp.hour == 23 && stamp.minute == 59 && leap_seconds))) {
    fail(text, "there is no leap second at that time");
  }
  return instant_of(midnight, (day - midnight) + fraction, scale);
}

Instant parse_julian_date(std::string_view text, TimeScale scale) {
  constexpr int last_day = 5373484; // the noon in the last day of year 9999
  StampReader reader(text);
  reader.accept('J');
  reader.accept('D');
  const std::size_t digits = std::min(reader.rest().find_first_not_of("0123456789"), reader.rest().size());
  if (digits == 0 || digits > 7) {
    fail(text, "a Julian date needs one to seven digits before its decimal point");
  }
  const int day = reader.field("Julian day", digits, 0, last_day);
  const double fraction = reader.accept('.') ? reader.fraction() : 0.0;
  if (!reader.done()) {
    fail(text, fmt::format("'{}' at the end cannot be read", reader.rest()));
  }
  if (day + fraction >= end_of_dates_jd) {
    fail(text, beyond_dates);
  }
  return instant_of(day, fraction, scale);
}

Instant instant_now() {
  // The system's clock counts days of equal length since 1970 and skips or repeats leap seconds.
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  const double seconds = std::chrono::duration<double>(since_epoch).count();
  const double days = std::floor(seconds / seconds_per_day);
  return instant_from_utc({2440587.5 + days, (seconds - days * seconds_per_day) / seconds_per_day});
}

} // namespace

Instant parse_instant(std::string_view text, TimeScale scale, Calendar calendar) {
  if (text == "now") {
    return instant_now();
  }
  return text.starts_with("JD") ? parse_julian_date(text, scale) : parse_stamp(text, scale, calendar);
}

std::string to_iso8601(const Instant& instant, Calendar calendar) {
  const std::optional<JulianDate<UTC>> utc = utc_of(instant);
  const double day = utc ? utc->day : instant.ut1.day;
  const double fraction = utc ? utc->fraction : instant.ut1.fraction;
  CalendarDate date;
  std::array<int, 4> time{};
  if (eraD2dtf(utc ? "UTC" : "UT1", 3, day, fraction, &date.year, &date.month, &date.day, time.data()) < 0) {
    throw Error(ErrorKind::argument, fmt::format("Julian date {} has no calendar date", instant.ut1.value()));
  }
  if (calendar == Calendar::julian) {
    date = date_of_midnight(midnight_jd(date, Calendar::gregorian), calendar);
  }
  return fmt::format("{}{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}{}", date.year < 0 ? "-" : "", std::abs(date.year),
                     date.month, date.day, time[0], time[1], time[2], time[3], utc ? "Z" : " UT1");
}

std::vector<std::string> accuracy_remarks(const Instant& instant) {
  std::vector<std::string> remarks;
  const double uncertainty_s = delta_t_uncertainty_s(instant.tt);
  if (uncertainty_s >= 1.0) {
    remarks.push_back(fmt::format("The Earth's rotation is known to about {:.2g} s at this date (Delta-T = {:.0f} s)",
                                  uncertainty_s, instant.delta_t_s));
  }
  if (instant.tt.days_since({year_minus_1000_jd, 0.0}) < 0.0 || instant.tt.days_since({year_3000_jd, 0.0}) > 0.0) {
    remarks.emplace_back("The theories of Moon, planets and precession are stretched this far from the present: expect "
                         "errors of arcminutes (in the cheap tier of degrees), more towards -4712 and 9999");
  }
  return remarks;
}

std::vector<std::string> time_remarks(const Instant& instant) {
  std::vector<std::string> remarks;
  if (!instant.note.empty()) {
    remarks.push_back(instant.note);
  }
  for (std::string& remark : accuracy_remarks(instant)) {
    remarks.push_back(std::move(remark));
  }
  if (instant.ut1.days_since({gregorian_reform_jd, 0.0}) < 0.0) {
    remarks.push_back("The date is of the proleptic Gregorian calendar; in the Julian calendar " +
                      to_iso8601(instant, Calendar::julian).substr(0, instant.ut1.value() < 1721057.5 ? 11 : 10));
  }
  return remarks;
}

} // namespace vesper
