#include "vesper/astro/calendar.hpp"

#include <array>
#include <cmath>

namespace vesper {
namespace {

// Years are counted from March so that the leap day ends them, and from -4800 so that nothing is negative.
constexpr int first_year = -4800;
constexpr int days_per_4_years = 1461;
constexpr int days_per_400_years = 146097;
// Day numbers of the first of March of -4800: Julian date at noon.
constexpr int julian_start = -32082;
constexpr int gregorian_start = -32044;

/// Days from the first of March to the first of the month that follows by `month_from_march`: 0, 31, 61, 92, ...
constexpr int days_before(int month_from_march) { return (153 * month_from_march + 2) / 5; }

bool is_leap(int year, Calendar calendar) {
  return year % 4 == 0 && (calendar == Calendar::julian || year % 100 != 0 || year % 400 == 0);
}

} // namespace

int days_in_month(int year, int month, Calendar calendar) {
  constexpr std::array days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return month == 2 && is_leap(year, calendar) ? 29 : days.at(static_cast<std::size_t>(month - 1));
}

double midnight_jd(const CalendarDate& date, Calendar calendar) {
  const int january_or_february = date.month <= 2 ? 1 : 0;
  const int year = date.year - first_year - january_or_february;
  const int day_of_year = days_before(date.month - 3 + 12 * january_or_february) + date.day - 1;
  const int leap_days = calendar == Calendar::julian ? year / 4 : year / 4 - year / 100 + year / 400;
  const int start = calendar == Calendar::julian ? julian_start : gregorian_start;
  return start + 365 * year + leap_days + day_of_year - 0.5;
}

CalendarDate date_of_midnight(double jd, Calendar calendar) {
  int days = static_cast<int>(std::lround(jd + 0.5)) - (calendar == Calendar::julian ? julian_start : gregorian_start);
  int year = first_year;
  if (calendar == Calendar::gregorian) {
    const int quarter_days = 4 * days + 3;
    const int century = quarter_days / days_per_400_years;
    days -= century * days_per_400_years / 4;
    year += 100 * century;
  }
  const int years = (4 * days + 3) / days_per_4_years;
  days -= years * days_per_4_years / 4;
  const int month_from_march = (5 * days + 2) / 153;
  const bool next_year = month_from_march >= 10;
  return {year + years + (next_year ? 1 : 0), month_from_march + (next_year ? -9 : 3),
          days - days_before(month_from_march) + 1};
}

} // namespace vesper
