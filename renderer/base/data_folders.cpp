#include "vesper/base/data_folders.hpp"

#include <cstdlib>
#include <system_error>

namespace vesper {

namespace fs = std::filesystem;

std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders;
  const char* const named = std::getenv("VESPER_DATA_DIR"); // NOLINT(concurrency-mt-unsafe): nobody sets it
  if (named != nullptr && *named != '\0') {
    folders.emplace_back(named);
  }
  std::error_code unknown;
  if (const fs::path program = fs::read_symlink("/proc/self/exe", unknown); !unknown) {
    folders.push_back(program.parent_path().parent_path() / "share" / "vesper");
  }
  folders.emplace_back(VESPER_INSTALLED_DATA_DIR);
  return folders;
}

fs::path find_data_file(std::string_view name) {
  for (const fs::path& folder : data_folders()) {
    std::error_code not_there;
    if (fs::path path = folder / name; fs::is_regular_file(path, not_there)) {
      return path;
    }
  }
  return {};
}

} // namespace vesper
