#include "common/program.hpp"

#include "vesper/base/error.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>

namespace vesper {
namespace {

constexpr int success = 0;
constexpr int work_failed = 1;
constexpr int bad_options = 2;

void start_logging(const CLI::App& app) {
  auto logger = std::make_shared<spdlog::logger>(app.get_name(), std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("%n: %v");
  logger->set_level(app.count("--quiet") > 0     ? spdlog::level::err
                    : app.count("--verbose") > 0 ? spdlog::level::debug
                                                 : spdlog::level::info);
  spdlog::set_default_logger(std::move(logger));
}

/// CLI11 takes the next argument as the value of "--output=", so that "--output= --json" would write a file "--json".
void require_values(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument.starts_with("--") && argument.size() > 3 && argument.find('=') == argument.size() - 1) {
      throw CLI::ArgumentMismatch(std::string(argument.substr(0, argument.size() - 1)) + ": no value follows the '='");
    }
  }
}

} // namespace

void prepare_program(CLI::App& app) {
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.fallthrough();
  app.set_version_flag("--version", app.get_name() + " " VESPER_VERSION, "Print the version and exit");
  app.add_flag("--verbose")->description("Say more on standard error");
  app.add_flag("--quiet")->description("Say nothing but errors on standard error");
}

int run_program(int argc, char** argv, CLI::App& app, const std::function<void()>& work) {
  try {
    require_values(argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      return app.exit(e); // --help and --version
    }
    std::fprintf(stderr, "%s: %s. See %s --help\n", app.get_name().c_str(), e.what(), app.get_name().c_str());
    return bad_options;
  }
  // A file that grows past the limit of the process must be an error message, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    start_logging(app);
    work();
    return success;
  } catch (const Error& e) {
    spdlog::error("{}", e.what());
    return e.kind() == ErrorKind::argument ? bad_options : work_failed;
  } catch (const std::bad_alloc&) {
    spdlog::error("not enough memory");
  } catch (const std::exception& e) {
    spdlog::error("{}", e.what());
  }
  return work_failed;
}

void write_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw Error(ErrorKind::file, std::string("cannot be written: ") + std::strerror(errno),
                {"standard output", "", "Check where it leads to"});
  }
}

} // namespace vesper
