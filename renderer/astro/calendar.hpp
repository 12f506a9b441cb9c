// Calendar dates and Julian day numbers.
#pragma once

namespace vesper {

/// Both run proleptically, over all time: before 1582-10-15 history counted by the Julian one. Years are astronomical:
/// 1 BC is 0.
enum class Calendar { gregorian, julian };

struct CalendarDate {
  int year = 2000;
  int month = 1; ///< 1 to 12
  int day = 1;   ///< from 1
};

/// 1582-10-15 Gregorian, the first day on which a country reckoned by it.
inline constexpr double gregorian_reform_jd = 2299160.5;

[[nodiscard]] int days_in_month(int year, int month, Calendar calendar);

/// Julian date of a date's midnight. Years from -4800; the date must exist.
[[nodiscard]] double midnight_jd(const CalendarDate& date, Calendar calendar);

/// The date on which a midnight of Julian date `jd` (with .5) begins, from -31738.5 (-4799-01-01 Gregorian) on.
[[nodiscard]] CalendarDate date_of_midnight(double jd, Calendar calendar);

} // namespace vesper
