// The rules of the house as code: which folder may include which, and which may link which.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vesper::house {

/// One source file and what it includes.
struct SourceFile {
  std::string path;                  ///< from the repository's top, with '/'
  std::vector<std::string> includes; ///< as written between the quotes or brackets
};

/// One floor and what its CMakeLists.txt says it needs, other libraries left out.
struct FloorTarget {
  std::vector<std::string> public_dependencies;
  std::vector<std::string> private_dependencies;
};

using Sources = std::vector<SourceFile>;
using FloorTargets = std::map<std::string, FloorTarget>;

/// The C++ and header files under the given folders of `top`; build folders are left out.
[[nodiscard]] Sources read_sources(const std::filesystem::path& top, const std::vector<std::string>& folders);

/// The `vesper_add_floor` calls of renderer/*/ and catalog_tools/, and `target_link_libraries` of their targets.
[[nodiscard]] FloorTargets read_targets(const std::filesystem::path& top);

/// Each function returns one line for each breach of its rule, so that an empty list means the house stands.
/// A floor includes itself and lower floors only; floors of one height do not know each other; nobody includes a
/// program or a test but programs and tests.
[[nodiscard]] std::vector<std::string> upward_includes(const Sources& sources);
/// Only renderer/gpu knows OpenGL, and tests/render, where shader functions are evaluated one by one.
[[nodiscard]] std::vector<std::string> graphics_includes(const Sources& sources);
/// No file includes itself, by whatever way round.
[[nodiscard]] std::vector<std::string> include_cycles(const Sources& sources);
/// Every "vesper/..." include names a file that is there.
[[nodiscard]] std::vector<std::string> missing_includes(const Sources& sources);
/// A target links lower floors only.
[[nodiscard]] std::vector<std::string> upward_links(const FloorTargets& targets);
/// A floor links what it includes: publicly what its headers need, else whoever installs the header lacks the library.
[[nodiscard]] std::vector<std::string> unlinked_includes(const Sources& sources, const FloorTargets& targets);

} // namespace vesper::house
