// Any text is an instant of the supported span or an Error, and an instant's text reads back as itself.

#include "vesper/astro/time.hpp"
#include "vesper/base/error.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vesper;
  if (size == 0) {
    return 0;
  }
  const auto scale = static_cast<TimeScale>(data[0] % 3);
  const Calendar calendar = data[0] / 3 % 2 == 0 ? Calendar::gregorian : Calendar::julian;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): text is bytes
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    const Instant instant = parse_instant(text, scale, calendar);
    require_supported(instant.tt);
    std::string written = to_iso8601(instant, calendar);
    const bool in_ut1 = written.ends_with(" UT1");
    written.resize(written.size() - (in_ut1 ? 4 : 0));
    // Rounding to the millisecond may lead past the end of 9999.
    const bool past_the_end = written.starts_with("10000");
    if (!past_the_end) {
      const Instant again = parse_instant(written, in_ut1 ? TimeScale::ut1 : TimeScale::utc, calendar);
      if (!(std::abs(again.tt.days_since(instant.tt)) * seconds_per_day < 0.002)) {
        std::abort();
      }
    }
    if (time_remarks(instant).empty() && in_ut1 && scale == TimeScale::utc) {
      std::abort();
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::argument) {
      std::abort();
    }
  }
  return 0;
}
