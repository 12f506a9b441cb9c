#include "vesper/astro/time.hpp"

#include "vesper/astro/delta_t.hpp"
#include "vesper/base/error.hpp"

#include <erfa.h>
#include <fmt/format.h>

#include <cmath>

namespace vesper {
namespace {

// 1972-01-01, when UTC began to keep whole seconds from TAI, and 2027-01-01, up to which IERS Bulletin C 72 (July 2026)
// announces no leap second.
constexpr double utc_begin_jd = 2441317.5;
constexpr double utc_end_jd = 2461406.5;

} // namespace

void require_supported(JulianDate<TT> tt) {
  const double jd = tt.value();
  if (!(jd >= first_supported_jd && jd <= last_supported_jd)) {
    throw Error(ErrorKind::argument, fmt::format("Julian date {} lies outside the years -4712 to 9999", jd),
                {"", "", "Choose a date between them"});
  }
}

bool utc_is_defined(JulianDate<UTC> utc) {
  return utc.days_since({utc_begin_jd, 0.0}) >= 0.0 && utc.days_since({utc_end_jd, 0.0}) < 0.0;
}

std::optional<JulianDate<UTC>> utc_of(const Instant& instant) {
  // UT1 and UTC differ by less than a second where UTC is known: dates far outside never reach the conversion.
  if (!utc_is_defined({instant.ut1.day, instant.ut1.fraction + 1.0 / seconds_per_day})) {
    return std::nullopt;
  }
  double tai1 = 0.0;
  double tai2 = 0.0;
  JulianDate<UTC> utc;
  if (eraTttai(instant.tt.day, instant.tt.fraction, &tai1, &tai2) != 0 ||
      eraTaiutc(tai1, tai2, &utc.day, &utc.fraction) < 0 || !utc_is_defined(utc)) {
    return std::nullopt;
  }
  return utc;
}

Instant instant_from(JulianDate<TT> tt, JulianDate<UT1> ut1) {
  const double delta_t = ((tt.day - ut1.day) + (tt.fraction - ut1.fraction)) * seconds_per_day;
  return {tt, ut1, delta_t, ""};
}

Instant instant_from_tt(JulianDate<TT> tt) {
  const double delta_t = delta_t_s(tt);
  return {tt, {tt.day, tt.fraction - delta_t / seconds_per_day}, delta_t, ""};
}

Instant instant_from_ut1(JulianDate<UT1> ut1) {
  // Delta-T changes by less than 1e-6 of the time elapsed: the first step is right to a millisecond even in antiquity.
  JulianDate<TT> tt{ut1.day, ut1.fraction};
  for (int i = 0; i < 3; ++i) {
    tt.fraction = ut1.fraction + delta_t_s(tt) / seconds_per_day;
  }
  const double delta_t = delta_t_s(tt);
  return {tt, ut1, delta_t, ""};
}

Instant instant_from_utc(JulianDate<UTC> utc) {
  if (!utc_is_defined(utc)) {
    Instant instant = instant_from_ut1({utc.day, utc.fraction});
    instant.note = "The time lies outside the leap seconds known (1972 to 2026): taken as UT1, with TT from Delta-T";
    return instant;
  }
  double tai1 = 0.0;
  double tai2 = 0.0;
  double tt1 = 0.0;
  double tt2 = 0.0;
  // Inside the table eraUtctai warns only when the library is older than the stamp by five years.
  if (eraUtctai(utc.day, utc.fraction, &tai1, &tai2) < 0 || eraTaitt(tai1, tai2, &tt1, &tt2) != 0) {
    throw Error(ErrorKind::argument, "the date cannot be converted from UTC");
  }
  return instant_from_tt({tt1, tt2});
}

JulianDate<TDB> tdb_from_tt(JulianDate<TT> tt) {
  const double t = centuries_since_j2000(tt);
  const double difference_s = 0.001657 * std::sin(628.3076 * t + 6.2401) + 0.000022 * std::sin(575.3385 * t + 4.2970) +
                              0.000014 * std::sin(1256.6152 * t + 6.1969) + 0.000005 * std::sin(606.9777 * t + 4.0212) +
                              0.000005 * std::sin(52.9691 * t + 0.4444) + 0.000002 * std::sin(21.3299 * t + 5.5431) +
                              0.000010 * t * std::sin(628.3076 * t + 4.2490);
  return {tt.day, tt.fraction + difference_s / seconds_per_day};
}

Instant later(const Instant& instant, double seconds) {
  const JulianDate<TT> tt = instant.tt.plus_days(seconds / seconds_per_day);
  // An instant with an Earth rotation of its own keeps its difference to the table.
  const double delta_t = instant.delta_t_s + (delta_t_s(tt) - delta_t_s(instant.tt));
  return {tt, {tt.day, tt.fraction - delta_t / seconds_per_day}, delta_t, instant.note};
}

} // namespace vesper
