// Nutation for dates outside the embedded table.
#pragma once

#include "vesper/astro/ephemeris_table.hpp"

namespace vesper {

/// IAU 2000A adjusted to the IAU 2006 precession (Wallace and Capitaine 2006, A&A 459, 981, eq. 5), 587 of 1365 terms:
/// within 0.0001" of eraNut06a from -4712 to 9999 in a tenth of its time. The CIO locator is eraS06's.
[[nodiscard]] Nutation nutation_series(JulianDate<TT> tt);

} // namespace vesper
