// vesper-render as its users call it: what it writes, and how it fails.
#include "unit/apps/run_command.hpp"

#include "vesper/assets/image_file.hpp"
#include "vesper/base/files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vesper {
namespace {

using test::CommandResult;

constexpr const char* scene = " --time 2026-01-15T22:00:00Z --latitude 51.5 --longitude 0 --height 47 ";

class RenderCli : public testing::Test {
protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "vesper_render_" + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] CommandResult render(const std::string& arguments) const {
    return test::run_command(folder_, "vesper-render", arguments);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }

  void expect_failure(const std::string& arguments, int status, const std::vector<std::string>& words) const {
    const CommandResult result = render(arguments);
    EXPECT_EQ(result.status, status) << arguments << "\n" << result.err;
    EXPECT_EQ(result.out, "") << arguments;
    for (const std::string& word : words) {
      EXPECT_NE(result.err.find(word), std::string::npos) << arguments << " should say " << word << "\n" << result.err;
    }
  }

private:
  std::string folder_;
};

TEST_F(RenderCli, WritesTheFrameAsFloats) {
  const CommandResult result = render(std::string(scene) + "--size 200x150 -o " + path("sky.exr"));
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
  const FloatImage image = read_image(path("sky.exr"));
  EXPECT_EQ(image.width, 200);
  EXPECT_EQ(image.height, 150);
  EXPECT_EQ(image.channels, (std::vector<std::string>{"X", "Y", "Z", "S"}));
  EXPECT_TRUE(std::all_of(image.values.begin(), image.values.end(),
                          [](float value) { return std::isfinite(value) && value >= 0.0F; }));
  EXPECT_GT(*std::max_element(image.values.begin(), image.values.end()), 0.0F);
}

TEST_F(RenderCli, WritesAPictureForTheEye) {
  ASSERT_EQ(render(std::string(scene) + "--size 200x200 -o " + path("sky.PNG")).status, 0);
  const FloatImage image = read_image(path("sky.PNG"));
  EXPECT_EQ(image.width, 200);
  EXPECT_EQ(image.channels.size(), 3U);
  EXPECT_GT(*std::max_element(image.values.begin(), image.values.end()), 0.9F);
}

TEST_F(RenderCli, ACubeMapTakesAFaceOrAStack) {
  ASSERT_EQ(render(std::string(scene) + "--projection cubemap --size 32x32 -o " + path("face.exr")).status, 0);
  ASSERT_EQ(render(std::string(scene) + "--projection cubemap --size 32x192 -o " + path("stack.exr")).status, 0);
  EXPECT_EQ(read_file(path("face.exr")), read_file(path("stack.exr")));
}

TEST_F(RenderCli, LayersAndAirCanBeLeftOut) {
  const auto light = [&](const std::string& options) {
    EXPECT_EQ(render(std::string(scene) + "--projection equirectangular --altitude 0 --size 360x180 " + options +
                     " -o " + path("sky.exr"))
                  .status,
              0);
    double sum = 0.0;
    for (const float value : read_image(path("sky.exr")).values) {
      sum += static_cast<double>(value);
    }
    return sum;
  };
  const double all = light("");
  EXPECT_GT(light("--layers stars"), 1.3 * all);
  EXPECT_EQ(light("--layers ground"), 0.0);
  EXPECT_GT(light("--extinction off"), 1.2 * all);
  EXPECT_NE(light("--scintillation off"), all);
  EXPECT_NE(light("--refraction off"), all);
  EXPECT_NE(light("--pressure 500"), all);
  EXPECT_NE(light("--temperature -40"), all);
  EXPECT_NE(light("--seed 2"), all);
  EXPECT_NE(light("--exposure-time 0"), all);
}

TEST_F(RenderCli, PrintsTimingsAsData) {
  const CommandResult result = render(std::string(scene) + "--size 64x64 --timings -o " + path("sky.png"));
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* pass : {"clear", "stars", "ground", "display", "write"}) {
    EXPECT_NE(result.out.find(pass), std::string::npos) << result.out;
  }
}

TEST_F(RenderCli, WrongOptionsExitWithTwoAndWriteNothing) {
  const std::string to = " -o " + path("sky.png");
  expect_failure("", 2, {"--output"});
  expect_failure("-o " + path("sky.jpg"), 2, {"sky.jpg", ".png", ".exr"});
  expect_failure("--projection perspective --fov 170" + to, 2, {"fov", "170"});
  expect_failure("--fov 361" + to, 2, {"fov", "361", "360"});
  expect_failure("--projection mercator" + to, 2, {"--projection", "mercator", "fisheye"});
  expect_failure("--size 12" + to, 2, {"--size", "12"});
  expect_failure("--size 99999x10" + to, 2, {"--size", "99999"});
  expect_failure("--projection cubemap --size 64x65" + to, 2, {"size", "64x65"});
  expect_failure("--latitude 91" + to, 2, {"--latitude", "91", "90"});
  expect_failure("--layers stars,unicorns" + to, 2, {"--layers", "unicorns"});
  expect_failure("--time yesterday" + to, 2, {"--time", "yesterday"});
  expect_failure("--tier best" + to, 2, {"--tier", "best"});
  expect_failure("--scintillation maybe" + to, 2, {"--scintillation", "maybe"});
  expect_failure("--refraction maybe" + to, 2, {"--refraction", "maybe"});
  expect_failure("--pressure 2000" + to, 2, {"--pressure", "2000", "1100"});
  expect_failure("--exposure-time -1" + to, 2, {"--exposure-time", "-1"});
  expect_failure("--medium clear" + to, 2, {"--medium"}); // arrives with the atmosphere
  EXPECT_FALSE(std::filesystem::exists(path("sky.png")));
}

TEST_F(RenderCli, FailuresWhileWorkingExitWithOneAndLeaveEarlierOutputIntact) {
  const std::string small = std::string(scene) + "--size 16x16 ";
  expect_failure(small + "-o " + path("missing/sky.png"), 1, {"missing/sky.png", "Create the folder"});
  expect_failure(small + "-o /dev/full --exposure 0", 2, {"/dev/full"});
  expect_failure(small + "--catalogue " + path("none.glb") + " -o " + path("sky.png"), 1, {"none.glb"});
  write_file_atomically(path("bad.glb"), std::string("not a star buffer"));
  write_file_atomically(path("sky.png"), std::string("earlier"));
  expect_failure(small + "--catalogue " + path("bad.glb") + " -o " + path("sky.png"), 1, {"bad.glb"});
  const Bytes earlier = read_file(path("sky.png"));
  EXPECT_EQ(earlier.size(), 7U);
}

TEST_F(RenderCli, AFullDiskIsAnErrorAndLeavesNothingBehind) {
  std::filesystem::create_symlink("/dev/full", path("sky.exr"));
  expect_failure(std::string(scene) + "--size 16x16 -o " + path("sky.exr"), 1, {"sky.exr", "No space left"});
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("")), std::filesystem::directory_iterator()), 3)
      << "the link and the two files of the captured output";
}

TEST_F(RenderCli, ABrokenShaderIsNamed) {
  std::filesystem::create_directories(path("shaders"));
  write_file_atomically(path("shaders/star.frag"), std::string("#include \"prelude.glsl\"\nvoid main() { broken }\n"));
  expect_failure(std::string(scene) + "--size 16x16 --shader-dir " + path("shaders") + " -o " + path("sky.png"), 1,
                 {"star.frag", "broken", "prelude.glsl"});
}

} // namespace
} // namespace vesper
