#include "vesper/catalog_tools/fixed_width.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace vesper {
namespace {

constexpr std::string_view digits = "0123456789";

} // namespace

std::string_view FixedWidthRecord::raw(const Field& field) const {
  if (text_.size() < field.first) {
    return {};
  }
  return text_.substr(field.first - 1, field.last - field.first + 1);
}

std::string_view FixedWidthRecord::text(const Field& field) const {
  const std::string_view value = raw(field);
  const std::size_t begin = value.find_first_not_of(' ');
  if (begin == std::string_view::npos) {
    return {};
  }
  return value.substr(begin, value.find_last_not_of(' ') - begin + 1);
}

std::optional<double> FixedWidthRecord::number(const Field& field, Range range) const {
  const std::string_view value = text(field);
  if (value.empty()) {
    return std::nullopt;
  }
  // from_chars reads "inf", "1e5" and stops at a blank inside; a plain decimal number has none of these.
  const std::size_t sign = value[0] == '+' || value[0] == '-' ? 1 : 0;
  const std::string_view magnitude = value.substr(sign);
  const bool plain = magnitude.find_first_not_of("0123456789.") == std::string_view::npos &&
                     magnitude.find_first_of(digits) != std::string_view::npos &&
                     std::count(magnitude.begin(), magnitude.end(), '.') <= 1;
  double number = 0.0;
  if (!plain || std::from_chars(magnitude.data(), magnitude.data() + magnitude.size(), number).ec != std::errc()) {
    fail_value(field, "is not a number", range);
  }
  if (value[0] == '-') {
    number = -number;
  }
  if (!(number >= range.min && number <= range.max)) {
    fail_value(field, "is out of range", range);
  }
  return number;
}

double FixedWidthRecord::required(const Field& field, Range range) const {
  const std::optional<double> value = number(field, range);
  if (!value) {
    fail_value(field, "is blank", range);
  }
  return *value;
}

std::optional<unsigned> FixedWidthRecord::whole(const Field& field, Range range) const {
  if (text(field).find_first_not_of(digits) != std::string_view::npos) {
    fail_value(field, "is not a whole number", range);
  }
  const std::optional<double> value = number(field, range);
  return value ? std::optional(static_cast<unsigned>(*value)) : std::nullopt;
}

void FixedWidthRecord::fail(const Field& field, const std::string& message, const std::string& remedy) const {
  throw Error(ErrorKind::input, message, {*file_, fmt::format("line {}, column {}", line_, field.first), remedy});
}

void FixedWidthRecord::fail_value(const Field& field, const char* what, Range range) const {
  fail(field, fmt::format("{} \"{}\" {}; allowed are {} to {}", field.name, raw(field), what, range.min, range.max),
       fmt::format("Correct columns {} to {} of this line or fetch the catalogue again", field.first, field.last));
}

} // namespace vesper
