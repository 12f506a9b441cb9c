#include "unit/include_graph.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

namespace vesper::house {
namespace {

namespace fs = std::filesystem;

/// Heights of the floors (docs/ARCHITECTURE.md). catalog_tools stands beside the renderer, on floors 0 to 2.
const std::map<std::string, int>& floor_heights() {
  static const std::map<std::string, int> heights{{"base", 0},  {"light", 1},      {"assets", 1},
                                                  {"astro", 2}, {"atmosphere", 3}, {"sky", 4},
                                                  {"plan", 5},  {"gpu", 6},        {"catalog_tools", 3}};
  return heights;
}

bool may_use(const std::string& user, const std::string& used) {
  if (user == used) {
    return true;
  }
  if (!floor_heights().contains(user)) {
    return true; // programs and tests use every floor
  }
  return used != "catalog_tools" && floor_heights().at(used) < floor_heights().at(user);
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '/');) {
    parts.push_back(part);
  }
  return parts;
}

/// "renderer/astro/time.hpp" -> "astro", "catalog_tools/bsc.hpp" -> "catalog_tools", "apps/..." -> "apps".
std::string part_of_house(const std::string& path) {
  const std::vector<std::string> parts = parts_of(path);
  if (parts.size() > 1 && parts[0] == "renderer") {
    return parts[1];
  }
  return parts.empty() ? "" : parts[0];
}

/// The floor that an include names, or "".
std::string floor_of_include(const std::string& include) {
  const std::vector<std::string> parts = parts_of(include);
  return parts.size() > 2 && parts[0] == "vesper" && floor_heights().contains(parts[1]) ? parts[1] : "";
}

/// The repository's path of an included file of the tree, or "" for one from elsewhere.
std::string tree_path(const std::string& includer, const std::string& include) {
  if (include.starts_with("vesper/shaders/")) {
    return include.substr(std::string("vesper/").size());
  }
  const std::string floor = floor_of_include(include);
  if (floor.empty() && include.find('/') != std::string::npos && !include.starts_with('.')) {
    // Programs and tests name their files from apps/ and tests/.
    for (const char* root : {"apps/", "tests/"}) {
      if (includer.starts_with(root)) {
        return (include.starts_with("common/") ? "apps/" : root) + include;
      }
    }
  }
  if (floor.empty()) {
    return (fs::path(includer).parent_path() / include).lexically_normal().generic_string();
  }
  const std::string rest = include.substr(std::string("vesper/").size());
  return floor == "catalog_tools" ? rest : "renderer/" + rest;
}

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(), [&](std::string_view b) { return text.starts_with(b); });
}

std::string breach(const SourceFile& source, const std::string& include) {
  std::string text = source.path;
  return text.append(" includes ").append(include);
}

/// What stands between the quotes or brackets of an #include line, if it is one.
std::optional<std::string> included_by(const std::string& line) {
  std::istringstream words(line);
  char hash = 0;
  std::string directive;
  char open = 0;
  std::string rest;
  if (!(words >> hash) || hash != '#' || !std::getline(words >> std::ws, directive, 'e') || directive != "includ" ||
      !(words >> open) || (open != '"' && open != '<') || !std::getline(words, rest, open == '"' ? '"' : '>')) {
    return std::nullopt;
  }
  return rest;
}

/// The text of a CMake file without its comments.
std::string without_comments(const std::string& cmake) {
  std::istringstream lines(cmake);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    text.append(line, 0, line.find('#')).append("\n");
  }
  return text;
}

/// "vesper::sky" or "vesper_sky" -> "sky"; "" for what is no floor.
std::string floor_of_target(const std::string& name) {
  for (const std::string_view prefix : {"vesper::", "vesper_"}) {
    if (name.starts_with(prefix) && floor_heights().contains(name.substr(prefix.size()))) {
      return name.substr(prefix.size());
    }
  }
  return "";
}

bool is_header(const std::string& path) { return path.ends_with(".hpp") || path.ends_with(".inl"); }

/// Everything that `first` brings along through public dependencies, itself included.
std::set<std::string> public_closure(const FloorTargets& targets, const std::vector<std::string>& first) {
  std::set<std::string> reached;
  std::vector<std::string> open = first;
  while (!open.empty()) {
    const std::string next = open.back();
    open.pop_back();
    if (reached.insert(next).second && targets.contains(next)) {
      const std::vector<std::string>& more = targets.at(next).public_dependencies;
      open.insert(open.end(), more.begin(), more.end());
    }
  }
  return reached;
}

/// Adds what a CMake call that starts with `command` says about its target: "(<target> <keyword> <library>...)".
void read_calls(const std::string& text, const std::string& command, FloorTargets& targets) {
  for (std::size_t at = text.find(command); at != std::string::npos; at = text.find(command, at + 1)) {
    const std::size_t open = text.find('(', at);
    const std::size_t close = text.find(')', open);
    if (close == std::string::npos) {
      return;
    }
    std::istringstream words(text.substr(open + 1, close - open - 1));
    std::string name;
    words >> name;
    const std::string floor = floor_heights().contains(name) ? name : floor_of_target(name);
    if (floor.empty()) {
      continue;
    }
    FloorTarget& target = targets[floor];
    std::vector<std::string>* list = nullptr;
    for (std::string word; words >> word;) {
      const std::string dependency = floor_of_target(word);
      if (word == "DEPENDS" || word == "PUBLIC" || word == "INTERFACE") {
        list = &target.public_dependencies;
      } else if (word == "PRIVATE_DEPENDS" || word == "PRIVATE") {
        list = &target.private_dependencies;
      } else if (list != nullptr && !dependency.empty()) {
        list->push_back(dependency);
      }
    }
  }
}

} // namespace

Sources read_sources(const fs::path& top, const std::vector<std::string>& folders) {
  static const std::set<std::string> kinds{".cpp", ".hpp", ".inl", ".glsl"};
  Sources sources;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(top / folder)) {
      continue;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top / folder)) {
      if (!entry.is_regular_file() || !kinds.contains(entry.path().extension().string())) {
        continue;
      }
      SourceFile source{fs::relative(entry.path(), top).generic_string(), {}};
      std::istringstream text(read_text(entry.path()));
      for (std::string line; std::getline(text, line);) {
        if (const std::optional<std::string> include = included_by(line)) {
          source.includes.push_back(*include);
        }
      }
      sources.push_back(std::move(source));
    }
  }
  std::sort(sources.begin(), sources.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return sources;
}

FloorTargets read_targets(const fs::path& top) {
  FloorTargets targets;
  for (const auto& [floor, height] : floor_heights()) {
    const fs::path folder = floor == "catalog_tools" ? top / floor : top / "renderer" / floor;
    const std::string text = without_comments(read_text(folder / "CMakeLists.txt"));
    read_calls(text, "vesper_add_floor", targets);
    read_calls(text, "target_link_libraries", targets);
  }
  return targets;
}

std::vector<std::string> upward_includes(const Sources& sources) {
  std::vector<std::string> breaches;
  for (const SourceFile& source : sources) {
    const std::string user = part_of_house(source.path);
    for (const std::string& include : source.includes) {
      // Programs include one another's files as "<folder of apps>/<file>", tests as "<folder of tests>/<file>".
      const std::string path = tree_path(source.path, include);
      const bool of_programs =
          path.starts_with("apps/") ||
          starts_with_any(include, {"apps/", "common/", "render/", "report/", "catalog/", "view/", "chart/"});
      const bool of_tests = path.starts_with("tests/") ||
                            starts_with_any(include, {"tests/", "unit/", "accuracy/", "stability/", "fuzz/"});
      const bool is_floor = floor_heights().contains(user);
      const std::string used = floor_of_include(include);
      if ((is_floor && of_programs) || ((is_floor || user == "apps") && of_tests) ||
          (!used.empty() && !may_use(user, used))) {
        breaches.push_back(breach(source, include));
      }
    }
  }
  return breaches;
}

std::vector<std::string> graphics_includes(const Sources& sources) {
  std::vector<std::string> breaches;
  for (const SourceFile& source : sources) {
    if (starts_with_any(source.path, {"renderer/gpu/", "tests/render/", "tests/bench/"})) {
      continue;
    }
    for (const std::string& include : source.includes) {
      if (starts_with_any(include, {"GL/", "GLES", "EGL/", "KHR/", "epoxy/", "GLFW/", "X11/", "gbm.h"})) {
        breaches.push_back(breach(source, include));
      }
    }
  }
  return breaches;
}

std::vector<std::string> include_cycles(const Sources& sources) {
  std::map<std::string, std::vector<std::string>> edges;
  for (const SourceFile& source : sources) {
    for (const std::string& include : source.includes) {
      edges[source.path].push_back(tree_path(source.path, include));
    }
  }
  std::vector<std::string> breaches;
  std::set<std::string> done;
  std::vector<std::string> way;
  const std::function<void(const std::string&)> visit = [&](const std::string& file) {
    if (const auto again = std::find(way.begin(), way.end(), file); again != way.end()) {
      std::string text;
      for (auto step = again; step != way.end(); ++step) {
        text.append(*step).append(" -> ");
      }
      breaches.push_back(text.append(file));
      return;
    }
    if (done.contains(file) || !edges.contains(file)) {
      return;
    }
    way.push_back(file);
    for (const std::string& next : edges.at(file)) {
      visit(next);
    }
    way.pop_back();
    done.insert(file);
  };
  for (const SourceFile& source : sources) {
    visit(source.path);
  }
  return breaches;
}

std::vector<std::string> missing_includes(const Sources& sources) {
  std::set<std::string> present;
  for (const SourceFile& source : sources) {
    present.insert(source.path);
  }
  std::vector<std::string> breaches;
  for (const SourceFile& source : sources) {
    for (const std::string& include : source.includes) {
      if (include.starts_with("vesper/") && !present.contains(tree_path(source.path, include))) {
        breaches.push_back(breach(source, include));
      }
    }
  }
  return breaches;
}

std::vector<std::string> upward_links(const FloorTargets& targets) {
  std::vector<std::string> breaches;
  for (const auto& [user, target] : targets) {
    for (const std::vector<std::string>* list : {&target.public_dependencies, &target.private_dependencies}) {
      for (const std::string& used : *list) {
        if (used == user || !may_use(user, used)) {
          breaches.push_back(std::string(user).append(" links ").append(used));
        }
      }
    }
  }
  return breaches;
}

std::vector<std::string> unlinked_includes(const Sources& sources, const FloorTargets& targets) {
  std::vector<std::string> breaches;
  for (const SourceFile& source : sources) {
    const std::string user = part_of_house(source.path);
    if (!targets.contains(user)) {
      continue;
    }
    std::vector<std::string> linked = targets.at(user).public_dependencies;
    if (!is_header(source.path)) {
      const std::vector<std::string>& more = targets.at(user).private_dependencies;
      linked.insert(linked.end(), more.begin(), more.end());
    }
    const std::set<std::string> reached = public_closure(targets, linked);
    for (const std::string& include : source.includes) {
      const std::string used = floor_of_include(include);
      if (!used.empty() && used != user && !reached.contains(used)) {
        breaches.push_back(breach(source, include).append(" but does not link ").append(used));
      }
    }
  }
  return breaches;
}

} // namespace vesper::house
