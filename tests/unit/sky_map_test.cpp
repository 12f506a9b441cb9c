#include "support/folder_test.hpp"

#include "vesper/assets/cube_pyramid.hpp"
#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/image_file.hpp"
#include "vesper/assets/sky_map.hpp"
#include "vesper/base/error.hpp"
#include "vesper/catalog_tools/panorama_light.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

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
    EXPECT_NEAR(magnitude, field.anchor_mag_arcsec2, 0.05) << field.name;
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
  const double black = brightness(0.0, -27.0); // near the galactic pole
  EXPECT_GT(brightness(80.9, -69.8) - black, 3.0 * (brightness(110.0, -80.0) - black));
  EXPECT_GT(brightness(13.2, -72.8) - black, 3.0 * (brightness(0.0, -60.0) - black));
}

/// A field of two kinds of pixels whose mean luminance, by a law, is that of an anchor.
std::vector<AnchorSample> field_of(const AnchoredLaw& law, double mag_arcsec2) {
  const double mean = luminance_of_magnitude(mag_arcsec2);
  const auto pixel = [&](double luminance, double solid_angle) {
    return AnchorSample{std::pow((luminance - law.black_cd_m2) / law.scale_cd_m2, 1.0 / law.exponent), solid_angle};
  };
  const double swing = 0.3 * (mean - law.black_cd_m2);
  return {pixel(mean + swing, 1.0e-5), pixel(mean - 0.5 * swing, 2.0e-5)};
}

TEST(AnchoredLaws, AreFoundFromTheirFields) {
  const auto fields = sky_fields();
  for (const AnchoredLaw& law : {AnchoredLaw{2.0e-3, 0.6, 2.2e-5}, AnchoredLaw{0.5, 2.2, 0.0}}) {
    const AnchorSamples samples{field_of(law, fields[0].anchor_mag_arcsec2),
                                field_of(law, fields[2].anchor_mag_arcsec2),
                                field_of(law, fields[3].anchor_mag_arcsec2)};
    const AnchoredLaw found = fit_anchors(samples, "made.png");
    EXPECT_NEAR(found.exponent / law.exponent, 1.0, 1e-9);
    EXPECT_NEAR(found.scale_cd_m2 / law.scale_cd_m2, 1.0, 1e-8);
    EXPECT_NEAR(found.black_cd_m2, law.black_cd_m2, 1e-12);
  }
  // Without poles, or with black ones, all of their light is the black's.
  const AnchoredLaw law{1.0e-3, 1.3, luminance_of_magnitude(fields[0].anchor_mag_arcsec2)};
  AnchorSamples samples{{}, field_of(law, fields[2].anchor_mag_arcsec2), field_of(law, fields[3].anchor_mag_arcsec2)};
  EXPECT_NEAR(fit_anchors(samples, "made.png").black_cd_m2, law.black_cd_m2, 1e-12);
  samples.poles = samples.sagittarius;
  EXPECT_THROW((void)fit_anchors(samples, "made.png"), Error);
  EXPECT_THROW((void)fit_anchors({}, "made.png"), Error);
}

/// 6 n^2 texels of noise; smooth is of no help against a texel in the wrong place.
std::vector<float> noise(int face_size) {
  std::vector<float> texels;
  for (std::size_t i = 0; i < 4 * cube_texel_count(face_size); ++i) {
    texels.push_back(static_cast<float>((i * 2654435761U >> 7U) % 1000U));
  }
  return texels;
}

TEST(CubePyramidTest, WhatIsReadOfEverySizeAddsUpToTheSameLight) {
  constexpr int fine = 150;
  for (const int face_size : {16, 17, 31, 40}) {
    const CubePyramid pyramid(face_size, noise(face_size));
    EXPECT_EQ(pyramid.levels().back().face_size, 1);
    double wanted = 0.0;
    for (std::size_t i = 0; i < cube_texel_count(face_size); ++i) {
      wanted += cube_texel(face_size, i).solid_angle_sr * static_cast<double>(pyramid.levels()[0].texels[4 * i + 2]);
    }
    for (std::size_t level = 0; level < pyramid.levels().size(); ++level) {
      double found = 0.0;
      for (std::size_t i = 0; i < cube_texel_count(fine); ++i) {
        const CubeTexel texel = cube_texel(fine, i);
        found += texel.solid_angle_sr * pyramid.at(texel.direction, static_cast<double>(level)).z;
      }
      // The first size is the map's own; what its texels stand for is a matter of how they are counted.
      EXPECT_NEAR(found / wanted, 1.0, 2.0e-3) << face_size << ", halved " << level << " times";
    }
  }
}

TEST(CubePyramidTest, EvenLightStaysEven) {
  for (const int face_size : {16, 25}) {
    const CubePyramid pyramid(face_size, std::vector<float>(4 * cube_texel_count(face_size), 0.125F));
    for (const CubePyramid::Level& level : pyramid.levels()) {
      for (const float value : level.texels) {
        ASSERT_FLOAT_EQ(value, 0.125F) << level.face_size;
      }
    }
  }
}

TEST(CubePyramidTest, IsWhatItsTexelsSayAndHasNoSeams) {
  constexpr int n = 16;
  const CubePyramid pyramid(n, noise(n));
  for (std::size_t i = 0; i < cube_texel_count(n); ++i) {
    EXPECT_NEAR(pyramid.at(3.0 * cube_texel(n, i).direction, 0.0).y,
                static_cast<double>(pyramid.levels()[0].texels[4 * i + 1]), 1e-6);
  }
  // Across all edges and corners nothing jumps.
  for (int axis = 0; axis < 3; ++axis) {
    for (double along = -1.0; along <= 1.0; along += 1.0 / 37.0) {
      for (const double level : {0.0, 0.4, 1.0, 2.7}) {
        for (const auto& [a, b] : {std::pair(1.0, 1.0), std::pair(1.0, -1.0), std::pair(-1.0, 1.0)}) {
          Vec3 edge(0.0);
          edge[axis] = along;
          edge[(axis + 1) % 3] = a;
          edge[(axis + 2) % 3] = b;
          Vec3 other = edge;
          edge[(axis + 1) % 3] *= 1.0 + 1e-9;
          other[(axis + 2) % 3] *= 1.0 + 1e-9;
          EXPECT_NEAR(pyramid.at(edge, level).z, pyramid.at(other, level).z, 1e-4) << axis << " " << along;
        }
      }
    }
  }
  EXPECT_EQ(pyramid.at({0, 0, 1}, -5.0), pyramid.at({0, 0, 1}, 0.0));
  EXPECT_EQ(pyramid.at({0, 0, 1}, 99.0), pyramid.at({0, 0, 1}, 4.0));
  EXPECT_THROW(CubePyramid(n, std::vector<float>(7)), Error);
  EXPECT_THROW(CubePyramid(0, {}), Error);
}

} // namespace
} // namespace vesper
