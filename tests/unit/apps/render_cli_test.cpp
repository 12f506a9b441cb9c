// vesper-render as its users call it: what it writes, and how it fails.
#include "vesper/assets/image_file.hpp"

#include "support/command_line_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace vesper {
namespace {

using test::CommandResult;

// Without the sky's light, whose tables take seconds.
constexpr const char* scene =
    " --time 2026-01-15T22:00:00Z --latitude 51.5 --longitude 0 --height 47 --layers stars,planets,ground ";

class RenderCli : public test::CommandLineTest {
protected:
  RenderCli() : CommandLineTest("vesper-render") {}
};

TEST_F(RenderCli, WritesTheFrameAsFloats) {
  const CommandResult result = run(std::string(scene) + "--size 200x150 -o " + path("sky.exr"));
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
  ASSERT_EQ(run(std::string(scene) + "--size 200x200 -o " + path("sky.PNG")).status, 0);
  const FloatImage image = read_image(path("sky.PNG"));
  EXPECT_EQ(image.width, 200);
  EXPECT_EQ(image.channels.size(), 3U);
  EXPECT_GT(*std::max_element(image.values.begin(), image.values.end()), 0.9F);
}

TEST_F(RenderCli, WritesPicturesOfOneLine) {
  for (const char* size : {"1x1", "1x500", "2000x1"}) {
    const CommandResult result = run(std::string(scene) + "--layers stars --size " + size + " -o " + path("line.png"));
    EXPECT_EQ(result.status, 0) << size << result.err;
  }
}

TEST_F(RenderCli, WritesTheSameMeanInMorePixels) {
  // Whole skies of La Palma, on the display: a dark night with its stars and planets, and a full Moon.
  for (const char* time : {"2026-08-15T01:00:00Z", "2026-08-28T01:30:00Z"}) {
    std::array<double, 2> means{};
    for (std::size_t i = 0; i < means.size(); ++i) {
      const std::string file = path("sky.exr");
      std::string line = " --latitude 28.76 --longitude -17.88 --height 2400 --exr display --time ";
      line.append(time).append(i == 0 ? " --size 512x512" : " --size 2048x2048").append(" -o ").append(file);
      const CommandResult result = run(line);
      ASSERT_EQ(result.status, 0) << result.err;
      const FloatImage image = read_image(file);
      for (std::size_t p = 0; p < image.values.size(); p += image.channels.size()) {
        means.at(i) += static_cast<double>(0.2126F * image.values[p] + 0.7152F * image.values[p + 1] +
                                           0.0722F * image.values[p + 2]);
      }
      means.at(i) /= static_cast<double>(image.width) * image.height;
    }
    std::printf("  %s: mean of the display's range %.5f in 512 pixels, %.5f in 2048\n", time, means[0], means[1]);
    EXPECT_NEAR(means[0] / means[1], 1.0, 0.01) << time;
  }
}

TEST_F(RenderCli, WritesDeepPicturesAndTheirDisplay) {
  const std::string small = std::string(scene) + "--size 64x64 --fov 40 --azimuth 150 --altitude 40 ";
  const auto deep_share = [&](const std::string& name) {
    const std::vector<float> values = read_image(path(name)).values;
    const auto deep = std::count_if(values.begin(), values.end(), [](float v) {
      const float steps = v * 255.0F;
      return std::abs(steps - std::round(steps)) > 1.0e-3F;
    });
    return static_cast<double>(deep) / static_cast<double>(values.size());
  };
  ASSERT_EQ(run(small + "-o " + path("shallow.png")).status, 0);
  ASSERT_EQ(run(small + "--bits 16 --primaries rec2020 -o " + path("deep.png")).status, 0);
  EXPECT_EQ(deep_share("shallow.png"), 0.0);
  EXPECT_GT(deep_share("deep.png"), 0.05);
  EXPECT_NE(text("deep.png").find("iCCP"), std::string::npos);
  ASSERT_EQ(run(small + "--exr display -o " + path("display.exr")).status, 0);
  const FloatImage display = read_image(path("display.exr"));
  EXPECT_EQ(display.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_LE(*std::max_element(display.values.begin(), display.values.end()), 1.0F);
  EXPECT_GT(*std::max_element(display.values.begin(), display.values.end()), 0.0F);
}

TEST_F(RenderCli, MoonlightIsWhiteToTheEyeAndNotToACamera) {
  const auto red_over_blue = [&](const std::string& options) {
    const CommandResult result =
        run("--time 2026-08-28T01:30:00Z --latitude 28.76 --longitude -17.88 --layers moon --projection perspective "
            "--azimuth 188.9 --altitude 50.3 --fov 0.4 --size 16x16 --glare off --exr display " +
            options + " -o " + path("moon.exr"));
    EXPECT_EQ(result.status, 0) << result.err;
    const std::vector<float> values = read_image(path("moon.exr")).values;
    double red = 0.0;
    double blue = 0.0;
    for (std::size_t i = 0; i < values.size(); i += 3) {
      red += static_cast<double>(values[i]);
      blue += static_cast<double>(values[i + 2]);
    }
    return red / blue;
  };
  EXPECT_LT(red_over_blue(""), 1.5);
  EXPECT_GT(red_over_blue("--white-adaptation off"), 1.8);
  EXPECT_GT(red_over_blue("--operator photographic"), 1.8);
}

TEST_F(RenderCli, ACubeMapTakesAFaceOrAStack) {
  ASSERT_EQ(run(std::string(scene) + "--projection cubemap --size 32x32 -o " + path("face.exr")).status, 0);
  ASSERT_EQ(run(std::string(scene) + "--projection cubemap --size 32x192 -o " + path("stack.exr")).status, 0);
  EXPECT_EQ(read_file(path("face.exr")), read_file(path("stack.exr")));
  const std::string display = std::string(scene) + "--projection cubemap --size 32x32 -o " + path("face.png");
  EXPECT_NE(run(display).err.find("--projection equirectangular"), std::string::npos); // for an eye's glare
  EXPECT_EQ(run(display + " --glare off --acuity off").err, "");
}

TEST_F(RenderCli, LayersAndAirCanBeLeftOut) {
  const auto light = [&](const std::string& options) {
    EXPECT_EQ(run(std::string(scene) + "--projection equirectangular --altitude 0 --size 360x180 " + options + " -o " +
                  path("sky.exr"))
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
  write("thick.toml", "base = \"clear\"\naerosol_optical_depth = 2\n");
  EXPECT_LT(light("--medium thick.toml"), 0.3 * all);
  EXPECT_GT(light("--medium published"), 1.05 * all);
  EXPECT_EQ(light("--medium clear"), all);
  EXPECT_NE(light("--scintillation off"), all);
  EXPECT_NE(light("--refraction off"), all);
  EXPECT_NE(light("--pressure 500"), all);
  EXPECT_NE(light("--temperature -40"), all);
  EXPECT_NE(light("--seed 2"), all);
  EXPECT_NE(light("--exposure-time 0"), all);
}

TEST_F(RenderCli, PrintsTimingsAsData) {
  const CommandResult result = run(std::string(scene) + "--size 64x64 --timings -o " + path("sky.png"));
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* pass : {"clear", "stars", "ground", "display", "write"}) {
    EXPECT_NE(result.out.find(pass), std::string::npos) << result.out;
  }
}

TEST_F(RenderCli, WrongOptionsExitWithTwoAndWriteNothing) {
  const std::string to = " -o " + path("sky.png");
  expect_failure(2, "", {"--output"});
  expect_failure(2, "-o " + path("sky.jpg"), {"sky.jpg", ".png", ".exr"});
  expect_failure(2, "--projection perspective --fov 170" + to, {"fov", "170"});
  expect_failure(2, "--fov 361" + to, {"fov", "361", "360"});
  expect_failure(2, "--projection mercator" + to, {"--projection", "mercator", "fisheye"});
  expect_failure(2, "--size 12" + to, {"--size", "12"});
  expect_failure(2, "--size 99999x10" + to, {"--size", "99999"});
  expect_failure(2, "--projection cubemap --size 64x65" + to, {"size", "64x65"});
  expect_failure(2, "--latitude 91" + to, {"--latitude", "91", "90"});
  expect_failure(2, "--layers stars,unicorns" + to, {"--layers", "unicorns"});
  expect_failure(2, "--time yesterday" + to, {"--time", "yesterday"});
  expect_failure(2, "--tier best" + to, {"--tier", "best"});
  expect_failure(2, "--medium mars" + to, {"--medium", "mars", "clear, published"});
  expect_failure(2, "--scintillation maybe" + to, {"--scintillation", "maybe"});
  expect_failure(2, "--refraction maybe" + to, {"--refraction", "maybe"});
  expect_failure(2, "--pressure 2000" + to, {"--pressure", "2000", "1100"});
  expect_failure(2, "--exposure-time -1" + to, {"--exposure-time", "-1"});
  for (const char* option : {"exposure", "exposure-time", "age", "moon-scale", "sun-scale"}) {
    expect_failure(2, std::string("--") + option + " nan" + to, {option, "'nan' is not allowed; allowed: ", " to "});
  }
  expect_failure(2, "--ev 3" + to, {"--ev: '3'", "only with --operator photographic"});
  expect_failure(2, "--bits 12" + to, {"--bits", "12", "8, 16"});
  expect_failure(2, "--display-peak 0" + to, {"--display-peak", "0.001 to 10000"});
  expect_failure(2, "--exr light" + to, {"--exr", "light"});
  expect_failure(2, "--tolerance 1" + to, {"--tolerance"}); // arrives with the plan
  EXPECT_FALSE(std::filesystem::exists(path("sky.png")));
}

TEST_F(RenderCli, FailuresWhileWorkingExitWithOneAndLeaveEarlierOutputIntact) {
  const std::string small = std::string(scene) + "--size 16x16 ";
  expect_failure(1, small + "-o " + path("missing/sky.png"), {"missing/sky.png", "Create the folder"});
  expect_failure(2, small + "-o /dev/full --exposure 0", {"/dev/full"});
  expect_failure(1, small + "--medium none.toml -o " + path("sky.png"), {"none.toml"});
  write("air.toml", "base = \"clear\"\nozone = \"300\"\n");
  expect_failure(1, small + "--medium air.toml -o " + path("sky.png"), {"air.toml: line 2, key 'ozone'", "DU"});
  expect_failure(1, small + "--catalogue " + path("none.glb") + " -o " + path("sky.png"), {"none.glb"});
  write("bad.glb", "not a star buffer");
  write("sky.png", "earlier");
  expect_failure(1, small + "--catalogue " + path("bad.glb") + " -o " + path("sky.png"), {"bad.glb"});
  EXPECT_EQ(text("sky.png"), "earlier");
}

TEST_F(RenderCli, AFullDiskIsAnErrorAndLeavesNothingBehind) {
  std::filesystem::create_symlink("/dev/full", path("sky.exr"));
  expect_failure(1, std::string(scene) + "--size 16x16 -o " + path("sky.exr"), {"sky.exr", "No space left"});
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("")), std::filesystem::directory_iterator()), 1)
      << "the link";
}

TEST_F(RenderCli, ABrokenShaderIsNamed) {
  std::filesystem::create_directories(path("shaders"));
  write("shaders/star.frag", "#include \"prelude.glsl\"\nvoid main() { broken }\n");
  expect_failure(1, std::string(scene) + "--size 16x16 --shader-dir " + path("shaders") + " -o " + path("sky.png"),
                 {"star.frag", "broken", "prelude.glsl"});
}

} // namespace
} // namespace vesper
