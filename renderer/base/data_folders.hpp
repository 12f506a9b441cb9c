// Where files that come with the library lie.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace vesper {

/// Folders to look for such files in, in this order: the one that the environment names by VESPER_DATA_DIR;
/// ../share/vesper beside the running program's folder, so that a tree may be moved as a whole; share/vesper where the
/// library was to be installed. They need not exist.
[[nodiscard]] std::vector<std::filesystem::path> data_folders();

/// The first of these files that is there; empty if none is.
[[nodiscard]] std::filesystem::path find_data_file(std::string_view name);

} // namespace vesper
