// Bytes as a file of sky tables, once as they are and once with the digest that a forger would give them.
#include "vesper/atmosphere/sky_tables_file.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/sha256.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>

namespace {

const std::string fingerprint(64, 'a');

void decode(const vesper::Bytes& bytes) {
  try {
    const vesper::SkyTables tables = vesper::decode_sky_tables(bytes, "input", fingerprint);
    if (vesper::encode_sky_tables(tables, fingerprint) != bytes) {
      std::abort(); // what is taken comes back
    }
  } catch (const vesper::Error& error) {
    if (error.kind() != vesper::ErrorKind::input || error.context().remedy.empty()) {
      std::abort();
    }
  }
}

} // namespace

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  vesper::Bytes bytes(size);
  if (size > 0) {
    std::memcpy(bytes.data(), data, size);
  }
  decode(bytes);
  const std::string digest = vesper::sha256_hex(bytes);
  bytes.resize(size + digest.size());
  std::memcpy(bytes.data() + size, digest.data(), digest.size());
  decode(bytes);
  return 0;
}
