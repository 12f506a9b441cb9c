// Files that the build compiles into the library (cmake/VesperEmbed.cmake).
#pragma once

#include <span>
#include <string_view>

namespace vesper {

struct EmbeddedFile {
  std::string_view name;               ///< path relative to the embedding base, with '/'
  std::span<const unsigned char> data; ///< 8-byte aligned
};

struct EmbeddedTable {
  std::span<const EmbeddedFile> files;

  /// The file of that name, or nullptr.
  [[nodiscard]] const EmbeddedFile* find(std::string_view name) const;
};

} // namespace vesper
