// The tree against the floors of docs/ARCHITECTURE.md, and the checker against small trees that break each rule.
#include "unit/include_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <unistd.h>

namespace vesper::house {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

const Sources& tree() {
  static const Sources sources =
      read_sources(VESPER_SOURCE_DIR, {"renderer", "catalog_tools", "apps", "tests", "shaders"});
  return sources;
}

TEST(House, ReaderSeesTheTree) {
  const auto file = std::find_if(tree().begin(), tree().end(),
                                 [](const SourceFile& f) { return f.path == "renderer/sky/sky_state.hpp"; });
  ASSERT_NE(file, tree().end());
  EXPECT_NE(std::find(file->includes.begin(), file->includes.end(), "vesper/astro/star_frame.hpp"),
            file->includes.end());
  EXPECT_GE(tree().size(), 50U);
  const FloorTargets targets = read_targets(VESPER_SOURCE_DIR);
  for (const char* floor : {"base", "light", "assets", "astro", "sky", "plan", "gpu", "catalog_tools"}) {
    EXPECT_TRUE(targets.contains(floor)) << floor;
  }
}

TEST(House, NoFloorIncludesAHigherOne) { EXPECT_EQ(upward_includes(tree()), Lines{}); }
TEST(House, OnlyTheGpuFloorKnowsOpenGL) { EXPECT_EQ(graphics_includes(tree()), Lines{}); }
TEST(House, NoFileIncludesItselfOnAnyWay) { EXPECT_EQ(include_cycles(tree()), Lines{}); }
TEST(House, EveryIncludedFileOfTheHouseIsThere) { EXPECT_EQ(missing_includes(tree()), Lines{}); }
TEST(House, NoFloorLinksAHigherOne) { EXPECT_EQ(upward_links(read_targets(VESPER_SOURCE_DIR)), Lines{}); }
TEST(House, EachFloorLinksWhatItIncludes) {
  EXPECT_EQ(unlinked_includes(tree(), read_targets(VESPER_SOURCE_DIR)), Lines{});
}

TEST(HouseRules, AFloorMayIncludeLowerFloorsAndItself) {
  EXPECT_EQ(upward_includes({{"renderer/sky/a.cpp", {"vesper/sky/a.hpp", "vesper/astro/time.hpp", "vector"}},
                             {"catalog_tools/b.cpp", {"vesper/astro/time.hpp", "vesper/catalog_tools/b.hpp"}},
                             {"apps/render/main.cpp", {"vesper/gpu/frame.hpp", "common/scene.hpp"}},
                             {"tests/unit/c.cpp", {"vesper/catalog_tools/b.hpp", "common/scene.hpp"}}}),
            Lines{});
}

TEST(HouseRules, UpwardAndSidewaysIncludesAreFound) {
  EXPECT_EQ(upward_includes({{"renderer/astro/a.cpp", {"vesper/sky/sky_state.hpp"}}}),
            Lines{"renderer/astro/a.cpp includes vesper/sky/sky_state.hpp"});
  EXPECT_EQ(upward_includes({{"renderer/light/a.cpp", {"vesper/assets/star_catalogue.hpp"}}}).size(), 1U);
  EXPECT_EQ(upward_includes({{"renderer/assets/a.cpp", {"vesper/light/spectrum.hpp"}}}).size(), 1U);
  EXPECT_EQ(upward_includes({{"renderer/gpu/a.cpp", {"vesper/catalog_tools/b.hpp"}}}).size(), 1U);
  EXPECT_EQ(upward_includes({{"catalog_tools/a.cpp", {"vesper/atmosphere/medium.hpp"}}}).size(), 1U);
  EXPECT_EQ(upward_includes({{"renderer/gpu/a.cpp", {"common/scene.hpp"}}}).size(), 1U);
  EXPECT_EQ(upward_includes({{"renderer/gpu/a.cpp", {"../../tests/unit/x.hpp"}}}).size(), 1U);
  EXPECT_EQ(upward_includes({{"apps/render/a.cpp", {"unit/x.hpp"}}}).size(), 1U);
}

TEST(HouseRules, OpenGLOutsideTheGpuFloorIsFound) {
  for (const char* header : {"GL/gl.h", "EGL/egl.h", "epoxy/gl.h", "GLFW/glfw3.h", "KHR/khrplatform.h"}) {
    EXPECT_EQ(graphics_includes({{"renderer/plan/a.cpp", {header}}}).size(), 1U) << header;
    EXPECT_EQ(graphics_includes({{"apps/render/a.cpp", {header}}}).size(), 1U) << header;
    EXPECT_EQ(graphics_includes({{"tests/unit/a.cpp", {header}}}).size(), 1U) << header;
    EXPECT_EQ(graphics_includes({{"renderer/gpu/a.cpp", {header}}, {"tests/render/a.cpp", {header}}}), Lines{});
  }
  EXPECT_EQ(graphics_includes({{"renderer/plan/a.cpp", {"glm/glm.hpp"}}}), Lines{});
}

TEST(HouseRules, CyclesAreFoundOnce) {
  EXPECT_EQ(include_cycles({{"renderer/base/a.hpp", {"vesper/base/b.hpp"}},
                            {"renderer/base/b.hpp", {"vesper/base/c.hpp"}},
                            {"renderer/base/c.hpp", {"vesper/base/a.hpp"}}}),
            Lines{"renderer/base/a.hpp -> renderer/base/b.hpp -> renderer/base/c.hpp -> renderer/base/a.hpp"});
  EXPECT_EQ(include_cycles({{"apps/common/a.hpp", {"common/a.hpp"}}}).size(), 1U);
  EXPECT_EQ(include_cycles({{"tests/render/a.hpp", {"render/a.hpp"}}}).size(), 1U);
  EXPECT_EQ(include_cycles({{"tests/unit/a.hpp", {"b.hpp"}}, {"tests/unit/b.hpp", {"a.hpp"}}}).size(), 1U);
  EXPECT_EQ(include_cycles({{"renderer/base/a.hpp", {"vesper/base/b.hpp", "vesper/base/c.hpp"}},
                            {"renderer/base/b.hpp", {"vesper/base/c.hpp"}},
                            {"renderer/base/c.hpp", {}}}),
            Lines{});
}

TEST(HouseRules, AnIncludeOfNothingIsFound) {
  EXPECT_EQ(missing_includes({{"renderer/base/a.cpp", {"vesper/base/gone.hpp"}}}).size(), 1U);
  EXPECT_EQ(missing_includes({{"renderer/base/a.cpp", {"vesper/cellar/a.hpp"}}}).size(), 1U);
}

TEST(HouseRules, UpwardLinksAreFound) {
  EXPECT_EQ(upward_links({{"sky", {{"astro"}, {"light"}}}}), Lines{});
  EXPECT_EQ(upward_links({{"astro", {{"sky"}, {}}}}), Lines{"astro links sky"});
  EXPECT_EQ(upward_links({{"light", {{}, {"assets"}}}}), Lines{"light links assets"});
  EXPECT_EQ(upward_links({{"gpu", {{}, {"catalog_tools"}}}}), Lines{"gpu links catalog_tools"});
}

TEST(HouseRules, IncludesWithoutALinkAreFound) {
  const FloorTargets targets{{"astro", {{"base"}, {}}}, {"sky", {{"astro"}, {"light"}}}};
  EXPECT_EQ(unlinked_includes({{"renderer/sky/a.hpp", {"vesper/base/units.hpp"}},
                               {"renderer/sky/a.cpp", {"vesper/light/colour.hpp"}}},
                              targets),
            Lines{});
  EXPECT_EQ(unlinked_includes({{"renderer/sky/a.hpp", {"vesper/light/colour.hpp"}}}, targets).size(), 1U)
      << "a header needs a public dependency";
  EXPECT_EQ(unlinked_includes({{"renderer/sky/a.cpp", {"vesper/assets/map.hpp"}}}, targets).size(), 1U);
}

TEST(HouseRules, ReadersUnderstandIncludesAndCMake) {
  const fs::path top = fs::temp_directory_path() / ("vesper-house-" + std::to_string(::getpid()));
  fs::create_directories(top / "renderer/sky");
  std::ofstream(top / "renderer/sky/a.cpp") << "#include \"vesper/sky/a.hpp\"\n  #  include <vector>\n"
                                               "// #include \"no.hpp\"\n";
  std::ofstream(top / "renderer/sky/CMakeLists.txt")
      << "vesper_add_floor(sky SOURCES a.cpp\n  DEPENDS vesper::astro # vesper::gpu\n  PRIVATE_DEPENDS vesper::light "
         "PkgConfig::erfa)\ntarget_link_libraries(vesper_sky PRIVATE vesper_base)\n";
  const Sources sources = read_sources(top, {"renderer", "absent"});
  const FloorTargets targets = read_targets(top);
  fs::remove_all(top);
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_EQ(sources[0].path, "renderer/sky/a.cpp");
  EXPECT_EQ(sources[0].includes, (Lines{"vesper/sky/a.hpp", "vector"}));
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets.at("sky").public_dependencies, Lines{"astro"});
  EXPECT_EQ(targets.at("sky").private_dependencies, (Lines{"light", "base"}));
}

} // namespace
} // namespace vesper::house
