// The pages of docs: that their links lead somewhere and no tool has run their lists together.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace vesper {
namespace {

namespace fs = std::filesystem;

const fs::path top = VESPER_SOURCE_DIR;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found{top / "README.md", top / "CHANGELOG.md", top / "data/README.md",
                              top / "tests/data/README.md"};
  for (const auto& entry : fs::directory_iterator(top / "docs")) {
    if (entry.path().extension() == ".md") {
      found.push_back(entry.path());
    }
  }
  return found;
}

/// What the first group of a pattern matches.
std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i) {
    found.push_back((*i)[1]);
  }
  return found;
}

TEST(Docs, LinksLeadSomewhere) {
  std::size_t links = 0;
  for (const fs::path& page : pages()) {
    const std::string text = text_of(page);
    for (const std::string& target : matches(text, R"(\]\(([^)#:]+)[^):]*\))")) {
      EXPECT_TRUE(fs::exists(page.parent_path() / target)) << page << " links to " << target;
      ++links;
    }
    for (const std::string& path : matches(text, "`((?:docs|renderer|shaders|tests|apps|catalog_tools)/[\\w/.-]+)`")) {
      EXPECT_TRUE(fs::exists(top / path)) << page << " names " << path;
    }
  }
  EXPECT_GT(links, 40U);
}

TEST(Docs, ListsAndParagraphsAreWhole) {
  for (const fs::path& page : pages()) {
    std::ifstream in(page);
    std::string line;
    bool code = false;
    for (int number = 1; std::getline(in, line); ++number) {
      if (line.rfind("```", 0) == 0) {
        code = !code;
        continue;
      }
      if (code || line.rfind('|', 0) == 0 || line.rfind("    ", 0) == 0) {
        continue; // tables and code stand as they are
      }
      EXPECT_TRUE(matches(line, R"((\S +- \*\*))").empty()) << page << ":" << number << ": a list item amid a line";
      EXPECT_TRUE(matches(line, R"((\S {3,}\S))").empty()) << page << ":" << number << ": an indent amid a line";
    }
  }
}

TEST(Docs, PagesThatAreMadeBeginAsTheirHeadsSay) {
  for (const char* name : {"DISPLAY", "PANORAMA"}) {
    std::string lower = name;
    for (char& c : lower) {
      c = static_cast<char>(std::tolower(c));
    }
    const std::string head = text_of(top / "docs" / (lower + "_head.md"));
    EXPECT_FALSE(head.empty());
    EXPECT_EQ(text_of(top / "docs" / (std::string(name) + ".md")).substr(0, head.size()), head);
  }
}

} // namespace
} // namespace vesper
