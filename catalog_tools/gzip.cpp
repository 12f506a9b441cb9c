#include "vesper/catalog_tools/gzip.hpp"

#include "vesper/base/error.hpp"

#include <array>
#include <limits>
#include <memory>
#include <zlib.h>

namespace vesper {
namespace {

[[noreturn]] void fail(const std::string& file, std::size_t offset, const std::string& message) {
  throw Error(ErrorKind::input, message,
              {file, "byte " + std::to_string(offset), "Fetch the file again or unpack it with gzip -d to see more"});
}

} // namespace

bool is_gzip(std::span<const std::byte> bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

Bytes gunzip(std::span<const std::byte> bytes, const std::string& file, std::size_t limit) {
  if (bytes.size() > std::numeric_limits<uInt>::max()) {
    fail(file, 0, "the gzip file is larger than 4 GiB");
  }
  Bytes unpacked;
  std::size_t at = 0;
  while (at < bytes.size()) {
    if (!is_gzip(bytes.subspan(at))) {
      fail(file, at, "unexpected bytes after the end of the gzip data");
    }
    z_stream stream{};
    constexpr int gzip_only = 16 + MAX_WBITS;
    if (inflateInit2(&stream, gzip_only) != Z_OK) {
      fail(file, at, "zlib cannot start");
    }
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> guard(&stream, &inflateEnd);
    // zlib does not write to its input, but its old interface takes it without const.
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data() + at));
    stream.avail_in = static_cast<uInt>(bytes.size() - at);
    std::array<std::byte, 1 << 15> buffer{};
    int status = Z_OK;
    while (status != Z_STREAM_END) {
      stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream.avail_out = static_cast<uInt>(buffer.size());
      status = inflate(&stream, Z_NO_FLUSH);
      const std::size_t offset = bytes.size() - stream.avail_in;
      if (status == Z_BUF_ERROR) {
        fail(file, offset, "the gzip data is truncated");
      }
      if (status != Z_OK && status != Z_STREAM_END) {
        fail(file, offset,
             std::string("the gzip data is corrupt: ") + (stream.msg != nullptr ? stream.msg : "no detail"));
      }
      unpacked.insert(unpacked.end(), buffer.begin(), buffer.end() - stream.avail_out);
      if (unpacked.size() > limit) {
        fail(file, offset, "unpacks to more than " + std::to_string(limit) + " bytes: not a star catalogue");
      }
    }
    at = bytes.size() - stream.avail_in;
  }
  return unpacked;
}

} // namespace vesper
