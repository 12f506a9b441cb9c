#include "common/scene_option_table.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/files.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace vesper {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const toml::source_region& where, const std::string& message,
                       const std::string& remedy) {
  throw Error(ErrorKind::argument, message,
              {path.string(), fmt::format("line {}, column {}", where.begin.line, where.begin.column), remedy});
}

std::string type_name(const toml::node& node) {
  std::ostringstream text;
  text << node.type();
  return text.str();
}

template <class Node> std::string printed(const Node& node) {
  std::ostringstream text;
  text << node;
  return text.str();
}

/// The value as an option's text, or nothing when its type does not fit.
std::optional<std::string> value_text(const toml::node& node, SceneValueKind kind) {
  const bool wants_text = kind == SceneValueKind::text || kind == SceneValueKind::time ||
                          kind == SceneValueKind::list || kind == SceneValueKind::name_or_file ||
                          kind == SceneValueKind::file || kind == SceneValueKind::number_or_text;
  const bool wants_number = kind == SceneValueKind::number || kind == SceneValueKind::number_or_text;
  if (const auto* text = node.as_string(); text != nullptr && wants_text) {
    return text->get();
  }
  if (const auto* integer = node.as_integer();
      integer != nullptr && (wants_number || kind == SceneValueKind::integer)) {
    return fmt::format("{}", integer->get());
  }
  if (const auto* number = node.as_floating_point(); number != nullptr && wants_number) {
    return fmt::format("{}", number->get());
  }
  if (kind == SceneValueKind::time && (node.is_date_time() || node.is_date())) {
    return node.is_date() ? printed(*node.as_date()) : printed(*node.as_date_time());
  }
  if (const auto* array = node.as_array(); array != nullptr && kind == SceneValueKind::list) {
    std::string joined;
    for (const toml::node& element : *array) {
      const auto* text = element.as_string();
      if (text == nullptr) {
        return std::nullopt;
      }
      joined += (joined.empty() ? "" : ",") + text->get();
    }
    return joined;
  }
  return std::nullopt;
}

const char* wanted(SceneValueKind kind) {
  switch (kind) {
  case SceneValueKind::text:
    return "a string";
  case SceneValueKind::time:
    return "a string or a date-time";
  case SceneValueKind::number:
    return "a number";
  case SceneValueKind::number_or_text:
    return "a number or a string";
  case SceneValueKind::integer:
    return "an integer";
  case SceneValueKind::list:
    return "a string or an array of strings";
  case SceneValueKind::name_or_file:
  case SceneValueKind::file:
    return "a string";
  }
  return "";
}

std::string known_keys() {
  std::vector<std::string_view> names;
  for (const SceneOptionDescription& option : scene_option_table()) {
    names.push_back(option.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

GivenOptions read_scene_file(const fs::path& path) {
  std::string source;
  try {
    const Bytes bytes = read_file(path);
    source.resize(bytes.size());
    std::transform(bytes.begin(), bytes.end(), source.begin(), [](std::byte b) { return static_cast<char>(b); });
  } catch (const Error& e) {
    throw Error(ErrorKind::argument, e.message(), e.context());
  }
  toml::table document;
  try {
    document = toml::parse(source);
  } catch (const toml::parse_error& e) {
    fail(path, e.source(), std::string(e.description()), "Correct the TOML");
  }
  GivenOptions given;
  for (const auto& [key, node] : document) {
    const std::string_view name = key.str();
    const auto table = scene_option_table();
    const auto option =
        std::find_if(table.begin(), table.end(), [&](const SceneOptionDescription& o) { return o.name == name; });
    if (option == table.end()) {
      fail(path, key.source(), fmt::format("key '{}' is unknown", name), "Known keys: " + known_keys());
    }
    auto text = value_text(node, option->kind);
    if (!text) {
      fail(path, node.source(),
           fmt::format("key '{}' holds {} of type {}", name, printed(toml::node_view<const toml::node>(node)),
                       type_name(node)),
           fmt::format("It takes {}", wanted(option->kind)));
    }
    if (option->kind == SceneValueKind::file || (option->kind == SceneValueKind::name_or_file && names_a_file(*text))) {
      text = (path.parent_path() / *text).string();
    }
    given[std::string(name)] = {
        *text, fmt::format("key '{}'", name), path.string(),
        fmt::format("line {}, column {}", node.source().begin.line, node.source().begin.column)};
  }
  return given;
}

fs::path user_settings_path() {
  const fs::path below = fs::path("vesper") / "settings.toml";
  // The XDG base directory specification has a relative path ignored.
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && fs::path(config).is_absolute()) {
    return config / below;
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    return fs::path(home) / ".config" / below;
  }
  return {};
}

} // namespace vesper
