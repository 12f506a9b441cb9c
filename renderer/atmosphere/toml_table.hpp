// A table of a TOML file, read strictly: whatever is wrong names file, line and key.
#pragma once

#include "vesper/atmosphere/quantity_text.hpp"

#include <initializer_list>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {

/// The least and the largest value that is allowed.
struct Range {
  double lowest;
  double highest;
};
/// Whoever reads it checks what is allowed.
inline constexpr Range any_number{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

/// Reads what stands under a key. All of it throws Error(input) with file, line, key and remedy when the key is
/// missing, when its value is of another type, not finite or out of its range.
class TomlTable {
public:
  /// \param file its name in messages
  [[nodiscard]] static TomlTable parse(std::string_view text, const std::string& file);

  /// Throws for the first key that is not among these.
  void allow_only(std::initializer_list<std::string_view> keys) const;

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] bool has_table(std::string_view key) const;

  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key, Range range) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view key, Range range) const;
  /// Text with a unit; the range is in the kind's own unit.
  [[nodiscard]] double quantity(std::string_view key, QuantityKind kind, Range range) const;
  [[nodiscard]] std::vector<double> quantities(std::string_view key, QuantityKind kind, Range range) const;
  [[nodiscard]] TomlTable table(std::string_view key) const;
  /// An array of tables; empty where the key is missing.
  [[nodiscard]] std::vector<TomlTable> tables(std::string_view key) const;

  /// The place is that of the key's value; where there is none, or for an empty key, that of the table.
  [[noreturn]] void fail(std::string_view key, const std::string& message, const std::string& remedy) const;

private:
  struct Document;
  TomlTable(std::shared_ptr<const Document> document, const void* table, std::string path);

  [[noreturn]] void fail_type(std::string_view key, const char* wanted) const;
  void hold(std::string_view key, const std::vector<double>& values, Range range, std::string_view unit) const;

  std::shared_ptr<const Document> document_;
  const void* table_; ///< toml++'s, within the document
  std::string path_;  ///< of this table, with a dot behind it
};

} // namespace vesper
