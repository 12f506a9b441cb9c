// Reading the texts of options, and refusing them.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace vesper {

/// A finite number that takes up the whole text; a plus sign may stand before it.
template <class Number> [[nodiscard]] std::optional<Number> parse_number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    return std::nullopt;
  }
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(value)) {
      return std::nullopt;
    }
  }
  return value;
}

/// The number, if it is one and lies in [lowest, highest].
template <class Number>
[[nodiscard]] std::optional<Number> number_within(std::string_view text, Number lowest, Number highest) {
  const std::optional<Number> value = parse_number<Number>(text);
  return value && *value >= lowest && *value <= highest ? value : std::nullopt;
}

/// What stands between the commas, blanks and empty items included; of an empty text one empty item.
[[nodiscard]] std::vector<std::string_view> list_items(std::string_view text);

/// Throws Error(argument) in the words of all programs: "--option: 'value' is not allowed; allowed: ...".
[[noreturn]] void refuse_option(std::string_view option, std::string_view value, std::string_view allowed);

} // namespace vesper
