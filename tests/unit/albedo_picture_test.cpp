// Pictures as maps of albedo.
#include "support/expect_error.hpp"
#include "support/folder_test.hpp"

#include "vesper/assets/image_file.hpp"
#include "vesper/catalog_tools/albedo_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace vesper {
namespace {

class AlbedoPicture : public test::FolderTest {
protected:
  std::string write_bytes(const std::string& name, int width, int height, std::uint8_t r, std::uint8_t g,
                          std::uint8_t b) const {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < width * height; ++i) {
      rgba.insert(rgba.end(), {r, g, b, 255});
    }
    write_png(path(name), width, height, rgba, {});
    return path(name);
  }
  std::string write_floats(const std::string& name, const std::vector<std::string>& channels,
                           const std::vector<float>& pixel) const {
    std::vector<float> values;
    for (int i = 0; i < 64 * 32; ++i) {
      values.insert(values.end(), pixel.begin(), pixel.end());
    }
    write_exr(path(name), 64, 32, channels, values, ExrDepth::single, {});
    return path(name);
  }
};

TEST_F(AlbedoPicture, DecodesWholeNumbersFromSrgb) {
  const std::string picture = write_bytes("a.png", 64, 32, 188, 188, 188);
  const GlobeGrid grid = read_albedo_picture(picture, {});
  EXPECT_EQ(grid.width, 64);
  EXPECT_EQ(grid.height, 32);
  EXPECT_EQ(grid.values.size(), 64U * 32U);
  // IEC 61966-2-1: 188 of 255 is 0.5029 of full light.
  EXPECT_NEAR(grid.values[3], 0.50289, 0.0001);
  EXPECT_FLOAT_EQ(read_albedo_picture(picture, {{}, AlbedoEncoding::linear}).values[3], 188.0F / 255.0F);
  EXPECT_EQ(read_albedo_picture(picture, {{}, AlbedoEncoding::srgb}).values, grid.values);
}

TEST_F(AlbedoPicture, TakesTheLuminanceOfColours) {
  const std::string picture = write_bytes("a.png", 64, 32, 255, 0, 0);
  EXPECT_NEAR(read_albedo_picture(picture, {{}, AlbedoEncoding::linear}).values[0], 0.2126, 1e-6);
  const std::string floats = write_floats("a.exr", {"R", "G", "B"}, {0.1F, 0.2F, 0.4F});
  EXPECT_NEAR(read_albedo_picture(floats, {}).values[0], 0.02126 + 0.14304 + 0.02888, 1e-6);
  EXPECT_FLOAT_EQ(read_albedo_picture(write_floats("y.exr", {"Y"}, {2.5F}), {}).values[0], 2.5F);
}

TEST_F(AlbedoPicture, FindsPixelsThatAreMissing) {
  for (const float value :
       {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_TRUE(std::isnan(read_albedo_picture(write_floats("y.exr", {"Y"}, {value}), {}).values[0])) << value;
  }
  EXPECT_TRUE(std::isnan(read_albedo_picture(write_floats("ya.exr", {"Y", "A"}, {0.5F, 0.5F}), {}).values[0]));
  EXPECT_EQ(read_albedo_picture(write_floats("ya.exr", {"Y", "A"}, {0.5F, 1.0F}), {}).values[0], 0.5F);
}

TEST_F(AlbedoPicture, PutsItsCentreAtTheLongitudeGiven) {
  const std::string picture = write_bytes("a.png", 64, 32, 9, 9, 9);
  EXPECT_EQ(read_albedo_picture(picture, {}).west_edge_deg, -180.0);
  EXPECT_NEAR(read_albedo_picture(picture, {180.0 * deg, AlbedoEncoding::linear}).west_edge_deg, 0.0, 1e-12);
}

TEST_F(AlbedoPicture, RefusesOtherFiles) {
  test::expect_error(ErrorKind::input, {"odd.png", "has 64 x 33 pixels", "twice as wide as high"},
                     [&] { return read_albedo_picture(write_bytes("odd.png", 64, 33, 9, 9, 9), {}); });
  test::expect_error(ErrorKind::input, {"small.png", "from 64 x 32"},
                     [&] { return read_albedo_picture(write_bytes("small.png", 32, 16, 9, 9, 9), {}); });
  test::expect_error(ErrorKind::file, {"text.jpg", "cannot be read"},
                     [&] { return read_albedo_picture(write("text.jpg", "no picture at all"), {}); });
  test::expect_error(ErrorKind::file, {"none.png"}, [&] { return read_albedo_picture(path("none.png"), {}); });
  test::expect_error(ErrorKind::argument, {"gamma", "automatic, srgb and linear"},
                     [] { return parse_albedo_encoding("gamma"); });
}

} // namespace
} // namespace vesper
