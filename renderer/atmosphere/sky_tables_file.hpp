// Sky tables on disk: one file, which can be told to be whole, and to be of a given medium.
//
// A file holds, in the byte order of the machine that wrote it: "VSPRSKY\0"; a number that tells the byte order; the
// version of the format; the fingerprint of what the tables were made from (64 hexadecimal digits); sizes as 32-bit
// integers, then floats; last the SHA-256 of all before it (64 hexadecimal digits).
#pragma once

#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/base/files.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace vesper {

/// A digest, as 64 hexadecimal digits, of all that make_sky_tables depends on: the medium as light meets it, the
/// tables' size, the spectrum of sunlight and the sources of the solver. Numbers count with the precision of a float,
/// so that the digest is the same wherever the library's mathematics is as good as that.
/// Throws Error(argument) as make_sky_tables does.
[[nodiscard]] std::string sky_tables_fingerprint(const Medium& medium, const SkyTableSize& size = {});

[[nodiscard]] Bytes encode_sky_tables(const SkyTables& tables, std::string_view fingerprint);

/// Throws Error(input) for bytes that are no such file, of another version or byte order, cut off, altered, or not made
/// from what `fingerprint` tells; and for numbers that no tables have.
/// \param name of where the bytes come from, for errors
[[nodiscard]] SkyTables decode_sky_tables(std::span<const std::byte> bytes, const std::string& name,
                                          std::string_view fingerprint);

/// The name that the file of a fingerprint has in a folder of tables.
[[nodiscard]] std::string sky_tables_file_name(std::string_view fingerprint);

/// Throws Error(file), too, where the file cannot be read.
[[nodiscard]] SkyTables read_sky_tables(const std::filesystem::path& path, std::string_view fingerprint);
/// The tables that came with the library (data_folders.hpp), if there are any of that fingerprint. Throws as
/// read_sky_tables does.
[[nodiscard]] std::optional<SkyTables> installed_sky_tables(std::string_view fingerprint);
/// Puts the file in its place whole or not at all. Throws Error(file).
void write_sky_tables(const std::filesystem::path& path, const SkyTables& tables, std::string_view fingerprint);

} // namespace vesper
