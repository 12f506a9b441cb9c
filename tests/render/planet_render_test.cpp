// Planets in the picture: at their place, with their light, on their own layer.
#include "render/render_fixture.hpp"

#include "vesper/sky/planet_light.hpp"

#include <cstdio>

namespace vesper::test {
namespace {

constexpr auto jupiter = static_cast<std::size_t>(Planet::jupiter);

class PlanetRender : public RenderTest {
protected:
  PlanetRender() {
    // High in the evening, at opposition.
    sky = sky_state(parse_instant("2026-01-15T22:00:00Z"), {50.0 * deg, 10.0 * deg, 100.0 * metre});
    const BodyPlace& place = sky.planets[jupiter].place;
    view.projection = Projection::perspective;
    view.azimuth = place.azimuth + 1.0 * deg;
    view.altitude = place.altitude - 0.7 * deg;
    view.fov = 10.0 * deg;
    view.width = view.height = 400;
    options.layers.reset();
    options.layers.set(static_cast<std::size_t>(Layer::planets));
  }
  gpu::Frame render() { return renderer.render(sky, view, plan_frame(sky, view, {}, options)); }

  struct Light {
    double lux = 0.0;
    Vec2 centre{};
  };
  [[nodiscard]] Light light_in(const gpu::Frame& frame) const {
    Light sum;
    for (int row = 0; row < view.height; ++row) {
      for (int column = 0; column < view.width; ++column) {
        const double share = static_cast<double>(frame.pixel(column, row)[1]) * pixel_solid_angle(view, column, row);
        sum.lux += share;
        sum.centre += share * Vec2(column + 0.5, row + 0.5);
      }
    }
    EXPECT_GT(sum.lux, 0.0);
    return {sum.lux, sum.centre / sum.lux};
  }
  [[nodiscard]] Vec2 expected_pixel() const {
    Vec2 pixel;
    EXPECT_TRUE(f64::project(view_from_horizon(view) * sky.planets[jupiter].place.direction_horizon, 0,
                             projection_frame(view), pixel));
    return pixel;
  }
  [[nodiscard]] double light_of_jupiter() const {
    return planet_illuminance(Planet::jupiter, sky.planets[jupiter].appearance.magnitude).to(lux);
  }

  SkyState sky;
  View view;
  FrameOptions options = bare_stars();
};

TEST_F(PlanetRender, JupiterStandsAtItsPlaceWithItsLight) {
  const Light found = light_in(render());
  const double off = glm::length(found.centre - expected_pixel());
  std::printf("Jupiter: %.4f pixels off its place, light off by %.2e\n", off, found.lux / light_of_jupiter() - 1.0);
  EXPECT_LT(off, 0.02);
  EXPECT_NEAR(found.lux / light_of_jupiter(), 1.0, 1e-3);
  // About -2.7 at opposition: 2.54e-6 lux times 10^1.07, and a little for its colour.
  EXPECT_NEAR(found.lux, 3.1e-5, 0.2e-5);
}

TEST_F(PlanetRender, AFloatsRoundingOfTheDirectionDoesNotShow) {
  view.fov = 0.02 * deg; // 0.18 arcsec a pixel: a float's 0.03 arcsec would be 0.17 pixels
  view.azimuth = sky.planets[jupiter].place.azimuth;
  view.altitude = sky.planets[jupiter].place.altitude;
  EXPECT_LT(glm::length(light_in(render()).centre - expected_pixel()), 0.02);
}

TEST_F(PlanetRender, TheLayerCanBeSwitchedOff) {
  options.layers.reset();
  options.layers.set(static_cast<std::size_t>(Layer::stars));
  const gpu::Frame without = render();
  for (const float value : without.xyzs) {
    ASSERT_EQ(value, 0.0F);
  }
  options.layers = all_layers();
  const gpu::Frame with = render();
  EXPECT_GT(illuminance_in(with, view, 0, 0, view.width, view.height), 1.0e-5);
}

TEST_F(PlanetRender, FaintOnesAreLeftOutByTheLimit) {
  options.faintest_lux = 2.0 * light_of_jupiter();
  const gpu::Frame frame = render();
  EXPECT_EQ(illuminance_in(frame, view, 0, 0, view.width, view.height), 0.0);
}

TEST_F(PlanetRender, ExtinctionDimsItAsAStar) {
  options.air.extinction = true;
  const FramePlan plan = plan_frame(sky, view, {}, options);
  const gpu::Frame frame = renderer.render(sky, view, plan);
  const double sine = sky.planets[jupiter].place.direction_horizon.z;
  const Xyzs& color = planet_light(Planet::jupiter).color;
  const double expected = star_extinction(plan.extinction->table, sine, vector_of(color)).y;
  EXPECT_LT(expected, 0.9);
  EXPECT_NEAR(illuminance_in(frame, view, 0, 0, view.width, view.height) / light_of_jupiter(), expected,
              2e-3 * expected);
}

TEST_F(PlanetRender, AWideDiscHardlyTwinkles) {
  options.air.scintillation = true;
  options.air.exposure_s = 0.0;
  ASSERT_GT(sky.planets[jupiter].appearance.diameter, 40.0 * arcsec);
  const auto rms = [&] {
    double squares = 0.0;
    constexpr int instants = 60;
    for (int i = 0; i < instants; ++i) {
      sky.seconds += 0.37;
      const gpu::Frame frame = render();
      const double off = illuminance_in(frame, view, 0, 0, view.width, view.height) / light_of_jupiter() - 1.0;
      squares += off * off;
    }
    return std::sqrt(squares / instants);
  };
  const double disc = rms();
  sky.planets[jupiter].appearance.diameter = 0.0 * arcsec;
  const double point = rms();
  std::printf("relative intensity varies by %.4f rms as a disc, %.4f as a point\n", disc, point);
  EXPECT_GT(point, 0.15);
  EXPECT_LT(disc, 0.05 * point);
  EXPECT_GT(disc, 0.0);
}

TEST_F(PlanetRender, SkiesWithoutPlanetsStayDark) {
  sky = still_sky();
  const gpu::Frame frame = render();
  for (const float value : frame.xyzs) {
    ASSERT_EQ(value, 0.0F);
  }
}

} // namespace
} // namespace vesper::test
