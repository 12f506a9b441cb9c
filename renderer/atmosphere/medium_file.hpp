// Media from TOML files. docs/MEDIUM.md describes the format.
#pragma once

#include "vesper/atmosphere/medium.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace vesper {

/// What the wavelengths of a medium have to span at least, in nm: from and to where the published real-time models give
/// their coefficients. 0.4 % of the photopic response lies outside.
inline constexpr double visible_from_nm = 440.0;
inline constexpr double visible_to_nm = 680.0;

/// Reads a medium from TOML text. It is valid at all of its wavelengths.
/// \param name of the file, for messages
/// Throws Error(input) with the file, the line, the key and a remedy: for malformed TOML, unknown or missing keys,
/// wrong types, missing or wrong units, values out of their range, layers outside the air, and wavelengths that do not
/// span the visible.
[[nodiscard]] Medium parse_medium(std::string_view text, const std::string& name);

/// The same of a file. Throws Error(file) too.
[[nodiscard]] Medium read_medium_file(const std::filesystem::path& path);

} // namespace vesper
