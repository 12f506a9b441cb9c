// Fields of fixed-width records, with errors that name line and column.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vesper {

/// Where a field lies: the first and last column, counted from 1, and what it is called in messages.
struct Field {
  std::size_t first;
  std::size_t last;
  const char* name;
};

/// The values that a numeric field may have.
struct Range {
  double min;
  double max;
};

/// One record. Columns beyond its end read as blanks.
class FixedWidthRecord {
public:
  /// `text` and `file` must outlive the record. `line` counts from 1.
  FixedWidthRecord(std::string_view text, const std::string& file, std::size_t line)
      : text_(text), file_(&file), line_(line) {}

  [[nodiscard]] std::size_t size() const { return text_.size(); }
  [[nodiscard]] std::size_t line() const { return line_; }

  /// The field with its blanks; shorter than the field where the record ends earlier.
  [[nodiscard]] std::string_view raw(const Field& field) const;
  /// The field without blanks around it.
  [[nodiscard]] std::string_view text(const Field& field) const;
  [[nodiscard]] bool blank(const Field& field) const { return text(field).empty(); }

  /// The number in the field ("+1.25", " .5", "7."), nothing if it is blank. Throws Error(input) if it is not a plain
  /// decimal number or out of range.
  [[nodiscard]] std::optional<double> number(const Field& field, Range range) const;
  /// The number in a field that must not be blank.
  [[nodiscard]] double required(const Field& field, Range range) const;
  /// A whole number from digits only, nothing if the field is blank. Throws Error(input) likewise.
  [[nodiscard]] std::optional<unsigned> whole(const Field& field, Range range) const;

  /// Throws Error(input) at the column where `field` begins.
  [[noreturn]] void fail(const Field& field, const std::string& message, const std::string& remedy) const;

private:
  [[noreturn]] void fail_value(const Field& field, const char* what, Range range) const;

  std::string_view text_;
  const std::string* file_;
  std::size_t line_;
};

} // namespace vesper
