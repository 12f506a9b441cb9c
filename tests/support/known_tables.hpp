// Sky tables of whole size for tests, made once for all of them.
#pragma once

#include "vesper/atmosphere/sky_tables_file.hpp"
#include "vesper/base/error.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace vesper::test {

/// Those that came with the programs, or kept in the cache of the tests (command_line_test.hpp), or made now.
inline SkyTables known_tables(const Medium& medium) {
  const std::string fingerprint = sky_tables_fingerprint(medium);
  if (std::optional<SkyTables> installed = installed_sky_tables(fingerprint)) {
    return *std::move(installed);
  }
  const std::filesystem::path folder = VESPER_BIN "/../cache/vesper";
  const std::filesystem::path path = folder / sky_tables_file_name(fingerprint);
  try {
    return read_sky_tables(path, fingerprint);
  } catch (const Error&) {
    std::filesystem::create_directories(folder);
    SkyTables tables = make_sky_tables(medium);
    write_sky_tables(path, tables, fingerprint);
    return tables;
  }
}

} // namespace vesper::test
