// Discs of a few pixels, shared out among them on the CPU, against what the shader draws of the same discs.
#include "render/render_fixture.hpp"
#include "support/truth.hpp"
#include "support/turned_sky.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace vesper::test {
namespace {

Vec3 at_altitude(double altitude_deg) { return direction(30.0 * deg, altitude_deg * deg); }

SkyState sky_at(const char* stamp) { return sky_state(parse_instant(stamp), {50.0 * deg, 10.0 * deg, 0.0 * metre}); }

class DiscSprites : public RenderTest {
protected:
  DiscSprites() {
    options = bare_stars();
    options.layers.reset().set(static_cast<std::size_t>(Layer::moon));
    view.projection = Projection::perspective;
    view.width = view.height = 64;
    view.roll = 20.0 * deg;
  }

  /// Some fractions of a pixel beside the middle of the picture.
  void aim(const Vec3& at, double wide_px) {
    view.fov = 2.0 * std::atan(0.0046 * view.width / wide_px) * rad;
    const Horizontal horizontal = horizontal_of(at);
    view.azimuth = horizontal.azimuth + 0.0043 * view.fov;
    view.altitude = horizontal.altitude + 0.0061 * view.fov;
  }

  /// The disc as it is planned, and as the shader draws it.
  std::pair<gpu::Frame, gpu::Frame> both(const SkyState& sky, FramePlan plan) {
    PlannedDisc& disc = plan.moon ? plan.moon->picture : plan.sun.value().picture;
    EXPECT_TRUE(disc.sprite.has_value());
    gpu::Frame sprite = renderer.render(sky, view, plan);
    disc.sprite.reset();
    return {std::move(sprite), renderer.render(sky, view, plan)};
  }

  /// Adds each pixel's difference over the brightest, and the difference of the whole light.
  static void compare(const std::pair<gpu::Frame, gpu::Frame>& frames, int channel, ErrorSum& pixels, ErrorSum& light) {
    const auto& [sprite, drawn] = frames;
    double peak = 0.0;
    double sprite_light = 0.0;
    double drawn_light = 0.0;
    for (int y = 0; y < drawn.height; ++y) {
      for (int x = 0; x < drawn.width; ++x) {
        peak = std::max(peak, static_cast<double>(drawn.pixel(x, y)[channel]));
        sprite_light += static_cast<double>(sprite.pixel(x, y)[channel]);
        drawn_light += static_cast<double>(drawn.pixel(x, y)[channel]);
      }
    }
    light.add(100.0 * (sprite_light / drawn_light - 1.0));
    for (int y = 0; y < drawn.height; ++y) {
      for (int x = 0; x < drawn.width; ++x) {
        const auto here = static_cast<double>(drawn.pixel(x, y)[channel]);
        const auto difference = static_cast<double>(sprite.pixel(x, y)[channel]) - here;
        if (here > 0.0 || difference != 0.0) {
          pixels.add(100.0 * difference / peak);
        }
      }
    }
  }

  FrameOptions options;
  View view;
};

TEST_F(DiscSprites, AreTheMoonsThatTheShaderDraws) {
  for (const auto& [name, stamp] :
       {std::pair("full Moon", "2026-05-01T20:00:00Z"), std::pair("first quarter", "2026-05-23T20:00:00Z"),
        std::pair("crescent", "2026-05-19T20:00:00Z")}) {
    const SkyState sky = with_moon_at(sky_at(stamp), at_altitude(40.0));
    for (const double wide : {4.0, 8.0, 15.0}) {
      ErrorSum pixels;
      ErrorSum light;
      aim(sky.moon.place.direction_horizon, wide);
      compare(both(sky, plan_frame(sky, view, {}, options)), 1, pixels, light);
      const std::string what = std::string(name) + ", " + std::to_string(wide).substr(0, 4) + " px wide: ";
      pixels.hold(what + "pixels against drawn ones", 7.0, "% of the brightest");
      light.hold(what + "light", 1.0, "%");
    }
  }
}

TEST_F(DiscSprites, AreFlattenedAndReddenedOnTheHorizon) {
  options.air.refraction = options.air.extinction = true;
  SkyState sky = with_moon_at(sky_at("2026-05-01T20:00:00Z"), at_altitude(-0.3));
  sky.refraction = with_table(standard_refraction(0.0 * metre, Tier::standard));
  const Vec3 seen = apparent_direction(sky.moon.place.direction_horizon, sky.refraction);
  ErrorSum pixels;
  ErrorSum light;
  for (const double wide : {5.0, 15.0}) {
    aim(seen, wide);
    const auto frames = both(sky, plan_frame(sky, view, {}, options));
    for (const int channel : {0, 1, 2, 3}) {
      compare(frames, channel, pixels, light);
    }
  }
  pixels.hold("full Moon on the horizon: pixels against drawn ones", 7.0, "% of the brightest");
  light.hold("full Moon on the horizon: light", 1.2, "%");
}

TEST_F(DiscSprites, AreInPlaceInAllProjections) {
  const SkyState quarter_moon = sky_at("2026-05-23T20:00:00Z");
  view.azimuth = view.altitude = view.roll = 0.0 * deg;
  for (const Projection projection :
       {Projection::fisheye, Projection::stereographic, Projection::equirectangular, Projection::cubemap}) {
    view.projection = projection;
    view.fov = 60.0 * deg;
    view.width = projection == Projection::equirectangular ? 2400 : 600;
    view.height = projection == Projection::equirectangular ? 1200 : projection == Projection::cubemap ? 3600 : 600;
    const Vec2 at(0.87 * view.width + 0.3, 0.2 * 600);
    const SkyState sky = with_moon_at(quarter_moon, direction_at(view, at));
    ErrorSum pixels;
    ErrorSum light;
    compare(both(sky, plan_frame(sky, view, {}, options)), 1, pixels, light);
    const std::string what(projection_names()[static_cast<std::size_t>(projection)]);
    pixels.hold("half Moon, " + what + ": pixels against drawn ones", 7.0, "% of the brightest");
    light.hold("half Moon, " + what + ": light", 0.5, "%");
  }
}

TEST_F(DiscSprites, OfTheSunAreDrawnOnesToo) {
  // Without and with the Moon before it.
  for (const char* stamp : {"2026-08-12T12:00:00Z", "2026-08-12T18:00:00Z"}) {
    const SkyState sky = sky_state(parse_instant(stamp), {42.35 * deg, -3.7 * deg, 900.0 * metre});
    FramePlan plan;
    plan.options = options;
    for (const double wide : {4.0, 15.0}) {
      aim(sky.sun.direction_horizon, wide);
      DiscScene scene{sky, view, plan.refraction, [](double, const Vec4&) { return Vec4(1.0); }, {}, {}, true};
      plan.sun = plan_sun(scene, {});
      ErrorSum pixels;
      ErrorSum light;
      compare(both(sky, plan), 1, pixels, light);
      pixels.hold(std::string("Sun at ") + stamp + ": pixels against drawn ones", 7.0, "% of the brightest");
      light.hold(std::string("Sun at ") + stamp + ": light", 0.5, "%");
    }
  }
}

TEST_F(DiscSprites, HideStarsOnTheDarkSideToo) {
  const SkyState sky = with_moon_at(sky_at("2026-05-23T20:00:00Z"), at_altitude(40.0));
  aim(sky.moon.place.direction_horizon, 12.0);
  SkyState resting = sky;
  resting.stars = StarFrame();
  resting.stars.horizon_from_icrs = Mat3(1.0);
  // One behind the Moon, a fainter one beside it.
  constexpr double beside_lux = 1.0e-5;
  const std::vector<StarRecord> stars{white_star(sky.moon.place.direction_horizon, 1.0e-4),
                                      white_star(direction_at(view, {50.3, 31.8}), beside_lux)};
  renderer.load(catalogue_of(stars));
  const gpu::Frame moon = renderer.render(resting, view, plan_frame(resting, view, {}, options));
  options.layers.set(static_cast<std::size_t>(Layer::stars));
  const gpu::Frame with_star = renderer.render(resting, view, plan_frame(resting, view, stars, options));
  int hidden = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      if (glm::length(Vec2(x - 31.5, y - 31.5)) < 4.0) {
        ASSERT_EQ(with_star.pixel(x, y)[1], moon.pixel(x, y)[1]) << x << " " << y;
        ++hidden;
      }
    }
  }
  EXPECT_GT(hidden, 40);
  const double added = illuminance_in(with_star, view, 0, 0, 64, 64) - illuminance_in(moon, view, 0, 0, 64, 64);
  EXPECT_GT(added, 0.2 * beside_lux); // through the air
  EXPECT_LT(added, 1.01 * beside_lux);
}

} // namespace
} // namespace vesper::test
