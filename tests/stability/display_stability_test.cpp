// The display's model where numbers are extreme.
#include "vesper/base/vector.hpp"
#include "vesper/plan/display.hpp"

#include "support/expect_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace vesper {
namespace {

const Vec3 d65(0.3127 / 0.3290, 1.0, 0.3583 / 0.3290);

f32::DisplayModel single(const f64::DisplayModel& model) {
  return {f32::mat3(model.rgb_from_xyz),
          model.transfer,
          static_cast<float>(model.gamma),
          static_cast<float>(model.black_cd_m2),
          static_cast<float>(model.range_cd_m2),
          static_cast<float>(model.ambient_cd_m2),
          static_cast<float>(model.cross_reflection),
          static_cast<float>(model.pixel_sr)};
}

std::vector<Display> displays() {
  std::vector<Display> all;
  for (const Transfer transfer : {Transfer::srgb, Transfer::gamma, Transfer::pq}) {
    for (const Primaries primaries : {Primaries::srgb, Primaries::display_p3, Primaries::rec2020}) {
      for (const double peak : {0.001, 1.0, 200.0, 10000.0}) {
        Display display;
        display.transfer = transfer;
        display.primaries = primaries;
        display.peak = peak * candela_per_m2;
        display.black = std::min(0.5 * peak, display_black_range_cd_m2.highest) * candela_per_m2;
        display.ambient = (peak == 1.0 ? 1000.0 : 0.0) * candela_per_m2;
        display.dome_reflectance = peak == 200.0 ? 0.98 : 0.0;
        all.push_back(display);
      }
    }
  }
  return all;
}

TEST(DisplayStability, AnyLightGivesCodesInRange) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  constexpr float largest = std::numeric_limits<float>::max();
  constexpr std::array<float, 13> numbers{0.0F,     1.0e-38F, 1.0e-6F, 0.2F,    199.9F,   2.0e9F,   largest,
                                          infinite, -1.0e-6F, -1.0F,   -2.0e9F, -largest, -infinite};
  for (const Display& display : displays()) {
    const f32::DisplayModel model = single(display_model(display));
    for (const float x : numbers) {
      for (const float y : numbers) {
        for (const float z : numbers) {
          for (const float mean : {0.0F, 50.0F, 2.0e9F}) {
            const f32::vec3 codes = f32::display_codes({x, y, z}, model, mean);
            for (int channel = 0; channel < 3; ++channel) {
              ASSERT_GE(codes[channel], 0.0F) << x << " " << y << " " << z;
              ASSERT_LE(codes[channel], 1.0F) << x << " " << y << " " << z;
            }
            const f32::vec3 light = f32::display_light(codes, model, mean);
            ASSERT_TRUE(std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z));
          }
        }
      }
    }
  }
}

TEST(DisplayStability, MoreLightNeverGivesLess) {
  for (const Display& display : displays()) {
    const f32::DisplayModel model = single(display_model(display));
    for (const f32::vec3 color : {f32::vec3(d65), f32::vec3(2.0F, 1.0F, 0.02F), f32::vec3(0.3F, 1.0F, 3.0F)}) {
      float before = 0.0F;
      for (int i = 0; i <= 3000; ++i) {
        // 1e-6 to 2e9 cd/m2.
        const float luminance = 1.0e-6F * std::pow(2.0e15F, static_cast<float>(i) / 3000.0F);
        const f32::vec3 codes = f32::display_codes(luminance * color, model, 0.0F);
        const float shown = f32::display_light(codes, model, 0.0F).y;
        // Two equal codes may differ by a rounding error of the colour's components.
        ASSERT_GE(shown, before * (1.0F - 2.0e-5F)) << luminance;
        before = std::max(shown, before);
      }
    }
  }
}

TEST(DisplayStability, GreyStaysGrey) {
  float worst = 0.0F;
  for (const Display& display : displays()) {
    const f32::DisplayModel model = single(display_model(display));
    for (int i = 0; i <= 300; ++i) {
      const float luminance = 1.0e-6F * std::pow(2.0e15F, static_cast<float>(i) / 300.0F);
      const f32::vec3 shown =
          f32::display_light(f32::display_codes(luminance * f32::vec3(d65), model, 0.0F), model, 0.0F);
      const float sum = shown.x + shown.y + shown.z;
      worst = std::max({worst, std::abs(shown.x / sum - 0.3127F), std::abs(shown.y / sum - 0.3290F)});
    }
  }
  std::printf("grey on %zu displays: x or y off by %.2g at worst\n", displays().size(), static_cast<double>(worst));
  EXPECT_LT(worst, 1.0e-4F);
}

TEST(DisplayStability, CodesOutsideTheirRangeGiveLightInsideIts) {
  for (const Display& display : displays()) {
    const f64::DisplayModel model = display_model(display);
    for (const double code : {-1.0, 2.0, 1.0e30}) {
      const Vec3 light = f64::display_light(Vec3(code), model, 0.0);
      EXPECT_GE(light.y, f64::display_floor_cd_m2(model, 0.0) * (1.0 - 1.0e-12));
      EXPECT_LE(light.y, f64::display_ceiling_cd_m2(model, 0.0) * (1.0 + 1.0e-12));
    }
  }
}

TEST(DisplayStability, ADisplayThatIsNoneIsRefused) {
  const auto with = [](auto change) {
    Display display;
    change(display);
    return [display] { return display_model(display); };
  };
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  using test::expect_error;
  constexpr auto kind = ErrorKind::argument;
  expect_error(kind, {"black", "0.2", "half"}, with([](Display& d) { d.peak = d.black; }));
  expect_error(kind, {"peak", "nan"}, with([](Display& d) { d.peak = none * candela_per_m2; }));
  expect_error(kind, {"peak", "inf"},
               with([](Display& d) { d.peak = std::numeric_limits<double>::infinity() * candela_per_m2; }));
  expect_error(kind, {"black", "-1"}, with([](Display& d) { d.black = -1.0 * candela_per_m2; }));
  expect_error(kind, {"ambient", "nan"}, with([](Display& d) { d.ambient = none * candela_per_m2; }));
  expect_error(kind, {"gamma", "0"}, with([](Display& d) { d.gamma = 0.0; }));
  expect_error(kind, {"dome reflectance", "1"}, with([](Display& d) { d.dome_reflectance = 1.0; }));
  expect_error(kind, {"dome gain", "0"}, with([](Display& d) { d.dome_gain = 0.0; }));
  expect_error(kind, {"pixels per degree", "0"}, with([](Display& d) { d.pixels_per_degree = 0.0; }));
}

} // namespace
} // namespace vesper
