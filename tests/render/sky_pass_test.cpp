// The sky as drawn against the tables looked up on the CPU: every projection and height, the horizon, two lights, the
// change from one set of tables to another.
#include "render/render_fixture.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/atmosphere/small_sky_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>

namespace vesper::test {
namespace {

Vec3 place(double azimuth_deg, double altitude_deg) {
  const double azimuth = (azimuth_deg * deg).to(rad);
  const double altitude = (altitude_deg * deg).to(rad);
  return {std::cos(altitude) * std::sin(azimuth), std::cos(altitude) * std::cos(azimuth), std::sin(altitude)};
}

/// Sun and full Moon where they are put, for an observer anywhere.
SkyState sky_with(const Vec3& sun, const Vec3& moon, Length height) {
  SkyState sky = still_sky();
  sky.observer.height = height;
  sky.sun.direction_horizon = sun;
  sky.sun.distance = 1.0 * astronomical_unit;
  sky.sun.direction_equatorial = sun;
  sky.moon.place.direction_horizon = moon;
  sky.moon.place.direction_equatorial = -sun;
  sky.moon.place.distance = 384400.0 * kilometre;
  sky.lunar_eclipse.axis = -sun;
  sky.lunar_eclipse.moon_km = -384400.0 * sun;
  sky.lunar_eclipse.sun_distance = 1.0 * astronomical_unit;
  return sky;
}

constexpr SkyTableSize size{20, 16, 28, 40};

class SkyPassTest : public RenderTest {
protected:
  static void SetUpTestSuite() {
    tables = std::make_shared<const SkyTables>(make_sky_tables(published_medium(), size));
  }
  static void TearDownTestSuite() { tables.reset(); }

  SkyPassTest() {
    options.layers.reset().set(static_cast<std::size_t>(Layer::sky)).set(static_cast<std::size_t>(Layer::ground));
    options.air.sky_tables = tables;
    view.projection = Projection::equirectangular;
    view.altitude = 0.0 * deg;
    view.width = 96;
    view.height = 48;
  }

  gpu::Frame render(const SkyState& sky) { return renderer.render(sky, view, plan_frame(sky, view, {}, options)); }

  /// What a pixel should hold by sky_luminance(); the horizon that is seen falls on the tables'.
  [[nodiscard]] Vec4 expected(const SkyState& sky, const FramePlan& plan, const Vec3& direction) const {
    const f32::SkyTableFrame& frame = options.air.sky_tables->frame;
    const auto height_km = static_cast<float>(sky.observer.height.to(kilometre));
    const auto dip = static_cast<double>(f32::sky_dip(height_km, frame));
    const double seen = std::asin(std::clamp(direction.z, -1.0, 1.0));
    const double horizon = std::asin(plan.horizon_sin_altitude);
    const double quarter = 0.5 * std::numbers::pi;
    double altitude = seen < horizon ? -dip - (horizon - seen) * (quarter - dip) / (quarter + horizon)
                                     : -dip + (seen - horizon) * (quarter + dip) / (quarter - horizon);
    if (seen > horizon && height_km > frame.top_km - frame.ground_km) {
      altitude = seen - horizon - dip; // the limb is not stretched
    }
    const double across = std::hypot(direction.x, direction.y);
    const double level = across > 0.0 ? std::cos(altitude) / across : 0.0;
    const Vec3 view_direction = glm::normalize(Vec3(level * direction.x, level * direction.y, std::sin(altitude)));
    // Of an eclipse the tables know nothing.
    const f32::vec4 left = plan.eclipse.sky ? plan.eclipse.sky->ratios(view_direction).all : f32::vec4(1.0F);
    Vec4 sum(0.0);
    for (const PlannedLight& light : plan.lights) {
      const Xyzs seen_light = sky_luminance(
          *options.air.sky_tables, {sky.observer.height, light.direction, light.angular_radius, view_direction});
      sum += light.xyzs_from_sunlight * vector_of(seen_light);
    }
    return Vec4(left) * sum;
  }

  /// Largest and RMS relative difference over a frame, pixels that the horizon or the limb's top crosses left out.
  struct Difference {
    double worst = 0.0;
    double rms = 0.0;
    int pixels = 0;
  };
  Difference compare(const SkyState& sky) {
    const FramePlan plan = plan_frame(sky, view, {}, options);
    const gpu::Frame frame = renderer.render(sky, view, plan);
    Difference difference;
    double squares = 0.0;
    for (int row = 0; row < view.height; ++row) {
      for (int column = 0; column < view.width; ++column) {
        const Vec2 pixel(column + 0.5, row + 0.5);
        if (f64::pixels_per_steradian(pixel, pixel_frame(view)) <= 0.0) {
          continue; // outside a fisheye's circle
        }
        const Vec3 direction = direction_at(view, pixel);
        const double depth = plan.horizon_sin_altitude - direction.z;
        const double pixel_rad = 1.0 / std::sqrt(f64::pixels_per_steradian(pixel, pixel_frame(view)));
        if (std::abs(depth) < 0.55 * pixel_rad) {
          continue;
        }
        const Vec4 wanted = expected(sky, plan, direction);
        for (int channel = 0; channel < 4; ++channel) {
          const auto found = static_cast<double>(frame.pixel(column, row)[channel]);
          EXPECT_TRUE(std::isfinite(found) && found >= 0.0);
          if (wanted[channel] > 1.0e-6) {
            const double off = found / wanted[channel] - 1.0;
            if (std::abs(off) > difference.worst) {
              difference.worst = std::abs(off);
              worst_at = direction;
            }
            squares += off * off;
            ++difference.pixels;
          }
        }
      }
    }
    difference.rms = difference.pixels > 0 ? std::sqrt(squares / difference.pixels) : 0.0;
    return difference;
  }

  static std::shared_ptr<const SkyTables> tables; // NOLINT
  FrameOptions options = bare_stars();
  View view;
  Vec3 worst_at{};
};
std::shared_ptr<const SkyTables> SkyPassTest::tables; // NOLINT

TEST_F(SkyPassTest, EveryHeightShowsWhatTheTablesHold) {
  for (const double sun_deg : {40.0, 3.0, -4.0, -9.0}) {
    for (const double height_km : {0.0, 2.4, 11.0, 60.0, 99.9, 400.0}) {
      const SkyState sky = sky_with(place(250.0, sun_deg), place(120.0, 25.0), height_km * kilometre);
      const Difference difference = compare(sky);
      std::printf("Sun at %5.1f deg, %5.1f km: worst %.4f, rms %.5f over %d values, toward %.3f %.3f %.3f\n", sun_deg,
                  height_km, difference.worst, difference.rms, difference.pixels, worst_at.x, worst_at.y, worst_at.z);
      EXPECT_GT(difference.pixels, 1000);
      // Inside the upper air the limb is a steep edge that the map's rows have to share with the sky above.
      const bool limb = height_km > 20.0 && height_km < 100.0;
      EXPECT_LT(difference.worst, limb ? 0.025 : 0.01) << sun_deg << " deg, " << height_km << " km";
      EXPECT_LT(difference.rms, limb ? 0.003 : 0.001) << sun_deg << " deg, " << height_km << " km";
    }
  }
}

TEST_F(SkyPassTest, EveryProjectionShowsWhatTheTablesHold) {
  const SkyState sky = sky_with(place(250.0, 5.0), place(120.0, 25.0), 2.4 * kilometre);
  for (const Projection projection : {Projection::perspective, Projection::fisheye, Projection::stereographic,
                                      Projection::equirectangular, Projection::cubemap}) {
    view.projection = projection;
    view.azimuth = 230.0 * deg;
    view.altitude = 10.0 * deg;
    view.roll = 20.0 * deg;
    view.fov = projection == Projection::perspective ? 80.0 * deg : 220.0 * deg;
    view.width = view.height = 48;
    if (projection == Projection::cubemap) {
      view.width = 24;
      view.height = 144;
    }
    const Difference difference = compare(sky);
    std::printf("%s: worst %.4f, rms %.5f\n",
                std::string(projection_names()[static_cast<std::size_t>(projection)]).c_str(), difference.worst,
                difference.rms);
    EXPECT_GT(difference.pixels, 1000);
    EXPECT_LT(difference.worst, 0.01);
  }
}

TEST_F(SkyPassTest, SmallTablesAreDrawnToo) {
  options.air.sky_tables = std::make_shared<const SkyTables>(make_small_sky_tables(published_medium()));
  for (const double height_km : {0.0, 11.0, 400.0}) {
    const SkyState sky = sky_with(place(250.0, 3.0), place(120.0, 25.0), height_km * kilometre);
    const Difference difference = compare(sky);
    std::printf("small tables, %5.1f km: worst %.4f, rms %.5f over %d values\n", height_km, difference.worst,
                difference.rms, difference.pixels);
    EXPECT_GT(difference.pixels, 1000);
    // Light that goes on for 8 nodes over the azimuth is smoother than what the march finds.
    EXPECT_LT(difference.worst, 0.02) << height_km << " km";
    EXPECT_LT(difference.rms, 0.002) << height_km << " km";
  }
}

TEST_F(SkyPassTest, AnEclipseDimsTheMapPlaceByPlace) {
  options.air.medium = std::make_shared<const Medium>(published_medium());
  for (const auto& [height_km, apart_deg] :
       {std::pair(0.0, 0.0), std::pair(0.0, 0.3), std::pair(11.0, 0.0), std::pair(400.0, 0.3)}) {
    SkyState sky = sky_with(place(250.0, 30.0), place(250.0, 30.0 + apart_deg), height_km * kilometre);
    sky.moon.place.distance = 362000.0 * kilometre;
    sky.moon.phase_angle = 180.0 * deg;
    ASSERT_NE(plan_frame(sky, view, {}, options).eclipse.sky, nullptr);
    const Difference difference = compare(sky);
    std::printf("Moon %.2f deg from the Sun, %5.1f km: worst %.4f, rms %.5f, toward %.3f %.3f %.3f\n", apart_deg,
                height_km, difference.worst, difference.rms, worst_at.x, worst_at.y, worst_at.z);
    EXPECT_GT(difference.pixels, 1000);
    // In totality light goes over four magnitudes between the nodes of the map.
    EXPECT_LT(difference.worst, apart_deg > 0.0 ? 0.01 : 0.05) << apart_deg << " deg, " << height_km << " km";
    EXPECT_LT(difference.rms, apart_deg > 0.0 ? 0.001 : 0.004) << apart_deg << " deg, " << height_km << " km";
  }
}

TEST_F(SkyPassTest, TwoLightsAddUp) {
  const Vec3 sun = place(250.0, -5.0);
  const Vec3 moon = place(120.0, 25.0);
  const SkyState sky = sky_with(sun, moon, 0.0 * metre);
  FramePlan plan = plan_frame(sky, view, {}, options);
  ASSERT_EQ(plan.lights.size(), 2U);
  const gpu::Frame both = renderer.render(sky, view, plan);
  const std::vector<PlannedLight> lights = plan.lights;
  plan.lights = {lights[0]};
  const gpu::Frame first = renderer.render(sky, view, plan);
  plan.lights = {lights[1]};
  const gpu::Frame second = renderer.render(sky, view, plan);
  double worst = 0.0;
  for (std::size_t i = 0; i < both.xyzs.size(); ++i) {
    const auto sum = static_cast<double>(first.xyzs[i]) + static_cast<double>(second.xyzs[i]);
    worst = std::max(worst, std::abs(static_cast<double>(both.xyzs[i]) / sum - 1.0));
  }
  std::printf("both lights against the sum of each: worst %.5f\n", worst);
  EXPECT_LT(worst, 0.003); // the map keeps logarithms of the sum
}

TEST_F(SkyPassTest, TheSkyDoesNotJumpWhereTheAirEnds) {
  const Vec3 sun = place(250.0, 3.0);
  const gpu::Frame below = render(sky_with(sun, place(120.0, 25.0), 99.99 * kilometre));
  const gpu::Frame above = render(sky_with(sun, place(120.0, 25.0), 100.01 * kilometre));
  float brightest = 0.0F;
  for (const float value : above.xyzs) {
    brightest = std::max(brightest, value);
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < above.xyzs.size(); ++i) {
    worst = std::max(worst, static_cast<double>(std::abs(above.xyzs[i] - below.xyzs[i]) /
                                                std::max(above.xyzs[i], 1.0e-3F * brightest)));
  }
  std::printf("20 m across the top of the air: worst step %.4f\n", worst);
  EXPECT_LT(worst, 0.03);
}

TEST_F(SkyPassTest, TheHorizonIsNoSeam) {
  // Pixels of 0.006 degrees on both of its sides, where the tables' rows crowd and refraction has moved it.
  view.projection = Projection::perspective;
  view.azimuth = 200.0 * deg;
  view.fov = 0.4 * deg;
  view.width = 8;
  view.height = 64;
  options.air.refraction = true;
  for (const double height_km : {0.0, 2.4, 11.0}) {
    SkyState sky = sky_with(place(250.0, 10.0), place(120.0, -60.0), height_km * kilometre);
    sky.refraction = standard_refraction(sky.observer.height, Tier::standard);
    view.altitude = std::asin(plan_frame(sky, view, {}, options).horizon_sin_altitude) * rad;
    const Difference difference = compare(sky);
    std::printf("%4.1f km: at the horizon worst %.4f, rms %.5f\n", height_km, difference.worst, difference.rms);
    EXPECT_GT(difference.pixels, 1000);
    EXPECT_LT(difference.worst, 0.01);
  }
}

TEST_F(SkyPassTest, LayersAreDrawnAsAsked) {
  const SkyState sky = sky_with(place(250.0, 10.0), place(120.0, -60.0), 0.0 * metre);
  const gpu::Frame both = render(sky);
  options.layers.reset(static_cast<std::size_t>(Layer::ground));
  const gpu::Frame air = render(sky);
  options.layers.reset().set(static_cast<std::size_t>(Layer::ground));
  const gpu::Frame ground = render(sky);
  const int nadir = view.height - 1;
  EXPECT_GT(both.pixel(10, nadir)[1], 100.0F);          // lit ground
  EXPECT_LT(air.pixel(10, nadir)[1], 1.0F);             // a metre of air before nothing
  EXPECT_EQ(air.pixel(10, 5)[1], both.pixel(10, 5)[1]); // the same sky
  EXPECT_EQ(ground.pixel(10, nadir)[1], 0.0F);
  options.layers.set(static_cast<std::size_t>(Layer::sky));
  options.air.sky_tables = nullptr;
  EXPECT_EQ(render(sky).pixel(10, 5)[1], 0.0F);
}

TEST_F(SkyPassTest, FramesAreTheSameInStripsAndAgain) {
  const SkyState sky = sky_with(place(250.0, 10.0), place(120.0, 30.0), 0.0 * metre);
  const gpu::Frame whole = render(sky);
  EXPECT_EQ(render(sky).xyzs, whole.xyzs);
  renderer.limit_strip_rows(7);
  EXPECT_EQ(render(sky).xyzs, whole.xyzs);
}

TEST_F(SkyPassTest, OtherTablesComeInWithoutAStep) {
  auto doubled = std::make_shared<SkyTables>(*tables);
  for (auto* texels : {&doubled->other, &doubled->aerosol, &doubled->ground}) {
    for (f32::vec4& texel : *texels) {
      texel += 1.0F; // twice the light
    }
  }
  const SkyState sky = sky_with(place(250.0, 10.0), place(120.0, 30.0), 0.0 * metre);
  renderer.change_sky_over(10);
  const auto zenith = [&] { return static_cast<double>(render(sky).pixel(10, 0)[1]); };
  const double before = zenith();
  options.air.sky_tables = doubled;
  double last = before;
  double largest = 0.0;
  int frames = 0;
  while (last < 1.999 * before && frames < 200) {
    const double now = zenith();
    EXPECT_GE(now, last * (1.0 - 1.0e-6));
    largest = std::max(largest, now / last);
    last = now;
    ++frames;
  }
  std::printf("twice the light came in over %d frames, at most %.4f a frame\n", frames, largest);
  EXPECT_NEAR(last / before, 2.0, 1.0e-3);
  EXPECT_LT(largest, std::exp2(0.1) * 1.001); // an even blend over ten frames
  EXPECT_GT(frames, 10);
  // Without a blend the next frame has them.
  renderer.change_sky_over(0);
  options.air.sky_tables = tables;
  EXPECT_NEAR(zenith() / before, 1.0, 1.0e-6);
}

} // namespace
} // namespace vesper::test
