// Colours on the display of an eye that is adapted to the light of the scene.
#include "render/mapped_light.hpp"

#include "support/truth.hpp"

#include "vesper/astro/star_place.hpp"
#include "vesper/sky/scene_white.hpp"

#include <cstdio>
#include <optional>

namespace vesper::test {
namespace {

class WhiteAdaptation : public RenderTest {
protected:
  gpu::DisplayChain chain{shaders};
};

gpu::DisplaySettings adapted_eye(const std::optional<Vec3>& light) {
  gpu::DisplaySettings settings;
  settings.format = gpu::PixelFormat::rgba16;
  settings.optics.glare = settings.optics.acuity = false;
  settings.light = light;
  return settings;
}

/// Of a full Moon high up, as adapting_light() finds it.
const Vec3 moonlight_lux = 0.2 * Vec3(0.9879, 1.0, 0.8249);

PictureLight colored(const View& view, double luminance, const Vec2& x_and_z) {
  PictureLight light = even_light(view, luminance);
  for (std::size_t i = 0; i < light.frame.size(); i += 4) {
    light.frame[i] = static_cast<float>(luminance * x_and_z.x);
    light.frame[i + 2] = static_cast<float>(luminance * x_and_z.y);
  }
  return light;
}

TEST_F(WhiteAdaptation, ShowsItsWhiteAsTheDisplaysAndKeepsLuminance) {
  const f64::DisplayModel display = display_model({});
  const View view = square_view(48);
  const Vec3 display_white = glm::inverse(display.rgb_from_xyz) * Vec3(1.0);
  const auto added = [&](const std::optional<Vec3>& by, const PictureLight& light) {
    gpu::DisplaySettings settings = adapted_eye(by);
    settings.tone.stops = -2.0; // the display has room for all of the colours
    chain.use(settings);
    const std::vector<std::uint16_t> codes = codes_of(chain, light);
    Vec3 sum(0.0);
    for (int row = 0; row < view.height; ++row) {
      sum += light_at(codes, view.width, row, row, display, 0.0) - chain.curve().floor_cd_m2 * display_white;
    }
    return sum / static_cast<double>(view.height);
  };
  ErrorSum luminance_error;
  ErrorSum color_error;
  ErrorSum white_error;
  for (const Vec3& by : {moonlight_lux, 5.0e5 * moonlight_lux}) {
    const ColorAdaptation expected = adapted_to_light(by, display_white);
    const Vec2 white(by.x / by.y, by.z / by.y);
    for (const double luminance : {10.0, 300.0, 1.0e4}) {
      for (const Vec2& x_and_z : {white, Vec2(1.3, 0.5), Vec2(0.9, 1.4), Vec2(0.8, 0.7)}) {
        const PictureLight light = colored(view, luminance, x_and_z);
        const Vec3 adapted = added(by, light);
        luminance_error.add(100.0 * (adapted.y / added(std::nullopt, light).y - 1.0));
        const Vec3 scene(x_and_z.x, 1.0, x_and_z.y);
        const Vec3 shown = expected.shown_from_xyz * scene;
        const auto sum = [](const Vec3& xyz) { return xyz.x + xyz.y + xyz.z; };
        color_error.add(adapted.x / sum(adapted) - shown.x / sum(shown));
        color_error.add(adapted.y / sum(adapted) - shown.y / sum(shown));
        if (x_and_z == white && by.y > 1.0e4) {
          white_error.add(adapted.x / sum(adapted) - 0.3127);
          white_error.add(adapted.y / sum(adapted) - 0.3290);
        }
      }
    }
    // What rods see has no white.
    const PictureLight night = colored(view, 1.0e-3, {1.3, 0.5});
    const Vec3 with = added(by, night);
    const Vec3 without = added(std::nullopt, night);
    EXPECT_LT(glm::distance(with / with.y, without / without.y), 0.005);
  }
  luminance_error.hold("luminance on the display, adapted to a white over not", 0.02, "%");
  color_error.hold("colour on the display of an eye adapted to a white, x and y", 0.0005, "");
  white_error.hold("that white by day, x and y", 0.0005, "");
}

TEST_F(WhiteAdaptation, OfAnEyeAdaptedToTheDisplaysWhiteChangesNothing) {
  const View view = square_view(64);
  for (const double luminance : {1.0e-3, 0.1, 30.0}) {
    const PictureLight light = colored(view, luminance, {1.3, 0.5});
    chain.use(adapted_eye(std::nullopt));
    const std::vector<std::uint16_t> plain = codes_of(chain, light);
    chain.use(adapted_eye(20.0 * f64::xyz_of_chromaticity({0.3127, 0.3290})));
    const std::vector<std::uint16_t> adapted = codes_of(chain, light);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      ASSERT_NEAR(plain[i], adapted[i], 1) << i;
    }
  }
}

TEST_F(WhiteAdaptation, TheFullMoonIsWhiteAndTheEclipsedOneCopper) {
  const f64::DisplayModel display = display_model({});
  const Vec3 floor = glm::inverse(display.rgb_from_xyz) * Vec3(1.0);
  FrameOptions options = bare_stars();
  options.layers.reset().set(static_cast<std::size_t>(Layer::moon));
  options.air.extinction = true;
  const auto moon = [&](const char* utc, const Observer& observer, bool adapts) {
    const SkyState sky = sky_state(parse_instant(utc), observer);
    View view = square_view(40, 0.8 * deg);
    view.azimuth = horizontal_of(sky.moon.place.direction_horizon).azimuth;
    view.altitude = horizontal_of(sky.moon.place.direction_horizon).altitude;
    chain.use(adapted_eye(adapts ? std::optional(adapting_light(sky)) : std::nullopt));
    const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, {}, options), {.mapping = &chain});
    Vec3 sum(0.0);
    for (int i = 0; i < view.width * view.height; ++i) {
      sum += light_at(frame.rgba16, view.width, i % view.width, i / view.width, display, 0.0) -
             chain.curve().floor_cd_m2 * floor;
    }
    const Vec2 xy = Vec2(sum) / (sum.x + sum.y + sum.z);
    std::printf("Moon of %s, eye %s: x, y = %.4f, %.4f on the display\n", utc, adapts ? "adapted" : "not adapted", xy.x,
                xy.y);
    return xy;
  };
  const Vec2 white(0.3127, 0.3290);
  const Observer la_palma{28.76 * deg, -17.88 * deg, 2400.0 * metre};
  const Observer mangalore{12.87 * deg, 74.88 * deg, 0.0 * metre};
  // Ivory: a third of the distance is left by incomplete adaptation, the rest is the air's.
  EXPECT_LT(glm::distance(moon("2026-08-28T01:30:00Z", la_palma, true), white), 0.025);
  EXPECT_GT(glm::distance(moon("2026-08-28T01:30:00Z", la_palma, false), white), 0.045);
  const Vec2 copper = moon("2011-06-15T20:12:37Z", mangalore, true);
  EXPECT_GT(copper.x, 0.37);
  EXPECT_LT(glm::distance(copper, moon("2011-06-15T20:12:37Z", mangalore, false)), 0.002);
  // Low in the sky the air reddens it, to whatever the eye is adapted.
  EXPECT_GT(moon("2026-08-28T20:10:00Z", la_palma, true).x, 0.36);
}

} // namespace
} // namespace vesper::test
