#include "vesper/base/csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

namespace vesper {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Walks over the text field by field.
class Scanner {
public:
  Scanner(std::vector<char>& text, const std::string& file) : text_(text), file_(file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (std::string_view(text.data(), text.size()).starts_with(byte_order_mark)) {
      at_ = byte_order_mark.size();
    }
  }

  /// Reads the next line that is not empty into `fields`; false at the end of the text.
  bool row(std::vector<std::string_view>& fields) {
    while (!end() && at_line_break()) {
      skip_line_break();
    }
    if (end()) {
      return false;
    }
    row_line_ = line_;
    column_ = 1;
    fields.push_back(field());
    while (!end() && text_[at_] == ',') {
      ++at_;
      ++column_;
      fields.push_back(field());
    }
    if (!end()) {
      skip_line_break();
    }
    return true;
  }

  [[nodiscard]] std::size_t row_line() const { return row_line_; }

private:
  [[nodiscard]] bool end() const { return at_ == text_.size(); }
  [[nodiscard]] bool at_line_break() const {
    return text_[at_] == '\n' || (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n');
  }
  void skip_line_break() {
    at_ += text_[at_] == '\r' ? 2U : 1U;
    ++line_;
  }

  std::string_view field() { return !end() && text_[at_] == '"' ? quoted_field() : plain_field(); }

  std::string_view plain_field() {
    const std::size_t begin = at_;
    while (!end() && text_[at_] != ',' && !at_line_break()) {
      if (text_[at_] == '"') {
        fail("a quotation mark stands inside a field that does not begin with one");
      }
      ++at_;
    }
    return {text_.data() + begin, at_ - begin};
  }

  std::string_view quoted_field() {
    const std::size_t begin = at_++;
    const std::size_t begin_line = line_;
    std::size_t write = begin;
    for (;; ++at_) {
      if (end()) {
        line_ = begin_line;
        fail("a quoted field has no end");
      }
      if (text_[at_] == '"') {
        if (at_ + 1 == text_.size() || text_[at_ + 1] != '"') {
          break;
        }
        ++at_; // a doubled quotation mark stands for one
      }
      line_ += text_[at_] == '\n' ? 1U : 0U;
      text_[write++] = text_[at_];
    }
    ++at_;
    if (!end() && text_[at_] != ',' && !at_line_break()) {
      fail("text follows the end of a quoted field");
    }
    return {text_.data() + begin, write - begin};
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorKind::input, message,
                {file_, "line " + std::to_string(line_) + ", column " + std::to_string(column_),
                 "Quote fields that hold commas or quotation marks, and double the marks inside"});
  }

  std::vector<char>& text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t row_line_ = 1;
  std::size_t column_ = 1;
};

} // namespace

CsvTable::CsvTable(Bytes data, std::string file) : text_(data.size()), file_(std::move(file)) {
  if (!data.empty()) {
    std::memcpy(text_.data(), data.data(), data.size());
  }
  Scanner scanner(text_, file_);
  if (!scanner.row(header_)) {
    throw Error(ErrorKind::input, "the table is empty", {file_, "", "The first line must name the columns"});
  }
  for (std::string_view& name : header_) {
    name = trimmed(name);
  }
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (find_column(header_[i]) != i) {
      throw Error(ErrorKind::input, "column '" + std::string(header_[i]) + "' stands twice in the header",
                  {file_, "line " + std::to_string(scanner.row_line()) + ", column " + std::to_string(i + 1), ""});
    }
  }
  while (scanner.row(cells_)) {
    const std::size_t fields = cells_.size() - lines_.size() * header_.size();
    if (fields != header_.size()) {
      throw Error(ErrorKind::input,
                  std::to_string(fields) + " fields where the header has " + std::to_string(header_.size()),
                  {file_, "line " + std::to_string(scanner.row_line()), ""});
    }
    lines_.push_back(scanner.row_line());
  }
}

std::optional<std::size_t> CsvTable::find_column(std::string_view name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  return found == header_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - header_.begin()));
}

std::size_t CsvTable::column(std::string_view name) const {
  if (const auto found = find_column(name)) {
    return *found;
  }
  std::string present;
  for (const std::string_view have : header_) {
    present.append(present.empty() ? "" : ", ").append(have);
  }
  throw Error(ErrorKind::input, "there is no column '" + std::string(name) + "'",
              {file_, "line 1", "The table has: " + present});
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  std::string_view text = trimmed(cell(row, column));
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    fail(row, column, "is not a number");
  }
  return value;
}

double CsvTable::number(std::size_t row, std::size_t column, double lowest, double highest) const {
  const double value = number(row, column);
  if (value < lowest || value > highest) {
    std::string range = "is not in ";
    append_number(range, lowest);
    range += " to ";
    append_number(range, highest);
    fail(row, column, range);
  }
  return value;
}

ErrorContext CsvTable::context(std::size_t row, std::size_t column) const {
  return {file_, "line " + std::to_string(line(row)) + ", column " + std::string(header_[column]), ""};
}

void CsvTable::fail(std::size_t row, std::size_t column, const std::string& message) const {
  throw Error(ErrorKind::input, "'" + std::string(cell(row, column)) + "' " + message, context(row, column));
}

void append_csv_field(std::string& row, std::string_view field) {
  if (field.find_first_of(",\"\r\n") == std::string_view::npos) {
    row += field;
    return;
  }
  row += '"';
  for (const char c : field) {
    row.append(c == '"' ? 2 : 1, c);
  }
  row += '"';
}

void append_number(std::string& row, double number) {
  if (std::isnan(number)) {
    return;
  }
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  row.append(digits.data(), result.ptr);
}

} // namespace vesper
