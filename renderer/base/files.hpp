// Whole-file input and output with errors that name the file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vesper {

using Bytes = std::vector<std::byte>;

/// Reads a whole file (or pipe). Throws Error(file).
[[nodiscard]] Bytes read_file(const std::filesystem::path& path);

/// Replaces `path` by `data` or leaves it as it was: writes a temporary file in the same folder, flushes it to the
/// disk and renames it. Follows a symbolic link to its target; writes straight to what is no regular file (a pipe or a
/// device). Throws Error(file), naming the path and the system's reason; the temporary file is then removed.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> data);
void write_file_atomically(const std::filesystem::path& path, const std::string& text);

/// The same for content that is too large for memory: `write` fills the temporary file, whose path it gets. What it
/// throws leaves `path` as it was.
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// Throws Error(file) unless `path` could be created or replaced: its folder must exist and be writable, and it must
/// not be a folder itself. For failing before long work rather than after it.
void require_writable(const std::filesystem::path& path);

} // namespace vesper
