// The dark sky as drawn against its sources on the CPU: every projection and height, the layers, the ground before it.
#include "render/render_fixture.hpp"

#include "vesper/assets/cube_texels.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/zodiacal_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vesper::test {
namespace {

LayerSet layers_of(std::initializer_list<Layer> wanted) {
  LayerSet layers;
  for (const Layer layer : wanted) {
    layers.set(static_cast<std::size_t>(layer));
  }
  return layers;
}

class DarkSkyPassTest : public RenderTest {
protected:
  static void SetUpTestSuite() {
    tables = std::make_shared<const SkyTables>(make_sky_tables(published_medium(), {12, 8, 16, 40}));
  }
  static void TearDownTestSuite() { tables.reset(); }

  DarkSkyPassTest() {
    options.air = AirOptions();
    options.air.medium = std::make_shared<const Medium>(published_medium());
    options.air.refraction = false;
    view.projection = Projection::equirectangular;
    view.altitude = 0.0 * deg;
    view.width = 96;
    view.height = 48;
  }

  /// A spring evening: zodiacal light in the west.
  static SkyState evening(Length height = 0.0 * metre) {
    return sky_state(parse_instant("2026-03-18T21:00:00Z"), {28.3 * deg, -16.5 * deg, height});
  }

  gpu::Frame render(const SkyState& sky) { return renderer.render(sky, view, plan_frame(sky, view, {}, options)); }

  /// Calls `check` with the pixel and the direction of each centre that lies clear of the horizon.
  template <class Check> void for_pixels(const FramePlan& plan, const Check& check) {
    for (int row = 0; row < view.height; ++row) {
      for (int column = 0; column < view.width; ++column) {
        const Vec2 pixel(column + 0.5, row + 0.5);
        const double per_sr = f64::pixels_per_steradian(pixel, pixel_frame(view));
        if (per_sr <= 0.0) {
          continue; // outside a fisheye's circle
        }
        const Vec3 direction = direction_at(view, pixel);
        if (std::abs(plan.horizon_sin_altitude - direction.z) > 0.55 / std::sqrt(per_sr)) {
          check(column, row, direction);
        }
      }
    }
  }

  static std::shared_ptr<const SkyTables> tables; // NOLINT
  FrameOptions options;
  View view;
};
std::shared_ptr<const SkyTables> DarkSkyPassTest::tables; // NOLINT

/// Share of a light's X, Y, Z and S that the straight way through the air leaves.
Vec4 exact_share(const Medium& medium, Length height, const Vec3& direction, const Spectrum& light) {
  const Vec3 eye(0.0, 0.0, (medium.ground_radius + height).to(kilometre));
  const AirColumns columns = columns_to_space(medium, eye, glm::normalize(direction));
  return LightThroughAir(medium, light).share(columns.km);
}

std::shared_ptr<const CubePyramid> even_milky_way(const Vec4& light) {
  std::vector<float> texels;
  for (std::size_t i = 0; i < 4 * cube_texel_count(16); ++i) {
    texels.push_back(static_cast<float>(light[static_cast<int>(i % 4)]));
  }
  return std::make_shared<const CubePyramid>(16, std::move(texels));
}

TEST_F(DarkSkyPassTest, WhatShinesFromBeyondComesThroughTheAir) {
  options.layers = layers_of({Layer::zodiacal, Layer::milky_way, Layer::ground});
  options.air.medium = std::make_shared<const Medium>(clear_medium());
  const Vec4 starlight = 80.0 * xyzs_of_s10(faint_starlight_spectrum());
  options.dark_sky.milky_way = even_milky_way(starlight);
  for (const Projection projection : {Projection::perspective, Projection::fisheye, Projection::stereographic,
                                      Projection::equirectangular, Projection::cubemap}) {
    view.projection = projection;
    view.azimuth = 260.0 * deg;
    view.altitude = 20.0 * deg;
    view.fov = projection == Projection::perspective ? 80.0 * deg : 200.0 * deg;
    view.width = 24;
    view.height = projection == Projection::cubemap ? 144 : 24;
    const SkyState sky = evening();
    const FramePlan plan = plan_frame(sky, view, {}, options);
    const gpu::Frame frame = renderer.render(sky, view, plan);
    const DarkSky dark = dark_sky(sky);
    double worst = 0.0;
    int pixels = 0;
    for_pixels(plan, [&](int column, int row, const Vec3& direction) {
      if (direction.z < plan.horizon_sin_altitude) {
        EXPECT_EQ(frame.pixel(column, row)[1], 0.0F);
        return;
      }
      const Vec4 wanted =
          exact_share(*options.air.medium, 0.0 * metre, direction, zodiacal_spectrum(0.5)) *
              zodiacal_light(dark, direction) +
          exact_share(*options.air.medium, 0.0 * metre, direction, faint_starlight_spectrum()) * starlight;
      for (int channel = 0; channel < 4; ++channel) {
        worst =
            std::max(worst, std::abs(static_cast<double>(frame.pixel(column, row)[channel]) / wanted[channel] - 1.0));
      }
      ++pixels;
    });
    std::printf("beyond, %s: worst %.4f of %d pixels\n",
                std::string(projection_names()[static_cast<std::size_t>(projection)]).c_str(), worst, pixels);
    EXPECT_GT(pixels, 100);
    EXPECT_LT(worst, 0.02);
  }
}

TEST_F(DarkSkyPassTest, AirglowIsAlongTheViewAtEveryHeight) {
  options.layers = layers_of({Layer::airglow, Layer::ground});
  const DarkSky dark = dark_sky(evening());
  for (const double height_km : {0.0, 2.4, 11.0, 60.0, 86.0, 200.0, 400.0}) {
    const SkyState sky = evening(height_km * kilometre);
    const FramePlan plan = plan_frame(sky, view, {}, options);
    const gpu::Frame frame = renderer.render(sky, view, plan);
    double worst = 0.0;
    int lit = 0;
    for_pixels(plan, [&](int column, int row, const Vec3& direction) {
      const Vec2 paths = f64::airglow_paths(direction.z, height_km, 6360.0);
      Vec4 wanted = paths.x * dark.airglow;
      if (paths.y > 0.0) {
        wanted += paths.y * exact_share(*options.air.medium, height_km * kilometre, direction, airglow_spectrum()) *
                  dark.airglow;
      }
      for (int channel = 0; channel < 4; ++channel) {
        const auto found = static_cast<double>(frame.pixel(column, row)[channel]);
        ASSERT_TRUE(std::isfinite(found));
        // Of the shell seen square on: its limb, a fraction of a pixel thin, is steeper than the map's rows.
        worst = std::max(worst, std::abs(found - wanted[channel]) / std::max(wanted[channel], dark.airglow[channel]));
      }
      lit += wanted.y > 0.0 ? 1 : 0;
    });
    std::printf("airglow, %5.1f km: worst %.4f, %d pixels lit\n", height_km, worst, lit);
    EXPECT_GT(lit, 100);
    EXPECT_LT(worst, height_km > 20.0 ? 0.1 : 0.02);
  }
}

TEST_F(DarkSkyPassTest, ScatteredLightIsThatOfItsSources) {
  options.layers = layers_of({Layer::airglow, Layer::ground});
  options.air.sky_tables = tables;
  const SkyState sky = evening();
  const FramePlan plan = plan_frame(sky, view, {}, options);
  const gpu::Frame frame = renderer.render(sky, view, plan);
  const DarkSky dark = dark_sky(sky);
  const Mat4 matrix = response_matrix(solar_irradiance_1au(), airglow_spectrum());
  for (const int row : {4, 12, 18, 22, 26, 40}) {
    const Vec3 direction = direction_at(view, {30.5, row + 0.5});
    const SpreadLightViews exactly(tables, 0.0 * metre, {std::asin(direction.z) * rad});
    const SpreadLight light =
        spread_light(exactly.lowest(), [&](const Vec3& at) { return airglow_above(dark, at.z).y; });
    const DarkSkyAir air(*options.air.medium, 0.0 * metre, std::nullopt);
    const Vec4 wanted = air.airglow(dark, direction.z) + matrix * exactly.luminance(0, Angle(), light);
    for (int channel = 0; channel < 4; ++channel) {
      EXPECT_NEAR(static_cast<double>(frame.pixel(30, row)[channel]) / wanted[channel], 1.0, 0.02) << row;
    }
  }
}

TEST_F(DarkSkyPassTest, LayersAddUpAndTheGroundIsDarkerThanTheSky) {
  options.air.sky_tables = tables;
  options.dark_sky.glow = {0.001 * candela_per_m2, 90.0 * deg, 30.0 * kilometre};
  const SkyState sky = evening();
  const auto drawn = [&](std::initializer_list<Layer> layers) {
    options.layers = layers_of(layers);
    return render(sky);
  };
  const gpu::Frame all = drawn({Layer::airglow, Layer::zodiacal, Layer::milky_way, Layer::sky_glow, Layer::ground});
  const gpu::Frame airglow = drawn({Layer::airglow, Layer::ground});
  const gpu::Frame zodiacal = drawn({Layer::zodiacal, Layer::ground});
  const gpu::Frame stars = drawn({Layer::milky_way, Layer::ground});
  const gpu::Frame glow = drawn({Layer::sky_glow, Layer::ground});
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const float sum = airglow.pixel(column, row)[1] + zodiacal.pixel(column, row)[1] + stars.pixel(column, row)[1] +
                        glow.pixel(column, row)[1];
      EXPECT_NEAR(all.pixel(column, row)[1] / sum, 1.0F, 1.0e-4F) << column << " " << row;
    }
  }
  EXPECT_LT(all.pixel(10, 40)[1], 0.4F * all.pixel(10, 8)[1]);
  EXPECT_EQ(glow.pixel(10, 40)[1], 0.0F);
  // The view looks south: east is a quarter of the picture left of its middle.
  EXPECT_GT(glow.pixel(24, 20)[1], 5.0F * glow.pixel(72, 20)[1]);
  EXPECT_NEAR(glow.pixel(24, 0)[1], 0.001F, 1.0e-4F);
}

TEST_F(DarkSkyPassTest, WhatIsInTheAirIsTheSameDrawnWithTheSky) {
  options.air.sky_tables = tables;
  options.dark_sky.glow = {0.0003 * candela_per_m2, 90.0 * deg, 30.0 * kilometre};
  // A setting crescent, whose light in the air is of the dark sky's order.
  for (const double height_km : {0.0, 11.0, 70.0, 200.0}) {
    const SkyState sky =
        sky_state(parse_instant("2026-08-16T21:15:00Z"), {28.3 * deg, -16.5 * deg, height_km * kilometre});
    const auto drawn = [&](std::initializer_list<Layer> layers, bool together) {
      options.layers = layers_of(layers);
      const FramePlan plan = plan_frame(sky, view, {}, options);
      if (plan.dark_sky != nullptr) {
        EXPECT_EQ(plan.dark_sky->air_with_sky, together) << height_km << " km";
      }
      return renderer.render(sky, view, plan);
    };
    const gpu::Frame all = drawn({Layer::sky, Layer::airglow, Layer::sky_glow, Layer::ground}, height_km < 90.0);
    const gpu::Frame moonlit = drawn({Layer::sky, Layer::ground}, false);
    const gpu::Frame dark = drawn({Layer::airglow, Layer::sky_glow, Layer::ground}, false);
    double worst = 0.0;
    double share = 0.0;
    for (std::size_t i = 0; i < all.xyzs.size(); ++i) {
      const double wanted = static_cast<double>(moonlit.xyzs[i]) + static_cast<double>(dark.xyzs[i]);
      worst = std::max(worst, std::abs(static_cast<double>(all.xyzs[i]) - wanted) / std::max(wanted, 1.0e-9));
      share += wanted > 0.0 ? static_cast<double>(dark.xyzs[i]) / wanted / static_cast<double>(all.xyzs.size()) : 0.0;
    }
    std::printf("in one draw, %5.1f km: worst %.5f, dark sky %.2f of the light\n", height_km, worst, share);
    EXPECT_GT(share, 0.1);
    EXPECT_LT(worst, 1.0e-5);
  }
}

TEST_F(DarkSkyPassTest, NothingIsDrawnWithoutItsLayers) {
  options.layers = layers_of({Layer::stars, Layer::planets, Layer::ground});
  const FramePlan plan = plan_frame(evening(), view, {}, options);
  EXPECT_EQ(plan.dark_sky, nullptr);
}

TEST_F(DarkSkyPassTest, APlaceServesAgain) {
  options.layers = layers_of({Layer::airglow});
  const FramePlan first = plan_frame(evening(), view, {}, options);
  const FramePlan second = plan_frame(evening(), view, {}, options, &first);
  EXPECT_EQ(first.dark_sky->place, second.dark_sky->place);
  const FramePlan higher = plan_frame(evening(100.0 * metre), view, {}, options, &first);
  EXPECT_NE(first.dark_sky->place, higher.dark_sky->place);
}

} // namespace
} // namespace vesper::test
