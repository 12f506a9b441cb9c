// Any bytes are a star catalogue or an Error, and a catalogue becomes a valid star buffer or an Error.

#include "vesper/assets/star_glb.hpp"
#include "vesper/base/error.hpp"
#include "vesper/catalog_tools/bright_star_catalogue.hpp"
#include "vesper/catalog_tools/star_products.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<vesper::BrightStar> entries;
  vesper::StarProduct product;
  try {
    entries = vesper::read_bright_star_catalogue(std::as_bytes(std::span(data, size)), "fuzz.dat");
    product = vesper::make_star_product(entries, {});
  } catch (const vesper::Error& error) {
    if (error.kind() != vesper::ErrorKind::input || error.context().remedy.empty()) {
      std::abort();
    }
    return 0;
  }
  // Whatever was read must be fit to be written: an Error here is a fault of ours and ends the run.
  static_cast<void>(vesper::encode_star_glb(product.catalogue));
  return 0;
}
