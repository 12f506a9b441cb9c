// Any text is a header with coordinates on the sky or an Error, and coordinates give directions or none.
#include "vesper/base/error.hpp"
#include "vesper/catalog_tools/picture_wcs.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

// WCSLIB 7.12 forgets the text of some errors and the matrices of a singular transform, a few bytes each. The name is
// LeakSanitizer's. NOLINTNEXTLINE(readability-identifier-naming,bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() { return "leak:wcserr_set\nleak:linset"; }

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A line is a card.
  std::string cards;
  std::string line;
  for (std::size_t i = 0; i <= size; ++i) {
    if (i == size || data[i] == '\n') {
      line.resize(80, ' ');
      cards += line;
      line.clear();
    } else {
      line += static_cast<char>(data[i]);
    }
  }
  try {
    vesper::PictureWcs wcs(cards, "fuzz.fits", "HDU 1");
    vesper::PictureWcs copy(wcs);
    for (const vesper::Vec2& place : {vesper::Vec2(0.5, 0.5), vesper::Vec2(1800.0, 900.0), vesper::Vec2(-7.0, 1e5)}) {
      const vesper::Vec3 direction = copy.direction(place);
      const double size_squared = dot(direction, direction);
      if (size_squared != 0.0 && !(std::abs(size_squared - 1.0) < 1e-6)) {
        std::abort();
      }
      if (size_squared != 0.0) {
        (void)wcs.place(direction);
      }
    }
    wcs.require_on_sphere(360, 180);
  } catch (const vesper::Error& error) {
    if (error.kind() != vesper::ErrorKind::input || error.context().remedy.empty() || error.context().place.empty()) {
      std::abort();
    }
  }
  return 0;
}
