#pragma once

#include "vesper/base/files.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace vesper {

/// True when the bytes begin as a gzip file does.
[[nodiscard]] bool is_gzip(std::span<const std::byte> bytes);

/// Unpacks a gzip file (RFC 1952, one or more members). Throws Error(input), naming `file` and the byte, when it is
/// truncated or corrupt, followed by other bytes, or larger than `limit` bytes when unpacked.
[[nodiscard]] Bytes gunzip(std::span<const std::byte> bytes, const std::string& file, std::size_t limit);

} // namespace vesper
