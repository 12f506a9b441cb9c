// The same scene in two processes gives identical bytes.
#include "vesper/base/files.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace vesper::test {
namespace {

Bytes rendered(const std::filesystem::path& path, const std::string& options) {
  const std::string command =
      std::string(VESPER_BIN) +
      "/vesper-render --quiet --layers stars,planets,ground --time 2026-11-22T22:00:00Z --latitude 40 " +
      "--longitude -3.7 --seed 3 " + options + " -o " + path.string();
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return read_file(path);
}

class Determinism : public testing::TestWithParam<const char*> {};

TEST_P(Determinism, TwoProcessesGiveTheSameBytes) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("vesper_determinism_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  for (const char* ending : {".png", ".exr"}) {
    const Bytes first = rendered(folder / (std::string("first") + ending), GetParam());
    const Bytes second = rendered(folder / (std::string("second") + ending), GetParam());
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(first, second) << ending;
  }
  std::filesystem::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism,
                         testing::Values("--size 600x600",
                                         "--projection perspective --altitude 30 --fov 60 --size 640x360",
                                         "--projection cubemap --altitude 0 --size 128x768",
                                         "--tier cheap --size 300x300"));

} // namespace
} // namespace vesper::test
