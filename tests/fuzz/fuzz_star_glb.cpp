// Any bytes are a star buffer or an Error, and what was read can be written and read again.

#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  vesper::StarCatalogue catalogue;
  try {
    catalogue = vesper::decode_star_glb(std::as_bytes(std::span(data, size)), "fuzz.glb");
  } catch (const vesper::Error& error) {
    if (error.kind() != vesper::ErrorKind::input || error.context().remedy.empty()) {
      std::abort();
    }
    return 0;
  }
  const vesper::StarCatalogue again = vesper::decode_star_glb(vesper::encode_star_glb(catalogue), "again.glb");
  if (again.stars.size() != catalogue.stars.size() ||
      std::memcmp(again.stars.data(), catalogue.stars.data(), catalogue.stars.size() * sizeof(vesper::StarRecord)) !=
          0) {
    std::abort();
  }
  return 0;
}
