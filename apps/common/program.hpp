// What every program does alike: help, version, logging to standard error, exit codes.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <functional>
#include <string_view>

namespace vesper {

/// Makes `app` follow the conventions of all programs: a repeated option takes its last value, options of the program
/// may also stand after a subcommand, and --version, --verbose and --quiet exist. Call it before adding options.
void prepare_program(CLI::App& app);

/// Parses the command line, calls `work` and turns what goes wrong into one line on standard error.
/// \return the exit status: 0, 2 for the command line and Error(argument), 1 for any other failure
[[nodiscard]] int run_program(int argc, char** argv, CLI::App& app, const std::function<void()>& work);

/// Writes and flushes data to standard output. Throws Error(file) when that fails (a full disk behind a redirection).
void write_standard_output(std::string_view text);

} // namespace vesper
