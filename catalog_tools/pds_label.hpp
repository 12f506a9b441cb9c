// Labels of the Planetary Data System, version 3: what a data file holds and how.
#pragma once

#include "vesper/base/error.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {

/// A label in the Object Description Language (PDS Standards Reference 3.8, chapter 12): lines KEYWORD = value, in
/// objects. Numbers keep their text, lists are kept as they stand.
class PdsLabel {
public:
  struct Statement {
    std::string object; ///< name of the innermost object, "" outside of all
    std::string key;    ///< as it stands: MAP_RESOLUTION, ^IMAGE
    std::string value;  ///< without quotes and unit
    std::string unit;   ///< "KM", without brackets, upper case; "" if none
    std::size_t line = 0;
  };

  /// \param text of the file up to END; what follows END is not looked at
  /// \param file what errors call the label
  /// Throws Error(input) naming the line: no label at all, a broken statement, quotation or comment, objects that do
  /// not match, or no END.
  PdsLabel(std::string_view text, std::string file);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::vector<Statement>& statements() const { return statements_; }

  /// The statement of an object, or nullptr. Throws Error(input) when there are two.
  [[nodiscard]] const Statement* find(std::string_view object, std::string_view key) const;
  /// The same, which must be there.
  [[nodiscard]] const Statement& get(std::string_view object, std::string_view key) const;

  /// A value as a finite number. Throws Error(input) naming line, keyword and value.
  [[nodiscard]] double number(const Statement& statement) const;
  /// The same for a whole number within 0 to 2^31 - 1.
  [[nodiscard]] int whole(const Statement& statement) const;

  /// Throws Error(input) at a statement: "KEY is VALUE; allowed is ...".
  [[noreturn]] void refuse(const Statement& statement, const std::string& allowed) const;

private:
  std::string file_;
  std::vector<Statement> statements_;
};

} // namespace vesper
