// What every program does alike: help, version, logging to standard error, exit codes.
#pragma once

#include "common/option_text.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <fmt/format.h>
#include <functional>
#include <string>
#include <string_view>

namespace vesper {

/// Makes `app` follow the conventions of all programs: a repeated option takes its last value, options of the program
/// may also stand after a subcommand, and --version, --verbose and --quiet exist. Call it before adding options.
void prepare_program(CLI::App& app);

/// Parses the command line, calls `work` and turns what goes wrong into one line on standard error.
/// \return the exit status: 0, 2 for the command line and Error(argument), 1 for any other failure
[[nodiscard]] int run_program(int argc, char** argv, CLI::App& app, const std::function<void()>& work);

/// Takes numbers in [lowest, highest]. CLI::Range takes "nan" as well.
template <class Number> [[nodiscard]] CLI::Validator numbers_within(Number lowest, Number highest) {
  const std::string range = fmt::format("{} to {}", lowest, highest);
  return {[=](const std::string& text) {
            return number_within(text, lowest, highest) ? std::string()
                                                        : fmt::format("'{}' is not allowed; allowed: {}", text, range);
          },
          ""};
}

/// Writes and flushes data to standard output. Throws Error(file) when that fails (a full disk behind a redirection).
void write_standard_output(std::string_view text);

} // namespace vesper
