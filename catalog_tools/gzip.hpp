#pragma once

#include "vesper/base/files.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace vesper {

/// True when the bytes begin as a gzip file does.
[[nodiscard]] bool is_gzip(std::span<const std::byte> bytes);

/// Unpacks a gzip file (RFC 1952, one or more members). Throws Error(input), naming `file` and the byte, when it is
/// truncated or corrupt, followed by other bytes, or larger than `limit` bytes when unpacked.
[[nodiscard]] Bytes gunzip(std::span<const std::byte> bytes, const std::string& file, std::size_t limit);

/// A gzip file of any size, unpacked onto the disk: into a file without a name in the folder for temporary files, which
/// goes with this object, however the program ends.
class UnpackedFile {
public:
  /// Throws Error(input) for data that are truncated or corrupt, Error(file) where there is no room.
  explicit UnpackedFile(const std::filesystem::path& path);
  UnpackedFile(const UnpackedFile&) = delete;
  UnpackedFile& operator=(const UnpackedFile&) = delete;
  ~UnpackedFile();

  /// A path that opens it, in this process.
  [[nodiscard]] std::filesystem::path path() const;

private:
  int descriptor_;
};

} // namespace vesper
