// The Moon's cube map: where its texels lie, what its file holds, and what is refused.
#include "support/folder_test.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/half_float.hpp"
#include "vesper/assets/image_file.hpp"
#include "vesper/assets/moon_map.hpp"
#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace vesper {
namespace {

TEST(CubeMap, ATexelLiesWhereTheProjectionHasIt) {
  constexpr int n = 6;
  const f64::PixelFrame frame{f64::projection_cubemap, {n, 6 * n}, 0.5 * n};
  for (std::size_t i = 0; i < cube_texel_count(n); ++i) {
    const std::size_t column = i % n;
    const std::size_t row = i / n;
    Vec3 view;
    ASSERT_TRUE(f64::unproject({static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5}, frame, view));
    EXPECT_LT(glm::length(f64::cube_from_view(view) - cube_texel(n, i).direction), 1e-14) << i;
  }
}

TEST(CubeMap, TexelsLieOnTheFacesTheyAreCountedOn) {
  for (std::size_t i = 0; i < cube_texel_count(10); ++i) {
    EXPECT_EQ(f64::cube_face(cube_texel(10, i).direction, 0), static_cast<int>(i / 100));
  }
}

TEST(CubeMap, FacesStandAsOpenExrStacksThem) {
  // Each face's outward axis, and what lies to the right and above in its picture.
  const Vec3 x(1, 0, 0);
  const Vec3 y(0, 1, 0);
  const Vec3 z(0, 0, 1);
  const Vec3 expected[6][3] = {{z, y, x}, {-z, y, -x}, {x, z, y}, {x, -z, -y}, {-x, y, z}, {x, y, -z}};
  for (int face = 0; face < 6; ++face) {
    const Mat3 axes = f64::cube_face_axes(face);
    for (int column = 0; column < 3; ++column) {
      EXPECT_EQ(axes[column], expected[face][column]) << face;
    }
  }
}

TEST(CubeMap, TexelsCoverTheSphere) {
  for (const int n : {16, 64}) {
    double sum = 0.0;
    for (std::size_t i = 0; i < cube_texel_count(n); ++i) {
      sum += cube_texel(n, i).solid_angle_sr;
    }
    EXPECT_NEAR(sum / (4.0 * std::numbers::pi), 1.0, 0.6 / (n * n));
  }
}

TEST(HalfFloat, RoundsAsTheFormatDoes) {
  EXPECT_EQ(nearest_half(1.0), 1.0F);
  EXPECT_EQ(nearest_half(0.1), 0.0999755859375F); // 0x2E66
  EXPECT_EQ(nearest_half(-2.0 / 3.0), -0.66650390625F);
  EXPECT_EQ(nearest_half(0.0), 0.0F);
  EXPECT_EQ(nearest_half(1.0 + 0x1p-11), 1.0F); // ties to even
  EXPECT_EQ(nearest_half(0x1.8p-24), 0x1p-23F); // below the normal numbers
  EXPECT_EQ(nearest_half(0x1p-26), 0.0F);
  EXPECT_TRUE(is_half(65504.0F));
  EXPECT_FALSE(is_half(65536.0F));
  EXPECT_FALSE(is_half(0.1F));
}

/// A round Moon of one albedo.
MoonMap plain_moon(int face_size, double albedo) {
  MoonMap map{face_size, {}, {}};
  for (std::size_t i = 0; i < cube_texel_count(face_size); ++i) {
    const Vec3 n = cube_texel(face_size, i).direction;
    map.texels.insert(map.texels.end(), {static_cast<float>(albedo), static_cast<float>(n.x), static_cast<float>(n.y),
                                         static_cast<float>(n.z)});
  }
  map.provenance = {"a.png", "00", "b.img", "11", "22", "tool 1", "--face 16", 5, 1, 7, 2, 0.3};
  return map;
}

class MoonMapFile : public test::FolderTest {
protected:
  /// That reading the file fails with these words.
  void expect_refusal(const std::string& name, const std::string& words) const {
    try {
      static_cast<void>(read_moon_map(path(name)));
      ADD_FAILURE() << "should say " << words;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      EXPECT_FALSE(error.context().remedy.empty());
    }
  }
};

TEST_F(MoonMapFile, ReadsBackWhatWasWritten) {
  const MoonMap map = plain_moon(16, 0.1207);
  write_moon_map(path("moon.exr"), map);
  const MoonMap back = read_moon_map(path("moon.exr"));
  EXPECT_EQ(back.face_size, 16);
  EXPECT_EQ(back.texels, map.texels);
  EXPECT_EQ(back.provenance.albedo_file, "a.png");
  EXPECT_EQ(back.provenance.label_sha256, "22");
  EXPECT_EQ(back.provenance.options, "--face 16");
  EXPECT_EQ(back.provenance.elevation_filled, 2U);
  EXPECT_EQ(back.provenance.albedo_scale, 0.3);
  write_moon_map(path("again.exr"), back);
  EXPECT_EQ(text("moon.exr"), text("again.exr"));
  const Bytes bytes = read_file(path("moon.exr"));
  EXPECT_EQ(decode_moon_map(bytes, "moon.exr").texels, map.texels);
}

TEST_F(MoonMapFile, HoldsSixteenBitsWhereTheseAreExact) {
  MoonMap map = plain_moon(16, 0.125);
  write_moon_map(path("single.exr"), map);
  for (float& value : map.texels) {
    value = nearest_half(static_cast<double>(value));
  }
  write_moon_map(path("half.exr"), map);
  EXPECT_EQ(read_moon_map(path("half.exr")).texels, map.texels);
  EXPECT_LT(text("half.exr").size(), text("single.exr").size());
}

TEST_F(MoonMapFile, RefusesOtherPictures) {
  write("text.exr", "no picture");
  expect_refusal("text.exr", "cannot be read");
  expect_refusal("missing.exr", "cannot be read");
  const std::vector<float> values(4UL * 16 * 96, 0.5F);
  write_exr(path("sky.exr"), 16, 96, values, {});
  expect_refusal("sky.exr", "no channel A");
  write_exr(path("square.exr"), 16, 16, std::span(values).first(4UL * 16 * 16), {});
  expect_refusal("square.exr", "is no cube map: it has 16 x 16 pixels");
  write_exr(path("bare.exr"), 16, 96, {"A", "NX", "NY", "NZ"}, values, ExrDepth::single, {});
  expect_refusal("bare.exr", "albedo_file: is missing from the provenance");
  write_moon_map(path("whole.exr"), plain_moon(16, 0.1));
  write("cut.exr", text("whole.exr").substr(0, 3000));
  expect_refusal("cut.exr", "cannot be decoded");
}

TEST_F(MoonMapFile, RefusesTexelsThatBreakARule) {
  const auto expect = [&](auto change, const std::string& words) {
    MoonMap map = plain_moon(16, 0.1);
    change(map);
    try {
      write_moon_map(path("bad.exr"), map);
      ADD_FAILURE() << "should say " << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::argument);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(path("bad.exr")));
  };
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  expect([&](MoonMap& map) { map.texels[4 * 17 + 2] = nan; }, "column 1, row 1: a number is not finite");
  expect([](MoonMap& map) { map.texels[0] = 0.0F; }, "the albedo is not above 0");
  expect([](MoonMap& map) { map.texels[0] = 1.01F; }, "the albedo is not above 0 and at most 1");
  expect([](MoonMap& map) { map.texels[1] += 0.1F; }, "not a unit vector");
  expect(
      [](MoonMap& map) {
        for (int i = 1; i < 4; ++i) {
          map.texels[static_cast<std::size_t>(i)] *= -1.0F;
        }
      },
      "points into the Moon");
  expect([](MoonMap& map) { map.texels.pop_back(); }, "numbers where 6144 belong");
  expect([](MoonMap& map) { map.face_size = 15; }, "even numbers from 16");
}

TEST(DefaultMoonMap, IsAWholeMoonOfTheRightAlbedo) {
  const MoonMap& map = default_moon_map();
  EXPECT_EQ(map.face_size, 256);
  EXPECT_EQ(map.texels.size(), 4 * cube_texel_count(256));
  // The Moon of V = -12.73 at 384400 km, lit by a Sun of V = -26.75.
  const double ratio = 384400.0 / 1737.4;
  EXPECT_NEAR(moon_disc_albedo(map), std::pow(10.0, 0.4 * (12.73 - 26.75)) * ratio * ratio, 0.0001);
}

} // namespace
} // namespace vesper
