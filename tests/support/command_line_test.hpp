// A program as a person uses it: what it prints, writes and returns.
#pragma once

#include "support/folder_test.hpp"

#include "vesper/base/csv.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace vesper::test {

struct CommandResult {
  int status = -1;
  std::string out, err;
};

/// Runs one program of VESPER_BIN, each test in a folder of its own, without the user's settings and with a cache that
/// all tests share.
class CommandLineTest : public FolderTest {
protected:
  /// \param command comes before all arguments
  explicit CommandLineTest(const std::string& program, std::string command = "")
      : program_("'" VESPER_BIN "/" + program + "'"), command_(std::move(command)) {}

  [[nodiscard]] CsvTable table(const std::string& name) const { return {read_file(path(name)), name}; }
  /// What a program printed as CSV.
  [[nodiscard]] CsvTable table_of(const CommandResult& result) const {
    write("table.csv", result.out);
    return table("table.csv");
  }

  /// Runs the program in its folder with these arguments, after `before` in the same shell.
  [[nodiscard]] CommandResult run(const std::string& arguments, const std::string& before = ":") const {
    return run_with(command_, arguments, before);
  }
  /// The same with another command.
  [[nodiscard]] CommandResult run_with(const std::string& command, const std::string& arguments,
                                       const std::string& before = ":") const {
    // What it prints is kept outside of the folder, so that a test can look at all that was written there.
    const std::string out = folder().string() + ".out";
    const std::string err = folder().string() + ".err";
    const std::string line = "cd '" + folder().string() +
                             "' && export XDG_CONFIG_HOME=\"$PWD\" XDG_CACHE_HOME='" VESPER_BIN "/../cache' && (" +
                             before + " && exec " + program_ + " " + command + " " + arguments + ") >'" + out +
                             "' 2>'" + err + "'";
    const int status = std::system(line.c_str()); // NOLINT(cert-env33-c,concurrency-mt-unsafe)
    CommandResult result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, text(out), text(err)};
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return result;
  }

  /// A failure: its status, all `words` in the message, nothing on standard output, no new file.
  void expect_failure(int status, const std::string& arguments, const std::vector<std::string>& words,
                      const std::string& before = ":") const {
    const auto files = [&] {
      return std::distance(std::filesystem::directory_iterator(folder()), std::filesystem::directory_iterator());
    };
    const auto count = files();
    const CommandResult result = run(arguments, before);
    EXPECT_EQ(result.status, status) << arguments << "\n" << result.err;
    EXPECT_EQ(result.out, "") << arguments;
    for (const std::string& word : words) {
      EXPECT_NE(result.err.find(word), std::string::npos) << arguments << " should say " << word << "\n" << result.err;
    }
    EXPECT_EQ(files(), count) << arguments;
  }

private:
  std::string program_, command_;
};

} // namespace vesper::test
