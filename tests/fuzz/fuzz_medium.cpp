// Any text is a medium that light can be sent through at all of its wavelengths, or an Error with its line.

#include "vesper/atmosphere/medium_file.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vesper;
  Medium medium;
  try {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): text is bytes
    medium = parse_medium({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input || error.context().remedy.empty() || error.context().file != "fuzz.toml" ||
        !error.context().place.starts_with("line ")) {
      std::abort();
    }
    return 0;
  }
  if (medium.wavelengths_nm.front() > visible_from_nm || medium.wavelengths_nm.back() < visible_to_nm) {
    std::abort();
  }
  const Vec3 zenith(0.0, 0.0, 1.0);
  const AirColumns columns = columns_to_space(medium, medium.ground_radius.to(kilometre) * zenith, zenith);
  for (const double nm : medium.wavelengths_nm) {
    validate(medium, nm);
    const double through = optical_depth(medium, columns, nm).transmittance();
    if (!(through >= 0.0 && through <= 1.0)) {
      std::abort();
    }
  }
  return 0;
}
