// Time scales and the instant of a scene.
#pragma once

#include "vesper/astro/calendar.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {

inline constexpr double seconds_per_day = 86400.0;
inline constexpr double days_per_julian_year = 365.25;
inline constexpr double days_per_julian_century = 36525.0;

struct UTC {};
struct UT1 {};
struct TT {};
struct TDB {};

/// A two-part Julian date in one time scale: the date is day + fraction. Which part is large does not matter to the
/// value; ISO input puts the Julian date of midnight in `day`. For UTC the ERFA quasi-JD of leap-second days applies.
template <class Scale> struct JulianDate {
  double day = 2451545.0;
  double fraction = 0.0;

  /// The sum, good to about 40 microseconds.
  [[nodiscard]] constexpr double value() const { return day + fraction; }
  /// Days from another date of the same scale to this one, without loss.
  [[nodiscard]] constexpr double days_since(JulianDate other) const {
    return (day - other.day) + (fraction - other.fraction);
  }
  [[nodiscard]] constexpr JulianDate plus_days(double days) const { return {day, fraction + days}; }
};

/// The epoch J2000.0, noon of 2000-01-01 in whichever scale is meant.
template <class Scale> inline constexpr JulianDate<Scale> j2000{2451545.0, 0.0};
/// Julian centuries since J2000.0 in the date's own scale, the argument of most theories.
template <class Scale> [[nodiscard]] constexpr double centuries_since_j2000(JulianDate<Scale> date) {
  return date.days_since(j2000<Scale>) / days_per_julian_century;
}

/// One moment in the scales that astronomy needs. `note` says in a sentence when a convention had to step in (a UTC
/// stamp outside the leap-second table taken as UT1); empty otherwise.
struct Instant {
  JulianDate<TT> tt;
  JulianDate<UT1> ut1;
  double delta_t_s = 0.0; ///< TT - UT1
  std::string note;
};

/// How a stamp without a scale of its own is read.
enum class TimeScale { utc, ut1, tt };

/// Parses "2026-08-12T22:00:00Z", "JD2461265.4" or "now".
///
/// Of a stamp the time of day, its seconds, their fraction and the 'Z' may be left out, and a space may stand for the
/// 'T'. Its date is of `calendar`, by default the proleptic Gregorian one as ISO 8601 has it; years run from -4712 to
/// 9999, those before 0 as "-0500", and 0 is 1 BC. In UTC 23:59:60 is a leap second's name and allowed only there.
/// `scale` applies to stamps (with or without 'Z') and Julian dates; "now" is the computer's clock.
///
/// A UTC stamp before 1972-01-01 or from 2027-01-01 on, where no leap second is known, is taken as UT1, with TT from
/// Delta-T; the result's `note` says so. Throws Error(argument) naming what is wrong and the allowed form.
[[nodiscard]] Instant parse_instant(std::string_view text, TimeScale scale = TimeScale::utc,
                                    Calendar calendar = Calendar::gregorian);

/// The span for which the sky is computed: the years -4712 to 9999. Towards its ends precession and the motions of Moon
/// and planets are good to minutes of arc, of Jupiter and Saturn to a degree, and the Earth's rotation to an hour.
inline constexpr double first_supported_jd = -50.5;    ///< TT; November of -4713, before all stamps and Delta-T
inline constexpr double last_supported_jd = 5373494.5; ///< TT; January of 10000

/// Throws Error(argument) naming the date for one outside the supported span, or one that is no number.
void require_supported(JulianDate<TT> tt);

/// UT1 by Delta-T.
[[nodiscard]] Instant instant_from_tt(JulianDate<TT> tt);
/// TT by Delta-T.
[[nodiscard]] Instant instant_from_ut1(JulianDate<UT1> ut1);
/// TT by leap seconds and UT1 by Delta-T; outside the known leap seconds as UT1, said in `note`.
[[nodiscard]] Instant instant_from_utc(JulianDate<UTC> utc);

/// Whether leap seconds are known at a Julian date of UTC: 1972-01-01 to 2026-12-31.
[[nodiscard]] bool utc_is_defined(JulianDate<UTC> utc);
/// UTC by leap seconds, where they are known.
[[nodiscard]] std::optional<JulianDate<UTC>> utc_of(const Instant& instant);

/// The instant of given TT and UT1, for callers with their own Earth rotation.
[[nodiscard]] Instant instant_from(JulianDate<TT> tt, JulianDate<UT1> ut1);

/// Barycentric Dynamical Time at the Earth's centre, within 10 microseconds from 1600 to 2200: the seven largest terms
/// of Fairhead and Bretagnon 1990 as printed in the USNO Circular 179, eq. 2.6.
[[nodiscard]] JulianDate<TDB> tdb_from_tt(JulianDate<TT> tt);

/// An instant `seconds` of TT later.
[[nodiscard]] Instant later(const Instant& instant, double seconds);

/// ISO 8601 to the millisecond, in UTC where the leap-second table covers it ("...Z"), else in UT1 ("... UT1"); dates
/// of the proleptic Gregorian calendar unless told otherwise.
[[nodiscard]] std::string to_iso8601(const Instant& instant, Calendar calendar = Calendar::gregorian);

/// Sentences that a report about this instant owes its reader: a stamp taken as UT1, an uncertain rotation of the
/// Earth, a date before the Gregorian calendar with its name in the Julian one.
[[nodiscard]] std::vector<std::string> time_remarks(const Instant& instant);

/// Those of them that say how far the date strains the theories and the Earth's rotation.
[[nodiscard]] std::vector<std::string> accuracy_remarks(const Instant& instant);

} // namespace vesper
