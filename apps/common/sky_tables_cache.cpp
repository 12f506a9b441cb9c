#include "common/sky_tables_cache.hpp"

#include "common/progress_bar.hpp"

#include "vesper/atmosphere/earth_shadow_file.hpp"
#include "vesper/atmosphere/sky_tables_file.hpp"
#include "vesper/atmosphere/small_sky_tables.hpp"
#include "vesper/base/error.hpp"

#include <spdlog/spdlog.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace vesper {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 20; // about 12 MiB each, 0.2 the light in the Earth's shadow

/// Holds a folder for one process at a time, as far as the system lets it: without the lock, work may be done twice.
class FolderLock {
public:
  explicit FolderLock(const fs::path& folder)
      : file_(::open((folder / "sky.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    if (file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      spdlog::debug("another program is making tables of a sky: waiting for it");
      while (::flock(file_, LOCK_EX) != 0 && errno == EINTR) {
      }
    }
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (file_ >= 0) {
      ::close(file_); // which unlocks it
    }
  }

private:
  int file_;
};

/// The tables of a file; nothing where it is not there or, with a warning, where it is not whole.
std::optional<SkyTables> read_if_whole(const fs::path& path, std::string_view fingerprint,
                                       spdlog::level::level_enum level) {
  std::error_code not_there;
  if (!fs::exists(path, not_there)) {
    return std::nullopt;
  }
  try {
    SkyTables tables = read_sky_tables(path, fingerprint);
    std::error_code read_only;
    fs::last_write_time(path, fs::file_time_type::clock::now(), read_only); // it is in use
    return tables;
  } catch (const Error& e) {
    spdlog::log(level, "the tables of the sky are made anew: {}", e.what());
    return std::nullopt;
  }
}

std::optional<SkyTables> read_installed(std::string_view fingerprint) {
  try {
    return installed_sky_tables(fingerprint);
  } catch (const Error& e) {
    spdlog::warn("the tables of the sky that came with the program are of no use: {}", e.what());
    return std::nullopt;
  }
}

/// Removes the files least recently used, also those that a program which came to a sudden end left half written.
void remove_oldest(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with("sky-")) {
      files.emplace_back(entry.last_write_time(), entry.path());
    }
  }
  std::sort(files.rbegin(), files.rend());
  for (std::size_t i = most_files; i < files.size(); ++i) {
    fs::remove(files[i].second);
  }
}

void keep(const fs::path& path, const std::function<void()>& write, std::string_view what) {
  try {
    write();
    remove_oldest(path.parent_path());
  } catch (const std::exception& e) { // also of the folder, where another program may be at work
    spdlog::warn("{} not kept for the next time: {}", what, e.what());
  }
}

std::shared_ptr<const SkyTables> share(SkyTables&& tables) {
  return std::make_shared<const SkyTables>(std::move(tables));
}

} // namespace

fs::path user_cache_folder() {
  // The XDG base directory specification has a relative path ignored.
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && fs::path(cache).is_absolute()) {
    return fs::path(cache) / "vesper";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    return fs::path(home) / ".cache" / "vesper";
  }
  return {};
}

std::shared_ptr<const SkyTables> scene_sky_tables(const SceneOptions& scene, unsigned threads) {
  if (scene.sky == SkyModel::small_tables) {
    return share(make_small_sky_tables(*scene.medium));
  }
  const auto make = [&] {
    constexpr std::size_t steps = 1000;
    ProgressBar bar("solving the light of the sky", steps);
    std::size_t done = 0;
    return make_sky_tables(*scene.medium, {}, threads, [&](double share) {
      const auto now = std::max(done, static_cast<std::size_t>(share * steps));
      bar.advance(now - done);
      done = now;
    });
  };
  return cached_sky_tables(sky_tables_fingerprint(*scene.medium), make, user_cache_folder());
}

std::shared_ptr<const SkyTables> cached_sky_tables(const std::string& fingerprint,
                                                   const std::function<SkyTables()>& make, const fs::path& folder) {
  const fs::path path = folder / sky_tables_file_name(fingerprint);
  if (!folder.empty()) {
    if (auto cached = read_if_whole(path, fingerprint, spdlog::level::warn)) {
      return share(*std::move(cached));
    }
  }
  if (auto installed = read_installed(fingerprint)) {
    return share(*std::move(installed));
  }
  if (folder.empty()) {
    return share(make());
  }
  std::error_code cannot; // writing the tables will tell
  fs::create_directories(folder, cannot);
  const FolderLock lock(folder);
  // Another program may have made them in the meantime.
  if (auto cached = read_if_whole(path, fingerprint, spdlog::level::debug)) {
    return share(*std::move(cached));
  }
  SkyTables tables = make();
  keep(
      path, [&] { write_sky_tables(path, tables, fingerprint); }, "the tables of the sky are");
  return share(std::move(tables));
}

EarthShadowLight cached_earth_shadow_light(const Medium& medium, const fs::path& folder) {
  if (folder.empty()) {
    return make_earth_shadow_light(medium);
  }
  const fs::path path = folder / ("sky-shadow-" + earth_shadow_fingerprint(medium).substr(0, 32));
  std::error_code not_there;
  if (fs::exists(path, not_there)) {
    try {
      EarthShadowLight light = read_earth_shadow_light(path);
      std::error_code read_only;
      fs::last_write_time(path, fs::file_time_type::clock::now(), read_only); // it is in use
      return light;
    } catch (const Error& e) {
      spdlog::warn("the light in the Earth's shadow is made anew: {}", e.what());
    }
  }
  EarthShadowLight light = make_earth_shadow_light(medium);
  std::error_code cannot; // writing the file will tell
  fs::create_directories(folder, cannot);
  keep(
      path, [&] { write_earth_shadow_light(path, light); }, "the light in the Earth's shadow is");
  return light;
}

} // namespace vesper
