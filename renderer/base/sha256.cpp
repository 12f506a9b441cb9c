#include "vesper/base/sha256.hpp"

#include "vesper/base/error.hpp"

#include <array>
#include <openssl/evp.h>

namespace vesper {

std::string sha256_hex(std::span<const std::byte> data) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(data.data(), data.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw Error(ErrorKind::file, "SHA-256 is not available", {"", "", "Check the OpenSSL installation"});
  }
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  text.reserve(2 * std::size_t{length});
  for (unsigned int i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

} // namespace vesper
