// The light in the Earth's shadow as a file.
//
// A file holds, low bytes first: "VSPRSHDW"; the version of the format, the numbers of inner and outer intervals and of
// wavelengths as 32-bit integers; then as 64-bit floats the first row and the rows per km, the radii of the edge and of
// full light, the width, the two distances of the Sun, and the wavelengths; last the logarithms as 16-bit integers.
#pragma once

#include "vesper/atmosphere/earth_shadow_light.hpp"
#include "vesper/base/files.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace vesper {

/// A digest, as 64 hexadecimal digits, of all that make_earth_shadow_light depends on, as sky_tables_fingerprint has
/// it. Throws Error(argument) for impossible radii.
[[nodiscard]] std::string earth_shadow_fingerprint(const Medium& medium);

[[nodiscard]] Bytes encode_earth_shadow_light(const EarthShadowLight& light);
/// Throws Error(input) for bytes that are no such file, of another version, cut off or too long, and for numbers that
/// no such map has.
/// \param name of where the bytes come from, for errors
[[nodiscard]] EarthShadowLight decode_earth_shadow_light(std::span<const std::byte> bytes, const std::string& name);

/// Throws Error(file), too, where the file cannot be read.
[[nodiscard]] EarthShadowLight read_earth_shadow_light(const std::filesystem::path& path);
/// Puts the file in its place whole or not at all. Throws Error(file).
void write_earth_shadow_light(const std::filesystem::path& path, const EarthShadowLight& light);

} // namespace vesper
