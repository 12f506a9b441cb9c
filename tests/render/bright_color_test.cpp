// The colour of light so bright that the display has no room for it.
#include "render/mapped_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace vesper::test {
namespace {

/// X, Y, Z of unit luminance: a Moon low in the sky, an eclipsed one and blue light.
constexpr std::array<std::array<float, 3>, 3> colored{
    {{1.10F, 1.0F, 0.27F}, {1.50F, 1.0F, 0.17F}, {1.05F, 1.0F, 2.0F}}};

class BrightColors : public RenderTest {
protected:
  BrightColors() { settings_.optics.glare = settings_.optics.acuity = false; }

  /// What a picture adds to the display's floor.
  std::vector<f64::vec3> shown(const PictureLight& light) {
    settings_.format = gpu::PixelFormat::rgba16;
    chain_.use(settings_);
    const std::vector<std::uint16_t> codes = codes_of(chain_, light);
    const f64::DisplayModel display = display_model({});
    const f64::vec3 floor =
        light_at(std::vector<std::uint16_t>(4, 0), 1, 0, 0, display, 0.0); // black, as the display has it
    std::vector<f64::vec3> added;
    for (int row = 0; row < light.view.height; ++row) {
      for (int column = 0; column < light.view.width; ++column) {
        added.push_back(light_at(codes, light.view.width, column, row, display, 0.0) - floor);
      }
    }
    return added;
  }

  gpu::DisplaySettings settings_;
  gpu::DisplayChain chain_{shaders};
};

/// A dark sky with light of a colour in one column of eight.
PictureLight lit_column(const View& view, double luminance, const std::array<float, 3>& color) {
  PictureLight light = even_light(view, 1.0e-2 * luminance);
  const auto y = static_cast<float>(luminance);
  for (std::size_t i = 0; i < light.frame.size(); i += 4) {
    if (i / 4 % 8 == 3) {
      std::transform(color.begin(), color.end(), light.frame.begin() + static_cast<std::ptrdiff_t>(i),
                     [y](float part) { return part * y; });
    }
  }
  return light;
}

double x_over_white(const f64::vec3& xyz) { return xyz.x / xyz.y - 0.95047; }

TEST_F(BrightColors, KeepTheirColourUntilTheyDazzle) {
  const View view = square_view(64);
  for (const std::array<float, 3>& color : colored) {
    const double asked = static_cast<double>(color[0]) - 0.95047;
    if (color[2] > 1.0F) {
      continue; // X hardly tells blue from white
    }
    double last = 1.0;
    for (const double luminance : {10.0, 800.0, 5.0e3, 5.0e4, 1.0e8}) {
      const double kept = x_over_white(shown(lit_column(view, luminance, color))[3]) / asked;
      std::printf("light of X %.2f, Z %.2f times Y and %g cd/m2 keeps %.2f of its colour\n",
                  static_cast<double>(color[0]), static_cast<double>(color[2]), luminance, kept);
      EXPECT_LT(kept, last + 0.01);
      last = kept;
      if (luminance < 1.0e3) {
        EXPECT_GT(kept, 0.45);
      }
    }
    EXPECT_NEAR(last, 0.0, 0.02); // the Sun's disc
  }
}

TEST_F(BrightColors, WhiteIsNoDarkerThanTheDisplaysWhite) {
  const View view = square_view(64);
  for (const double luminance : {10.0, 800.0, 5.0e3}) {
    const f64::vec3 white = shown(lit_column(view, luminance, {0.95047F, 1.0F, 1.08883F}))[3];
    const double range = display_model({}).range_cd_m2;
    EXPECT_NEAR(white.y, chain_.curve().nodes.back().x, 0.01 * range);
    EXPECT_NEAR(x_over_white(white), 0.0, 0.002);
  }
}

TEST_F(BrightColors, MoreLightOfAColourNeverShowsLess) {
  const View view = square_view(192);
  for (const ToneOperator tone : {ToneOperator::visibility, ToneOperator::reinhard, ToneOperator::hable}) {
    settings_.tone.tone = tone;
    for (const std::array<float, 3>& color : colored) {
      PictureLight light{view, {}, {}};
      for (int i = 0; i < view.width * view.height; ++i) {
        const auto y = static_cast<float>(1.0e-6 * std::pow(2.0e15, i % view.width / (view.width - 1.0)));
        light.frame.insert(light.frame.end(), {color[0] * y, y, color[2] * y, 2.3F * y});
      }
      const std::vector<f64::vec3> added = shown(light);
      double last = 0.0;
      for (std::size_t column = 0; column < static_cast<std::size_t>(view.width); ++column) {
        double now = 0.0; // the mean of many, for what the dither adds
        constexpr std::size_t rows = 32;
        for (std::size_t row = 0; row < rows; ++row) {
          now += added.at(row * static_cast<std::size_t>(view.width) + column).y / rows;
        }
        ASSERT_GE(now, last - 1.0e-4 * std::max(last, 1.0)) << static_cast<int>(tone) << " column " << column;
        last = std::max(now, last);
      }
      EXPECT_GT(last, 0.95 * display_model({}).range_cd_m2);
    }
  }
}

} // namespace
} // namespace vesper::test
