#include "vesper/catalog_tools/pds_label.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace vesper {
namespace {

constexpr const char* remedy = "Give the label (.LBL, PDS version 3) that belongs to the data, as it was published";

std::string upper_case(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper;
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

bool is_key(std::string_view text) {
  const std::string_view name = text.starts_with('^') ? text.substr(1) : text;
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == ':';
  });
}

class LabelParser {
public:
  LabelParser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<PdsLabel::Statement> parse() {
    std::vector<PdsLabel::Statement> statements;
    while (true) {
      skip_blank();
      const std::size_t line = line_;
      if (text_.empty()) {
        fail(line, statements.empty() ? "is no label: it has no statement" : "the label ends without END");
      }
      const std::string key = upper_case(word());
      if (!is_key(key)) {
        fail(line, fmt::format("\"{:.40}\" stands where a keyword is expected", key));
      }
      skip_blank();
      if (!text_.starts_with('=')) {
        if (key == "END") {
          if (!objects_.empty()) {
            fail(line, fmt::format("END stands inside of the object {}", objects_.back()));
          }
          return statements;
        }
        if (key == "END_OBJECT" || key == "END_GROUP") {
          close({}, line);
          continue;
        }
        fail(line, fmt::format("{:.40} has no \"=\" and value", key));
      }
      take(1);
      PdsLabel::Statement statement{objects_.empty() ? "" : objects_.back(), key, value(), unit(), line};
      if (key == "OBJECT" || key == "GROUP") {
        objects_.push_back(upper_case(statement.value));
      } else if (key == "END_OBJECT" || key == "END_GROUP") {
        close(upper_case(statement.value), line);
      } else {
        statements.push_back(std::move(statement));
      }
    }
  }

private:
  [[noreturn]] void fail(std::size_t line, const std::string& message) const {
    throw Error(ErrorKind::input, message, {file_, fmt::format("line {}", line), remedy});
  }

  std::string_view take(std::size_t count) {
    const std::string_view taken = text_.substr(0, count);
    line_ += static_cast<std::size_t>(std::count(taken.begin(), taken.end(), '\n'));
    text_.remove_prefix(taken.size());
    return taken;
  }

  /// What stands up to and with `end`.
  std::string_view take_through(std::string_view end, const char* what) {
    const std::size_t place = text_.find(end);
    if (place == std::string_view::npos) {
      fail(line_, fmt::format("{} does not end", what));
    }
    return take(place + end.size());
  }

  void skip_blank() {
    while (!text_.empty()) {
      if (is_space(text_.front())) {
        take(1);
      } else if (text_.starts_with("/*")) {
        take_through("*/", "a comment");
      } else {
        return;
      }
    }
  }

  std::string_view word() {
    std::size_t length = 0;
    while (length < text_.size() && !is_space(text_[length]) && text_[length] != '=' && text_[length] != '<') {
      ++length;
    }
    return take(length);
  }

  std::string value() {
    skip_blank();
    if (text_.empty()) {
      fail(line_, "a value is missing");
    }
    const char first = text_.front();
    if (first == '"' || first == '\'') {
      take(1);
      const std::string_view end(&first, 1);
      const std::string_view quoted = take_through(end, "a quotation");
      return std::string(quoted.substr(0, quoted.size() - 1));
    }
    if (first == '(' || first == '{') {
      return list();
    }
    const std::string_view plain = word();
    if (plain.empty()) {
      fail(line_, "a value is missing");
    }
    return std::string(plain);
  }

  /// A list with its brackets, which may hold lists.
  std::string list() {
    std::string text;
    int depth = 0;
    do {
      if (text_.empty()) {
        fail(line_, "a list does not end");
      }
      const char c = text_.front();
      if (c == '"') {
        text += take(1);
        text += take_through("\"", "a quotation");
        continue;
      }
      depth += c == '(' || c == '{' ? 1 : 0;
      depth -= c == ')' || c == '}' ? 1 : 0;
      text += take(1);
    } while (depth > 0);
    return text;
  }

  std::string unit() {
    skip_blank();
    if (!text_.starts_with('<')) {
      return {};
    }
    take(1);
    const std::string_view bracketed = take_through(">", "a unit");
    return upper_case(bracketed.substr(0, bracketed.size() - 1));
  }

  /// \param name of the object, if the line names it
  void close(std::optional<std::string> name, std::size_t line) {
    if (objects_.empty() || (name && *name != objects_.back())) {
      fail(line, objects_.empty() ? "an object ends that did not begin"
                                  : fmt::format("{:.40} ends where {:.40} is open", *name, objects_.back()));
    }
    objects_.pop_back();
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t line_ = 1;
  std::vector<std::string> objects_;
};

} // namespace

PdsLabel::PdsLabel(std::string_view text, std::string file) : file_(std::move(file)) {
  statements_ = LabelParser(text, file_).parse();
}

const PdsLabel::Statement* PdsLabel::find(std::string_view object, std::string_view key) const {
  const Statement* found = nullptr;
  for (const Statement& statement : statements_) {
    if (statement.object == object && statement.key == key) {
      if (found != nullptr) {
        throw Error(ErrorKind::input, fmt::format("{} stands here again, first in line {}", key, found->line),
                    {file_, fmt::format("line {}", statement.line), remedy});
      }
      found = &statement;
    }
  }
  return found;
}

const PdsLabel::Statement& PdsLabel::get(std::string_view object, std::string_view key) const {
  const Statement* found = find(object, key);
  if (found == nullptr) {
    throw Error(ErrorKind::input,
                fmt::format("{} is missing{}", key, object.empty() ? "" : fmt::format(" from the object {}", object)),
                {file_, "", remedy});
  }
  return *found;
}

double PdsLabel::number(const Statement& statement) const {
  double value = 0.0;
  const std::string_view text = statement.value;
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data() + (text.starts_with('+') ? 1 : 0), end, value);
  if (status != std::errc() || stop != end || !std::isfinite(value)) {
    refuse(statement, "a number");
  }
  return value;
}

int PdsLabel::whole(const Statement& statement) const {
  int value = 0;
  const std::string_view text = statement.value;
  const char* end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, value);
  if (status != std::errc() || stop != end || value < 0) {
    refuse(statement, "a whole number from 0");
  }
  return value;
}

void PdsLabel::refuse(const Statement& statement, const std::string& allowed) const {
  throw Error(ErrorKind::input,
              fmt::format("{} is \"{:.60}{}\"; allowed is {}", statement.key, statement.value,
                          statement.unit.empty() ? "" : fmt::format(" <{:.20}>", statement.unit), allowed),
              {file_, fmt::format("line {}", statement.line), remedy});
}

} // namespace vesper
