#include "vesper/catalog_tools/gzip.hpp"

#include "vesper/base/error.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <memory>
#include <unistd.h>
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

UnpackedFile::UnpackedFile(const std::filesystem::path& path) {
  const auto no_room = [](const char* what) {
    return Error(ErrorKind::file, std::string(what) + ": " + std::strerror(errno),
                 {std::filesystem::temp_directory_path().string(), "",
                  "Free some space or let TMPDIR name a folder that can be written"});
  };
  std::string name = (std::filesystem::temp_directory_path() / "vesper-XXXXXX").string();
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) {
    throw no_room("no temporary file can be made");
  }
  ::unlink(name.c_str());
  const std::unique_ptr<gzFile_s, decltype(&gzclose)> packed(gzopen(path.c_str(), "rb"), &gzclose);
  std::array<std::byte, 1 << 16> buffer{};
  int count = packed ? 1 : -1;
  std::size_t written = 0;
  try {
    while (count > 0) {
      count = gzread(packed.get(), buffer.data(), static_cast<unsigned>(buffer.size()));
      for (int at = 0; at < count;) {
        const ssize_t step = ::write(descriptor_, buffer.data() + at, static_cast<std::size_t>(count - at));
        if (step < 0) {
          throw no_room("the file cannot be unpacked");
        }
        at += static_cast<int>(step);
        written += static_cast<std::size_t>(step);
      }
    }
    int status = Z_OK;
    const char* said = packed ? gzerror(packed.get(), &status) : "cannot be opened";
    if (count < 0 || status == Z_BUF_ERROR) {
      fail(path.string(), written,
           status == Z_BUF_ERROR ? "the gzip data is truncated (byte of what it unpacks to)"
                                 : std::string("the gzip data is corrupt: ") + said);
    }
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

UnpackedFile::~UnpackedFile() { ::close(descriptor_); }

std::filesystem::path UnpackedFile::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

} // namespace vesper
