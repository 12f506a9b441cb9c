// vesper-catalog moon as a person uses it: what it prints, writes and returns.
#include "support/command_line_test.hpp"
#include "support/moon_inputs.hpp"

#include "vesper/assets/image_file.hpp"
#include "vesper/assets/moon_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vesper {
namespace {

using test::CommandResult;

/// In the middle of a face.
float albedo_amid(const MoonMap& map, std::size_t face) {
  const auto side = static_cast<std::size_t>(map.face_size);
  return map.texels[4 * (face * side * side + side * side / 2 + side / 2)];
}

class CatalogMoonCli : public test::CommandLineTest {
protected:
  CatalogMoonCli() : CommandLineTest("vesper-catalog") {}
  void SetUp() override {
    CommandLineTest::SetUp();
    GlobeGrid grid = test::globe_grid(36, 0.0, [](const Vec3& d) { return 1800.0 * d.x * d.z; });
    grid.values[0] = std::numeric_limits<float>::quiet_NaN();
    samples_ = test::elevation_samples(grid);
    write("MADE_UP.IMG", samples_);
    write("MADE_UP.LBL", test::elevation_label("MADE_UP.IMG", 36));
    // Bright in the east, with a black column.
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < 64 * 32; ++i) {
      const auto value = static_cast<std::uint8_t>(i % 64 == 10 ? 0 : i % 64 < 32 ? 100 : 200);
      rgba.insert(rgba.end(), {value, value, value, 255});
    }
    write_png(path("grey.png"), 64, 32, rgba, {});
  }

  static constexpr const char* inputs = "moon --albedo grey.png --elevation MADE_UP.IMG ";
  [[nodiscard]] static std::string line(const std::string& rest) { return inputs + rest; }

  std::string samples_;
};

TEST_F(CatalogMoonCli, ConvertsReportsAndReadsBack) {
  EXPECT_NE(run("moon --help").out.find("Usage"), std::string::npos);
  const CommandResult made = run(line("--face 16 -o moon.exr --json"));
  ASSERT_EQ(made.status, 0) << made.err;
  const auto report = nlohmann::json::parse(made.out);
  EXPECT_EQ(report["face_size"], 16);
  EXPECT_EQ(report["albedo_pixels"], 64 * 32);
  EXPECT_EQ(report["albedo_filled"], 32);
  EXPECT_NEAR(report["albedo_filled_area"].get<double>(), 1.0 / 64.0, 1e-12);
  EXPECT_EQ(report["elevation_pixels"], 72 * 36);
  EXPECT_EQ(report["elevation_filled"], 1);
  EXPECT_NEAR(report["disc_albedo"].get<double>(), 0.1207, 1e-5);
  EXPECT_NEAR(report["highest_m"].get<double>(), 900.0, 5.0);

  const MoonMap map = read_moon_map(path("moon.exr"));
  EXPECT_EQ(map.provenance.albedo_file, "grey.png");
  EXPECT_EQ(map.provenance.elevation_sha256, report["elevation_sha256"]);
  EXPECT_EQ(map.provenance.options, "--longitude-origin 0 --albedo-encoding automatic --face 16");
  // 90 degrees east, the face +Y, is the bright half's middle; sRGB 200 is 4.5 times as bright as 100.
  EXPECT_NEAR(albedo_amid(map, 2) / albedo_amid(map, 3), 4.52, 0.05);

  const auto info = nlohmann::json::parse(run("info moon.exr --json").out);
  EXPECT_EQ(info["face_size"], 16);
  EXPECT_EQ(info["albedo_filled"], 32);
  const CommandResult check = run("check moon.exr");
  EXPECT_EQ(check.status, 0);
  EXPECT_NE(check.out.find("valid, a map of the Moon, 6 faces of 16 x 16, albedo of the disc 0.1207"),
            std::string::npos);

  const CommandResult text = run(line("--face 16 --dry-run"));
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("32 of 2048 pixels missing, filled from around them (1.562 % of the area)"),
            std::string::npos)
      << text.out;
}

TEST_F(CatalogMoonCli, SameInputSameBytes) {
  ASSERT_EQ(run(line("--face 16 -o a.exr")).status, 0);
  ASSERT_EQ(run(line("--output b.exr --face 16 --quiet --label MADE_UP.LBL")).status, 0);
  EXPECT_EQ(text("a.exr"), text("b.exr"));
}

TEST_F(CatalogMoonCli, TurnsThePictureByItsOrigin) {
  ASSERT_EQ(run(line("--face 16 --longitude-origin 180 --albedo-encoding linear -o moon.exr")).status, 0);
  const MoonMap map = read_moon_map(path("moon.exr"));
  EXPECT_NEAR(albedo_amid(map, 3) / albedo_amid(map, 2), 2.0, 0.01);
}

TEST_F(CatalogMoonCli, WrongOptionsExitWith2AndSayWhatIsAllowed) {
  expect_failure(2, "moon", {"required"});
  expect_failure(2, inputs, {"--output is missing", "--dry-run"});
  expect_failure(2, line("-o grey.png"), {"grey.png", "names the input itself"});
  expect_failure(2, line("-o MADE_UP.LBL"), {"MADE_UP.LBL", "names the input itself"});
  expect_failure(2, line("-o a.png"), {"a.png", "End the name in .exr"});
  expect_failure(2, line("-o a.exr --face 15"), {"--face: '15'", "even numbers from 16 to 4096"});
  expect_failure(2, line("-o a.exr --face x"), {"--face"});
  expect_failure(2, line("-o a.exr --longitude-origin east"), {"--longitude-origin", "-360 to 360"});
  expect_failure(2, line("-o a.exr --longitude-origin 361"), {"--longitude-origin", "-360 to 360"});
  expect_failure(2, line("-o a.exr --albedo-encoding gamma"), {"--albedo-encoding", "automatic, srgb, linear"});
}

TEST_F(CatalogMoonCli, WrongFilesExitWith1AndLeaveAnEarlierMap) {
  write("moon.exr", "earlier");
  const std::string rest = "--face 16 -o moon.exr";
  const auto fails = [&](const std::string& arguments, const std::vector<std::string>& words) {
    expect_failure(1, arguments, words);
    EXPECT_EQ(text("moon.exr"), "earlier") << arguments;
  };
  fails("moon --albedo none.png --elevation MADE_UP.IMG " + rest, {"none.png"});
  fails("moon --albedo MADE_UP.LBL --elevation MADE_UP.IMG " + rest, {"MADE_UP.LBL", "cannot be read"});
  write_png(path("black.png"), 64, 32, std::vector<std::uint8_t>(std::size_t{4} * 64 * 32, 0), {});
  fails("moon --albedo black.png --elevation MADE_UP.IMG " + rest, {"black.png: 100.0 % of the albedo map is missing"});
  fails("moon --albedo grey.png --elevation none.IMG " + rest, {"none.IMG", "has no label"});
  fails("moon --albedo grey.png --elevation grey.png --label MADE_UP.LBL " + rest,
        {"MADE_UP.LBL: line 4", "^IMAGE is \"MADE_UP.IMG\""});
  fails("moon --albedo grey.png --elevation MADE_UP.IMG --label grey.png " + rest, {"grey.png: line 1"});
  fails(line("--face 16 -o none/moon.exr"), {"none"});
  write("MADE_UP.IMG", samples_ + "x");
  fails(line(rest), {"MADE_UP.IMG", "5185 bytes", "5184"});
  write("MADE_UP.IMG", samples_);
  write("MADE_UP.LBL", test::elevation_label("MADE_UP.IMG", 36, "MSB_INTEGER"));
  fails(line(rest), {"heights run from", "Set SAMPLE_TYPE in MADE_UP.LBL to LSB_INTEGER"});
  write("MADE_UP.LBL", test::elevation_label("MADE_UP.IMG", 72));
  fails(line(rest), {"5184 bytes", "20736"});
}

TEST_F(CatalogMoonCli, ChecksMapsThatAreBroken) {
  ASSERT_EQ(run(line("--face 16 -o moon.exr")).status, 0);
  write("cut.exr", text("moon.exr").substr(0, 2000));
  expect_failure(1, "check cut.exr", {"cut.exr", "cannot be decoded"});
  write_exr(path("sky.exr"), 16, 96, std::vector<float>(4UL * 16 * 96, 0.5F), {});
  const CommandResult check = run("check sky.exr --json");
  EXPECT_EQ(check.status, 1);
  EXPECT_EQ(nlohmann::json::parse(check.out)["valid"], false);
}

} // namespace
} // namespace vesper
