#include "support/folder_test.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/image_file.hpp"
#include "vesper/assets/sky_map.hpp"
#include "vesper/base/error.hpp"
#include "vesper/catalog_tools/panorama_light.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace vesper {
namespace {

class SkyMaps : public test::FolderTest {
protected:
  static SkyMap ramp() {
    SkyMap map{16, {}, {"in.fits", "abc", "GLON-CAR, galactic", "test", "--face 16", "given", "ours", "{}"}};
    for (std::size_t i = 0; i < 4 * cube_texel_count(16); ++i) {
      map.texels.push_back(0.001F * static_cast<float>(i));
    }
    return map;
  }
  void expect_error(const std::string& name, const std::string& words) const {
    try {
      (void)read_sky_map(path(name));
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_FALSE(error.context().remedy.empty());
    }
  }
};

TEST_F(SkyMaps, ComeBackAsWritten) {
  const SkyMap map = ramp();
  write_sky_map(path("a.exr"), map);
  const SkyMap again = read_sky_map(path("a.exr"));
  EXPECT_EQ(again.face_size, 16);
  EXPECT_EQ(again.texels, map.texels);
  EXPECT_EQ(again.provenance.calibration, "given");
  EXPECT_EQ(again.provenance.budget, "{}");
  write_sky_map(path("b.exr"), again);
  EXPECT_TRUE(text("a.exr") == text("b.exr"));
}

TEST_F(SkyMaps, OtherPicturesAreNamed) {
  write_exr(path("flat.exr"), 16, 16, std::vector<float>(16UL * 16UL * 4UL), {});
  expect_error("flat.exr", "is no cube map");
  write_exr(path("other.exr"), 16, 96, {"R", "G", "B"}, std::vector<float>(16UL * 96UL * 3UL), ExrDepth::single, {});
  expect_error("other.exr", "no channel X");
  write_exr(path("bare.exr"), 16, 96, std::vector<float>(16UL * 96UL * 4UL), {});
  expect_error("bare.exr", "missing from the provenance");
  SkyMap map = ramp();
  map.texels[4 * 17 + 2] = std::numeric_limits<float>::infinity();
  write_sky_map(path("infinite.exr"), map);
  expect_error("infinite.exr", "column 1, row 1: a number is not finite");
  write("text.exr", "no picture");
  expect_error("text.exr", "cannot be read");
  map.texels.pop_back();
  EXPECT_THROW(write_sky_map(path("short.exr"), map), Error);
}

TEST_F(SkyMaps, TheDefaultHasThePublishedBrightness) {
  const SkyMap& map = default_sky_map();
  EXPECT_EQ(map.provenance.calibration.rfind("uncalibrated", 0), 0U);
  EXPECT_NE(map.provenance.credit.find("Mellinger"), std::string::npos);
  for (const SkyField& field : sky_fields()) {
    const Vec3 middle = direction_of(field);
    double light = 0.0;
    double solid_angle = 0.0;
    for (std::size_t i = 0; i < cube_texel_count(map.face_size); ++i) {
      const CubeTexel texel = cube_texel(map.face_size, i);
      EXPECT_GE(map.texels[4 * i + 1], 0.0F);
      if (dot(texel.direction, middle) > std::cos(field_radius_deg * std::numbers::pi / 180.0)) {
        light += static_cast<double>(map.texels[4 * i + 1]) * texel.solid_angle_sr;
        solid_angle += texel.solid_angle_sr;
      }
    }
    const double magnitude = magnitude_of_luminance(light / solid_angle);
    if (field.anchor_mag_arcsec2) {
      EXPECT_NEAR(magnitude, *field.anchor_mag_arcsec2, 0.05) << field.name;
    } else {
      EXPECT_GT(magnitude, 24.0) << field.name;
    }
  }
  // The Large Magellanic Cloud stands out of its surroundings, which a mirrored or turned map would not show.
  const auto brightness = [&](double ra_deg, double dec_deg) {
    const double ra = ra_deg * std::numbers::pi / 180.0;
    const double dec = dec_deg * std::numbers::pi / 180.0;
    const Vec3 direction(std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec));
    double light = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < cube_texel_count(map.face_size); ++i) {
      if (dot(cube_texel(map.face_size, i).direction, direction) > std::cos(0.03)) {
        light += static_cast<double>(map.texels[4 * i + 1]);
        ++count;
      }
    }
    return light / count;
  };
  EXPECT_GT(brightness(80.9, -69.8), 3.0 * brightness(110.0, -80.0));
  EXPECT_GT(brightness(13.2, -72.8), 3.0 * brightness(0.0, -60.0));
}

} // namespace
} // namespace vesper
