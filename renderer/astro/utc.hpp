// Instants from Julian dates in each scale.
#pragma once

#include "vesper/astro/time.hpp"

namespace vesper {

/// Whether the Julian date lies where leap seconds are known, 1972-01-01 to 2026-12-31.
[[nodiscard]] bool utc_is_defined(double day, double fraction);

/// UT1 by Delta-T.
[[nodiscard]] Instant instant_from_tt(JulianDate<TT> tt);
/// TT by Delta-T.
[[nodiscard]] Instant instant_from_ut1(JulianDate<UT1> ut1);
/// TT by leap seconds and UT1 by Delta-T; outside the known leap seconds as UT1, said in `note`.
[[nodiscard]] Instant instant_from_utc(JulianDate<UTC> utc);

} // namespace vesper
