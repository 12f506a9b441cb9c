// Any text is a label with which a small image can be read, or an Error that names its line or what is missing.

#include "vesper/base/error.hpp"
#include "vesper/catalog_tools/elevation_grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vesper;
  constexpr std::array<std::byte, 2 * 18 * 36> image{};
  try {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): text is bytes
    const PdsLabel label({reinterpret_cast<const char*>(data), size}, "fuzz.lbl");
    const GlobeGrid grid = read_elevation_grid(label, image, "FUZZ.IMG");
    if (grid.width != 2 * grid.height || grid.values.size() * 2 > image.size()) {
      std::abort();
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input || error.context().remedy.empty() ||
        (error.context().file != "fuzz.lbl" && error.context().file != "FUZZ.IMG")) {
      std::abort();
    }
  }
  return 0;
}
