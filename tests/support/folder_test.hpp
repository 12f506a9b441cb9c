// A test that reads and writes files.
#pragma once

#include "vesper/base/files.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <string>

namespace vesper::test {

/// Each test has a folder of its own, which goes with it.
class FolderTest : public testing::Test {
protected:
  void SetUp() override {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("vesper_") + test.test_suite_name() + "_" + test.name() + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// What a file holds.
  /// \param name in the folder, or a whole path
  [[nodiscard]] std::string text(const std::string& name) const {
    const Bytes bytes = read_file(folder_ / name);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  std::string write(const std::string& name, const std::string& text) const { // NOLINT(modernize-use-nodiscard)
    write_file_atomically(folder_ / name, text);
    return path(name);
  }

private:
  std::filesystem::path folder_;
};

} // namespace vesper::test
