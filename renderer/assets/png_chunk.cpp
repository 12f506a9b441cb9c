#include "vesper/assets/png_chunk.hpp"

#include "vesper/assets/big_endian.hpp"

#include <zlib.h>

namespace vesper {

void insert_png_chunk(std::vector<unsigned char>& png, std::string_view type, std::span<const std::byte> data) {
  constexpr std::ptrdiff_t end_of_header = 8 + 12 + 13; // signature; length, type and check of the header; header
  const Bytes checked = BigEndian().text(type).all(data).bytes();
  const auto check =
      ::crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size())); // NOLINT
  const Bytes chunk = BigEndian()
                          .u32(static_cast<std::uint32_t>(data.size()))
                          .all(checked)
                          .u32(static_cast<std::uint32_t>(check))
                          .bytes();
  const std::span bytes(reinterpret_cast<const unsigned char*>(chunk.data()), chunk.size()); // NOLINT
  png.insert(png.begin() + end_of_header, bytes.begin(), bytes.end());
}

} // namespace vesper
