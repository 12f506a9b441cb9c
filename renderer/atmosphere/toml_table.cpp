#include "vesper/atmosphere/toml_table.hpp"

#include "vesper/base/error.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

namespace vesper {

struct TomlTable::Document {
  std::string file;
  toml::table root;
};

namespace {

const toml::table& as_table(const void* table) { return *static_cast<const toml::table*>(table); }

[[noreturn]] void fail_at(const std::string& file, const toml::source_region& where, const std::string& path,
                          const std::string& message, const std::string& remedy) {
  std::string place = fmt::format("line {}", where.begin.line);
  if (!path.empty()) {
    place += fmt::format(", key '{}'", path);
  }
  throw Error(ErrorKind::input, message, {file, place, remedy});
}

std::string type_name(const toml::node& node) {
  std::ostringstream text;
  text << node.type();
  return text.str();
}

constexpr std::size_t longest_word = 64; // of those that are compared

/// Letters to insert, remove or replace to turn one word into the other (Levenshtein 1966).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  a = a.substr(0, longest_word);
  b = b.substr(0, longest_word);
  std::array<std::size_t, longest_word + 1> row{};
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({replaced, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row[b.size()];
}

std::string known_keys_remedy(std::string_view key, std::initializer_list<std::string_view> keys) {
  const auto distance = [&](std::string_view known) { return edit_distance(key, known); };
  const std::string_view* nearest = std::min_element(
      keys.begin(), keys.end(), [&](std::string_view a, std::string_view b) { return distance(a) < distance(b); });
  const std::string known = fmt::format("Keys here: {}", fmt::join(keys, ", "));
  const bool near = nearest != keys.end() && distance(*nearest) <= (nearest->size() + 1) / 3;
  return near ? fmt::format("Did you mean '{}'? {}", *nearest, known) : known;
}

} // namespace

TomlTable::TomlTable(std::shared_ptr<const Document> document, const void* table, std::string path)
    : document_(std::move(document)), table_(table), path_(std::move(path)) {}

TomlTable TomlTable::parse(std::string_view text, const std::string& file) {
  try {
    auto document = std::make_shared<const Document>(Document{file, toml::parse(text)});
    const toml::table* root = &document->root;
    return {std::move(document), root, ""};
  } catch (const toml::parse_error& e) {
    fail_at(file, e.source(), "", std::string(e.description()), "Correct the TOML; is the file complete?");
  }
}

void TomlTable::fail(std::string_view key, const std::string& message, const std::string& remedy) const {
  const toml::node* node = as_table(table_).get(key);
  const toml::source_region& where = node != nullptr ? node->source() : as_table(table_).source();
  const std::string path =
      key.empty() ? path_.substr(0, path_.empty() ? 0 : path_.size() - 1) : path_ + std::string(key);
  fail_at(document_->file, where, path, message, remedy);
}

void TomlTable::fail_type(std::string_view key, const char* wanted) const {
  const toml::node* node = as_table(table_).get(key);
  if (node == nullptr) {
    fail(key, "the key is missing", fmt::format("Give {}", wanted));
  }
  fail(key, "holds a value of type " + type_name(*node), fmt::format("Give {}", wanted));
}

void TomlTable::allow_only(std::initializer_list<std::string_view> keys) const {
  for (const auto& [key, node] : as_table(table_)) {
    if (std::find(keys.begin(), keys.end(), key.str()) == keys.end()) {
      fail(key.str(), "the key is unknown", known_keys_remedy(key.str(), keys));
    }
  }
}

bool TomlTable::has(std::string_view key) const { return as_table(table_).contains(key); }

bool TomlTable::has_table(std::string_view key) const {
  const toml::node* node = as_table(table_).get(key);
  return node != nullptr && node->is_table();
}

std::string TomlTable::text(std::string_view key) const {
  const toml::node* node = as_table(table_).get(key);
  if (node == nullptr || !node->is_string()) {
    fail_type(key, "a text in quotes");
  }
  return node->as_string()->get();
}

void TomlTable::hold(std::string_view key, const std::vector<double>& values, Range range,
                     std::string_view unit) const {
  const std::string with_unit = unit.empty() ? "" : fmt::format(" {}", unit);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] >= range.lowest && values[i] <= range.highest)) {
      const std::string which = values.size() > 1 ? fmt::format(", number {} of {},", i + 1, values.size()) : "";
      fail(key, fmt::format("{:g}{}{} is out of range", values[i], with_unit, which),
           range.highest == any_number.highest
               ? "Give a finite number"
               : fmt::format("Give {:g} to {:g}{}", range.lowest, range.highest, with_unit));
    }
  }
}

double TomlTable::number(std::string_view key, Range range) const {
  const toml::node* node = as_table(table_).get(key);
  if (node == nullptr || !node->is_number()) {
    fail_type(key, "a number without a unit");
  }
  const double value = *node->value<double>();
  hold(key, {value}, range, "");
  return value;
}

std::vector<double> TomlTable::numbers(std::string_view key, Range range) const {
  const toml::node* node = as_table(table_).get(key);
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  if (array == nullptr) {
    fail_type(key, "an array of numbers without a unit");
  }
  std::vector<double> values;
  for (const toml::node& element : *array) {
    if (!element.is_number()) {
      fail(key, "holds an element of type " + type_name(element), "Give an array of numbers without a unit");
    }
    values.push_back(*element.value<double>());
  }
  hold(key, values, range, "");
  return values;
}

std::vector<double> TomlTable::quantities(std::string_view key, QuantityKind kind, Range range) const {
  const toml::node* node = as_table(table_).get(key);
  if (node == nullptr || !node->is_string()) {
    fail_type(key, fmt::format("a text in quotes: numbers with a unit, as \"1, 2 {}\"", unit_of(kind)).c_str());
  }
  std::vector<double> values;
  try {
    values = parse_quantities(node->as_string()->get(), kind);
  } catch (const Error& e) {
    fail(key, e.message(), e.context().remedy);
  }
  hold(key, values, range, unit_of(kind));
  return values;
}

double TomlTable::quantity(std::string_view key, QuantityKind kind, Range range) const {
  const std::vector<double> values = quantities(key, kind, range);
  if (values.size() != 1) {
    fail(key, fmt::format("holds {} values", values.size()), "Give one");
  }
  return values.front();
}

TomlTable TomlTable::table(std::string_view key) const {
  const toml::node* node = as_table(table_).get(key);
  if (node == nullptr || !node->is_table()) {
    fail_type(key, "a table of keys, as in { ... } or under a heading in brackets");
  }
  return {document_, node->as_table(), path_ + std::string(key) + "."};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  std::vector<TomlTable> found;
  const toml::node* node = as_table(table_).get(key);
  if (node == nullptr) {
    return found;
  }
  if (!node->is_array_of_tables()) {
    fail_type(key, fmt::format("tables under headings [[{}]]", key).c_str());
  }
  for (const toml::node& element : *node->as_array()) {
    found.push_back(TomlTable(document_, element.as_table(), path_ + std::string(key) + "."));
  }
  return found;
}

} // namespace vesper
