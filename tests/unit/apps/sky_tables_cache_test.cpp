#include "support/folder_test.hpp"
#include "support/numbered_tables.hpp"

#include "common/sky_tables_cache.hpp"

#include "vesper/atmosphere/earth_shadow_file.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables_file.hpp"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace vesper::test {
namespace {

namespace fs = std::filesystem;

class SkyTablesCache : public FolderTest {
protected:
  void SetUp() override {
    FolderTest::SetUp();
    cache_ = folder() / "cache";
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(said_)));
  }

  [[nodiscard]] std::shared_ptr<const SkyTables> tables(const fs::path& folder) const {
    return cached_sky_tables(
        fingerprint_,
        [this] {
          // A byte each time, from whatever process.
          std::ofstream(path("made"), std::ios::app) << '.';
          std::this_thread::sleep_for(making_takes_);
          return numbered_tables();
        },
        folder);
  }
  [[nodiscard]] Bytes encoded(const SkyTables& tables) const { return encode_sky_tables(tables, fingerprint_); }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(cache_)) {
      if (entry.path().filename() != "sky.lock") {
        names.push_back(entry.path().filename().string());
      }
    }
    return names;
  }
  /// What was logged since the last call.
  std::string said() {
    std::string text = said_.str();
    said_.str("");
    return text;
  }

  /// How often tables were made.
  [[nodiscard]] std::size_t times_made() const { return fs::exists(path("made")) ? fs::file_size(path("made")) : 0; }

  std::chrono::milliseconds making_takes_{0};
  std::string fingerprint_ = std::string(64, 'a');
  std::string name_ = sky_tables_file_name(fingerprint_);
  fs::path cache_;

private:
  std::ostringstream said_;
};

TEST_F(SkyTablesCache, KeepsWhatWasMade) {
  const Bytes made = encoded(*tables(cache_));
  EXPECT_EQ(files(), std::vector{name_});
  EXPECT_EQ(read_file(cache_ / name_), made);
  const auto written = fs::last_write_time(cache_ / name_);
  fs::last_write_time(cache_ / name_, written - std::chrono::hours(1));
  EXPECT_EQ(encoded(*tables(cache_)), made);
  EXPECT_GE(fs::last_write_time(cache_ / name_), written) << "used, so that it is not among the oldest";
  EXPECT_EQ(times_made(), 1U);
  EXPECT_EQ(said(), "");
}

TEST_F(SkyTablesCache, ReplacesAFileThatIsNotWhole) {
  const Bytes made = encoded(*tables(cache_));
  Bytes altered = made;
  altered[made.size() / 2] ^= std::byte{1};
  const Bytes cut(made.begin(), made.begin() + 1000);
  for (const Bytes& broken : {altered, cut, Bytes{}}) {
    write_file_atomically(cache_ / name_, broken);
    EXPECT_EQ(encoded(*tables(cache_)), made);
    const std::string warning = said();
    EXPECT_NE(warning.find(name_), std::string::npos) << warning;
    EXPECT_NE(warning.find("made anew"), std::string::npos) << warning;
    EXPECT_EQ(std::count(warning.begin(), warning.end(), '\n'), 1) << warning;
    EXPECT_EQ(read_file(cache_ / name_), made);
    EXPECT_EQ(files(), std::vector{name_}) << "no other file is left";
  }
}

TEST_F(SkyTablesCache, DoesWithoutAFolder) {
  const Bytes made = encoded(*tables(cache_));
  EXPECT_EQ(encoded(*tables({})), made);
  EXPECT_EQ(said(), "");
  write("no_folder", "a file");
  EXPECT_EQ(encoded(*tables(folder() / "no_folder" / "cache")), made);
  EXPECT_NE(said().find("not kept"), std::string::npos);
  if (::geteuid() != 0) { // whom no mode keeps out
    const fs::path read_only = folder() / "read_only";
    fs::create_directory(read_only);
    fs::permissions(read_only, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(encoded(*tables(read_only)), made);
    EXPECT_NE(said().find("not kept"), std::string::npos);
  }
}

TEST_F(SkyTablesCache, KeepsTheLightInTheEarthsShadow) {
  const Bytes made = encode_earth_shadow_light(cached_earth_shadow_light(clear_medium(), cache_));
  EXPECT_EQ(made, encode_earth_shadow_light(default_earth_shadow_light()));
  ASSERT_EQ(files().size(), 1U);
  const fs::path file = cache_ / files().front();
  EXPECT_EQ(read_file(file), made);
  // What is there is read, not made: a file that says something else.
  EarthShadowLight other = default_earth_shadow_light();
  other.nearest_sun_au = 0.9;
  write_earth_shadow_light(file, other);
  EXPECT_EQ(cached_earth_shadow_light(clear_medium(), cache_).nearest_sun_au, 0.9);
  EXPECT_EQ(said(), "");
  write_file_atomically(file, Bytes(100));
  EXPECT_EQ(encode_earth_shadow_light(cached_earth_shadow_light(clear_medium(), cache_)), made);
  EXPECT_NE(said().find("made anew"), std::string::npos);
  EXPECT_EQ(read_file(file), made);
  write("no_folder", "a file");
  EXPECT_EQ(encode_earth_shadow_light(cached_earth_shadow_light(clear_medium(), folder() / "no_folder" / "cache")),
            made);
  EXPECT_NE(said().find("not kept"), std::string::npos);
  EXPECT_NE(earth_shadow_fingerprint(clear_medium()), earth_shadow_fingerprint(published_medium()));
}

TEST_F(SkyTablesCache, KeepsTheTwentyUsedLast) {
  fs::create_directories(cache_);
  const auto now = fs::file_time_type::clock::now();
  for (int i = 0; i < 25; ++i) {
    const fs::path old = cache_ / ("sky-" + std::to_string(i) + ".tables");
    write_file_atomically(old, std::string("old"));
    fs::last_write_time(old, now - std::chrono::hours(1 + i));
  }
  write_file_atomically(cache_ / "another_file", std::string("kept"));
  static_cast<void>(tables(cache_));
  EXPECT_EQ(files().size(), 21U);
  EXPECT_TRUE(fs::exists(cache_ / name_));
  EXPECT_TRUE(fs::exists(cache_ / "sky-18.tables"));
  EXPECT_FALSE(fs::exists(cache_ / "sky-19.tables"));
  EXPECT_TRUE(fs::exists(cache_ / "another_file"));
}

TEST_F(SkyTablesCache, ManyProcessesAtOnceMakeThemOnce) {
  const Bytes made = encoded(numbered_tables());
  making_takes_ = std::chrono::milliseconds(300); // in which the others come
  constexpr int processes = 4;
  for (int i = 0; i < processes; ++i) {
    if (::fork() == 0) {
      bool same = false;
      try {
        same = encoded(*tables(cache_)) == made;
      } catch (...) {
      }
      const bool clean = said().empty();
      ::_exit(same && clean ? 0 : 1);
    }
  }
  for (int i = 0; i < processes; ++i) {
    int status = 1;
    ASSERT_GT(::wait(&status), 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(times_made(), 1U) << "one has worked, the others have waited";
  EXPECT_EQ(files(), std::vector{name_});
}

TEST(UserCacheFolder, FollowsTheBaseDirectorySpecification) {
  const auto with = [](const char* cache, const char* home) {
    ::setenv("XDG_CACHE_HOME", cache, 1); // NOLINT(concurrency-mt-unsafe)
    ::setenv("HOME", home, 1);            // NOLINT(concurrency-mt-unsafe)
    return user_cache_folder();
  };
  EXPECT_EQ(with("/var/cache", "/home/her"), "/var/cache/vesper");
  EXPECT_EQ(with("relative", "/home/her"), "/home/her/.cache/vesper");
  EXPECT_EQ(with("", "/home/her"), "/home/her/.cache/vesper");
  EXPECT_EQ(with("", ""), "");
}

} // namespace
} // namespace vesper::test
