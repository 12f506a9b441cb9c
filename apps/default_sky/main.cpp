// Makes the tables of the default medium's sky into a folder, unless they are there: a tool of the build.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables_file.hpp"
#include "vesper/base/error.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>

namespace vesper {
namespace {

namespace fs = std::filesystem;

bool is_up_to_date(const fs::path& path, std::string_view fingerprint) {
  try {
    static_cast<void>(read_sky_tables(path, fingerprint));
    return true;
  } catch (const Error&) {
    return false; // not there, or not whole
  }
}

void make_default_sky(const fs::path& folder) {
  const Medium medium = clear_medium();
  const std::string fingerprint = sky_tables_fingerprint(medium);
  const fs::path path = folder / sky_tables_file_name(fingerprint);
  if (is_up_to_date(path, fingerprint)) {
    return;
  }
  fs::create_directories(folder);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == path.extension()) {
      fs::remove(entry.path()); // of an older solver
    }
  }
  write_sky_tables(path, make_sky_tables(medium), fingerprint);
}

} // namespace
} // namespace vesper

int main(int argc, char** argv) {
  try {
    if (argc != 2) {
      throw std::runtime_error("takes the folder to write to");
    }
    vesper::make_default_sky(argv[1]);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "vesper_make_default_sky: %s\n", e.what());
    return 1;
  }
}
