#include "catalog/product_path.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>

namespace vesper {
namespace {

bool ends_as(const std::string& output, std::string_view ending) {
  const std::string own = std::filesystem::path(output).extension().string();
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == b; };
  return own.empty() || std::equal(own.begin(), own.end(), ending.begin(), ending.end(), same);
}

} // namespace

void require_product_path(const std::string& output, std::string_view ending, bool dry_run,
                          std::span<const std::string> inputs) {
  if (output.empty()) {
    if (!dry_run) {
      throw Error(ErrorKind::argument, "--output is missing",
                  {"", "", fmt::format("Give -o OUT{}, or --dry-run for the report alone", ending)});
    }
    return;
  }
  for (const std::string& input : inputs) {
    std::error_code ignored;
    if (std::filesystem::equivalent(input, output, ignored)) {
      throw Error(ErrorKind::argument, "--output names the input itself", {output, "", "Choose another path"});
    }
  }
  if (!ends_as(output, ending)) {
    throw Error(ErrorKind::argument, "--output ends in the name of another format",
                {output, "", fmt::format("End the name in {}", ending)});
  }
  require_writable(output);
}

} // namespace vesper
