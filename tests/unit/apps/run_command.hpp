// Running a program under test and reading what it says.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace vesper::test {

struct CommandResult {
  int status = -1;
  std::string out, err;
};

inline std::string text_of(const std::string& path) {
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Runs a program of VESPER_BIN through the shell, without the user's settings; `folder` takes its output.
inline CommandResult run_command(const std::string& folder, const std::string& program, const std::string& arguments) {
  const std::string out = folder + "/stdout.txt";
  const std::string err = folder + "/stderr.txt";
  const std::string command = "XDG_CONFIG_HOME=" + folder + " '" + std::string(VESPER_BIN) + "/" + program + "' " +
                              arguments + " >" + out + " 2>" + err;
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

} // namespace vesper::test
