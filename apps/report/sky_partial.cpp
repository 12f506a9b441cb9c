#include "report/sky_partial.hpp"

#include "common/option_text.hpp"

#include "vesper/base/csv.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace vesper {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw Error(ErrorKind::file, "cannot be written", {path.string(), "", "Free some space or choose another output"});
}

/// Unit and values of "7,0.5,0.25".
std::optional<std::pair<std::size_t, std::vector<double>>> parse_line(std::string_view line, std::size_t units,
                                                                      std::size_t values) {
  const std::vector<std::string_view> items = list_items(line);
  const auto unit = parse_number<std::size_t>(items.front());
  if (!unit || *unit >= units || items.size() != values + 1) {
    return std::nullopt;
  }
  std::pair<std::size_t, std::vector<double>> parsed{*unit, {}};
  for (std::size_t i = 1; i < items.size(); ++i) {
    const auto value = parse_number<double>(items[i]);
    if (!value) {
      return std::nullopt;
    }
    parsed.second.push_back(*value);
  }
  return parsed;
}

} // namespace

PartialResults::PartialResults(std::filesystem::path path, const std::string& request, std::size_t units,
                               std::size_t values)
    : path_(std::move(path)) {
  const std::string first_line = request + "\n";
  std::size_t sound = 0; // bytes
  if (std::error_code not_there; std::filesystem::exists(path_, not_there)) {
    const Bytes bytes = read_file(path_);
    std::string text(bytes.size(), '\0');
    std::transform(bytes.begin(), bytes.end(), text.begin(), [](std::byte b) { return static_cast<char>(b); });
    if (text.starts_with(first_line)) {
      sound = first_line.size();
    } else if (!first_line.starts_with(text)) {
      throw Error(
          ErrorKind::input, "holds the results of another request, perhaps of another instant",
          {path_.string(), "line 1", "Repeat that request to finish it, or delete the file, or choose another output"});
    }
    for (std::size_t end = 0; sound > 0 && (end = text.find('\n', sound)) != std::string::npos; sound = end + 1) {
      auto parsed = parse_line(std::string_view(text).substr(sound, end - sound), units, values);
      if (!parsed) {
        break;
      }
      finished_.insert(std::move(*parsed));
    }
    std::error_code failed;
    std::filesystem::resize_file(path_, sound, failed);
    if (failed) {
      fail(path_);
    }
  }
  file_.open(path_, std::ios::app | std::ios::binary);
  if (sound == 0) {
    file_ << first_line;
  }
  if (!file_.flush()) {
    fail(path_);
  }
}

void PartialResults::add(std::size_t unit, const std::vector<double>& values) {
  std::string line = std::to_string(unit);
  for (const double value : values) {
    line += ',';
    append_number(line, value);
  }
  file_ << line + '\n';
  if (!file_.flush()) {
    fail(path_);
  }
  finished_[unit] = values;
}

} // namespace vesper
