// Any bytes are a table that can be read at any date, or an Error.

#include "vesper/astro/ephemeris_table.hpp"
#include "vesper/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vesper;
  try {
    const EphemerisTable table(std::span(data, size));
    for (const double day : {table.begin().day, table.end().day, 0.5 * (table.begin().day + table.end().day), 2451545.0,
                             std::numeric_limits<double>::quiet_NaN(), -1e300}) {
      const JulianDate<TDB> tdb{day, 0.0};
      const bool covered = table.covers(tdb);
      if (covered != table.sun_earth_moon(tdb).has_value() ||
          covered != table.planet_heliocentric(Planet::neptune, tdb).has_value() ||
          covered != table.lunar_angles(tdb).has_value()) {
        std::abort();
      }
      (void)table.nutation({day, 0.0});
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input || error.context().remedy.empty()) {
      std::abort();
    }
  }
  return 0;
}
