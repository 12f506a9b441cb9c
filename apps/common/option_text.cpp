#include "common/option_text.hpp"

#include "vesper/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vesper {

std::vector<std::string_view> list_items(std::string_view text) {
  std::vector<std::string_view> items;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    items.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return items;
}

void refuse_option(std::string_view option, std::string_view value, std::string_view allowed) {
  throw Error(ErrorKind::argument, fmt::format("{}: '{}' is not allowed; allowed: {}", option, value, allowed));
}

} // namespace vesper
