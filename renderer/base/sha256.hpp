#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace vesper {

/// SHA-256 (FIPS 180-4) of the bytes, as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256_hex(std::span<const std::byte> data);

/// The same of a file of any size, read bit by bit. Throws Error(file).
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& path);

} // namespace vesper
