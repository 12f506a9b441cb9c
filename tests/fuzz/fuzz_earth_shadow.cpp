// Bytes as a map of the light in the Earth's shadow.
#include "vesper/atmosphere/earth_shadow_file.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  try {
    const vesper::Bytes again = vesper::encode_earth_shadow_light(vesper::decode_earth_shadow_light(bytes, "input"));
    if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end())) {
      std::abort(); // what is taken comes back
    }
  } catch (const vesper::Error& error) {
    if (error.kind() != vesper::ErrorKind::input || error.context().remedy.empty()) {
      std::abort();
    }
  }
  return 0;
}
