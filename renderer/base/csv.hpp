// Tables of comma-separated values (RFC 4180) with errors that name the row and the column.
#pragma once

#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {

/// A table in memory. The first row names the columns; every row has as many fields.
///
/// Fields may be quoted, then hold commas, line breaks and doubled quotes. Lines end in LF or CRLF; empty lines and a
/// byte order mark at the start are skipped. Fields are kept as they stand, header names without spaces around them.
class CsvTable {
public:
  /// \param file what errors call the table
  /// Throws Error(input) naming line and column: no header, a name twice, a wrong number of fields, a broken quotation.
  CsvTable(Bytes data, std::string file);

  /// What errors call the table.
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::vector<std::string_view>& header() const { return header_; }
  [[nodiscard]] std::size_t row_count() const { return lines_.size(); }
  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t column) const {
    return cells_[row * header_.size() + column];
  }
  /// Line of the file on which a row begins, from 1.
  [[nodiscard]] std::size_t line(std::size_t row) const { return lines_[row]; }

  [[nodiscard]] std::optional<std::size_t> find_column(std::string_view name) const;
  /// Throws Error(input) naming the file and the columns it has.
  [[nodiscard]] std::size_t column(std::string_view name) const;

  /// The finite number in a cell, spaces around it ignored. Throws Error(input) naming line, column and value.
  [[nodiscard]] double number(std::size_t row, std::size_t column) const;
  /// The same, which must lie in [lowest, highest].
  [[nodiscard]] double number(std::size_t row, std::size_t column, double lowest, double highest) const;

  /// The file, the line and the column, for errors about a cell.
  [[nodiscard]] ErrorContext context(std::size_t row, std::size_t column) const;
  /// Throws Error(input) that names the row's line, the column and the cell's text.
  [[noreturn]] void fail(std::size_t row, std::size_t column, const std::string& message) const;

private:
  std::vector<char> text_; ///< what all views point into; quoted fields are unquoted in place
  std::string file_;
  std::vector<std::string_view> header_;
  std::vector<std::string_view> cells_;
  std::vector<std::size_t> lines_;
};

/// Appends a field, quoted when it must be.
void append_csv_field(std::string& row, std::string_view field);

/// Appends the shortest text that reads back as the same number; nothing for what is not a number.
void append_number(std::string& row, double number);

} // namespace vesper
