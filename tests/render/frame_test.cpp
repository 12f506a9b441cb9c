// Frames as a whole: layers, strips, display mapping, tiers, scintillation as drawn.
#include "render/render_fixture.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/gpu/display_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

namespace vesper::test {
namespace {

using Frames = RenderTest;

SkyState summer_night() {
  return sky_state(parse_instant("2026-08-12T22:00:00Z"), {51.4769 * deg, 0.0 * deg, 47.0 * metre});
}

/// A synthetic sky of many stars all over the sphere, sorted.
StarCatalogue random_catalogue(std::size_t count) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<StarRecord> stars;
  for (std::size_t i = 0; i < count; ++i) {
    stars.push_back(white_star(glm::normalize(Vec3(normal(random), normal(random), normal(random))),
                               2.54e-6 * std::pow(10.0, -0.4 * (8.0 * unit(random) - 1.5))));
  }
  std::sort(stars.begin(), stars.end(), [](const auto& a, const auto& b) { return a.illuminance > b.illuminance; });
  return catalogue_of(std::move(stars));
}

double total_light(const gpu::Frame& frame) {
  double sum = 0.0;
  for (const float value : frame.xyzs) {
    sum += static_cast<double>(value);
  }
  return sum;
}

TEST_F(Frames, StripsMakeNoDifference) {
  const StarCatalogue catalogue = random_catalogue(3000);
  renderer.load(catalogue);
  const SkyState sky = summer_night();
  for (const Projection projection : {Projection::fisheye, Projection::cubemap, Projection::equirectangular}) {
    View view;
    view.projection = projection;
    view.width = 160;
    view.height = projection == Projection::cubemap ? 960 : 160;
    const FramePlan plan = plan_frame(sky, view, catalogue.stars);
    renderer.limit_strip_rows(0);
    const gpu::Frame whole = renderer.render(sky, view, plan);
    renderer.limit_strip_rows(37);
    const gpu::Frame strips = renderer.render(sky, view, plan);
    EXPECT_GT(total_light(whole), 0.0);
    EXPECT_EQ(whole.xyzs, strips.xyzs);
  }
}

TEST_F(Frames, RepeatedFramesAreIdentical) {
  const StarCatalogue catalogue = random_catalogue(9000);
  renderer.load(catalogue);
  const SkyState sky = summer_night();
  const View view;
  const FramePlan plan = plan_frame(sky, view, catalogue.stars);
  EXPECT_EQ(renderer.render(sky, view, plan).xyzs, renderer.render(sky, view, plan).xyzs);
}

TEST_F(Frames, FisheyeIsBlackOutsideItsCircle) {
  const StarCatalogue catalogue = random_catalogue(9000);
  renderer.load(catalogue);
  View view;
  view.width = 300;
  view.height = 200;
  view.fov = 120.0 * deg;
  const SkyState sky = still_sky();
  const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, catalogue.stars, bare_stars()));
  double outside = 0.0;
  double inside = 0.0;
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 300; ++column) {
      const double radius = std::hypot(column + 0.5 - 150.0, row + 0.5 - 100.0);
      (radius > 100.0 ? outside : inside) += static_cast<double>(frame.pixel(column, row)[1]);
    }
  }
  EXPECT_EQ(outside, 0.0);
  EXPECT_GT(inside, 0.0);
}

TEST_F(Frames, TheGroundHidesWhatIsBelowTheHorizonAndNothingElse) {
  const StarCatalogue catalogue = random_catalogue(9000);
  renderer.load(catalogue);
  View view;
  view.projection = Projection::equirectangular;
  view.altitude = 0.0 * deg;
  view.width = 720;
  view.height = 360;
  const SkyState sky = still_sky();
  FrameOptions options = bare_stars();
  const gpu::Frame open = renderer.render(sky, view, plan_frame(sky, view, catalogue.stars, options));
  options.layers.set(static_cast<std::size_t>(Layer::planets)).set(static_cast<std::size_t>(Layer::ground));
  const gpu::Frame grounded = renderer.render(sky, view, plan_frame(sky, view, catalogue.stars, options));
  for (int row = 0; row < 360; ++row) {
    for (int column = 0; column < 720; ++column) {
      const float expected = row < 179 ? open.pixel(column, row)[1] : 0.0F;
      if (row < 179 || row > 180) {
        ASSERT_EQ(grounded.pixel(column, row)[1], expected) << column << " " << row;
      }
    }
  }
}

TEST_F(Frames, MotionCountsFromTheCataloguesEpoch) {
  View view;
  view.projection = Projection::perspective;
  view.fov = 20.0 * deg;
  view.width = view.height = 200;
  StarRecord star = white_star(Vec3(0.0, 0.0, 1.0), 2.54e-7);
  star.proper_motion = {1.0e-3F, 0.0F, 0.0F};
  StarCatalogue catalogue = catalogue_of({star});
  catalogue.provenance.epoch_jyear = 1950.0;
  renderer.load(catalogue);
  const SkyState sky = still_sky(); // at J2000.0
  const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, catalogue.stars, bare_stars()));
  // Fifty years on: atan(0.05) towards the east, which is on the left.
  const int column = static_cast<int>(100.0 - projection_frame(view).focal * 0.05);
  EXPECT_GT(illuminance_in(frame, view, column - 6, 94, 13, 13), 0.99 * 2.54e-7);
}

TEST_F(Frames, TheHorizonDipsForAHighObserver) {
  SkyState sky = still_sky();
  sky.observer.height = 10000.0 * metre;
  const FramePlan plan = plan_frame(sky, View(), {}, FrameOptions());
  // Dip of the geometric horizon from 10 km: 3.2 degrees.
  EXPECT_NEAR(std::asin(plan.horizon_sin_altitude) * 180.0 / std::numbers::pi, -3.208, 0.005);
}

TEST_F(Frames, AFifthMagnitudeStarShowsInTheDefaultPicture) {
  View view;
  view.width = view.height = 512;
  gpu::DisplayChain chain(shaders);
  int faintest = 255;
  for (const Vec2 pixel : {Vec2(256.5, 256.5), Vec2(256.0, 256.0), Vec2(100.3, 300.8), Vec2(30.0, 250.2)}) {
    const std::vector<StarRecord> stars{white_star(direction_at(view, pixel), 2.54e-8)};
    renderer.load(catalogue_of(stars));
    const SkyState sky = still_sky();
    const gpu::Frame frame =
        renderer.render(sky, view, plan_frame(sky, view, stars, bare_stars()), {.xyzs = false, .mapping = &chain});
    int brightest = 0;
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4) {
      brightest = std::max<int>(brightest, frame.rgba[i + 1]);
    }
    faintest = std::min(faintest, brightest);
  }
  std::printf("V = 5 in 512 x 512: brightest pixel at least %d of 255\n", faintest);
  EXPECT_GE(faintest, 10);
}

TEST_F(Frames, AMappedPictureDoesNotDependOnItsStrips) {
  const StarCatalogue catalogue = random_catalogue(3000);
  renderer.load(catalogue);
  View view;
  view.width = view.height = 160;
  gpu::DisplayChain chain(shaders);
  const SkyState sky = summer_night();
  const FramePlan plan = plan_frame(sky, view, catalogue.stars);
  renderer.limit_strip_rows(0);
  const gpu::Frame whole = renderer.render(sky, view, plan, {.xyzs = true, .mapping = &chain});
  renderer.limit_strip_rows(37);
  const gpu::Frame strips = renderer.render(sky, view, plan, {.xyzs = true, .mapping = &chain});
  EXPECT_EQ(whole.xyzs, strips.xyzs);
  EXPECT_EQ(whole.rgba, strips.rgba);
}

TEST_F(Frames, ExtinctionDimsAsTheSpectrumThroughTheMediumTells) {
  View view;
  view.projection = Projection::perspective;
  view.fov = 10.0 * deg;
  view.width = view.height = 64;
  const SkyState sky = still_sky();
  FrameOptions options = bare_stars();
  for (const double altitude : {90.0, 30.0, 10.0, 1.0}) {
    view.altitude = altitude * deg;
    for (const double b_v : {-0.2, 0.6, 1.8}) {
      const Vec3 direction = direction_at(view, {32.2, 31.7});
      const std::vector<StarRecord> stars{star_of_color(b_v, direction, 2.54e-7)};
      renderer.load(catalogue_of(stars));
      options.air.extinction = false;
      const gpu::Frame clear = renderer.render(sky, view, plan_frame(sky, view, stars, options));
      options.air.extinction = true;
      const gpu::Frame dimmed = renderer.render(sky, view, plan_frame(sky, view, stars, options));
      const Vec4 expected = share_through(clear_medium(), 0.0 * metre, direction, b_v);
      for (int channel = 0; channel < 4; ++channel) {
        const double ratio =
            illuminance_in(dimmed, view, 0, 0, 64, 64, channel) / illuminance_in(clear, view, 0, 0, 64, 64, channel);
        EXPECT_NEAR(ratio, expected[channel], 2.0e-3 * ratio) << altitude << " " << b_v << " " << channel;
      }
    }
  }
}

TEST_F(Frames, TheCheapTierDimsByTheStatedOpticalDepth) {
  View view;
  view.projection = Projection::perspective;
  view.fov = 10.0 * deg;
  view.width = view.height = 64;
  view.altitude = 10.0 * deg;
  SkyState sky = still_sky();
  sky.tier = Tier::cheap;
  sky.sun.altitude = -30.0 * deg;
  // Too faint for glare, with and without air.
  const std::vector<StarRecord> stars{white_star(direction_at(view, {32.2, 31.7}), 2.54e-9)};
  renderer.load(catalogue_of(stars));
  FrameOptions options = bare_stars();
  const gpu::Frame clear = renderer.render(sky, view, plan_frame(sky, view, stars, options));
  options.air.extinction = true;
  const FramePlan plan = plan_frame(sky, view, stars, options);
  const gpu::Frame dimmed = renderer.render(sky, view, plan);
  for (int channel = 0; channel < 4; ++channel) {
    const double ratio =
        illuminance_in(dimmed, view, 0, 0, 64, 64, channel) / illuminance_in(clear, view, 0, 0, 64, 64, channel);
    const double path = f64::optical_path(static_cast<double>(stars[0].position[2]), 0.0);
    // X holds a blue lobe of its own, which is dimmed as Z is.
    const glm::dvec4 color(stars[0].color[0], stars[0].color[1], stars[0].color[2], stars[0].color[3]);
    const double blue_of_x = 0.1955 * color.z / color.x;
    const auto left = [&](int at) { return std::exp(-plan.optical_depth[at] * path); };
    const double expected = channel == 0 ? (1.0 - blue_of_x) * left(0) + blue_of_x * left(2) : left(channel);
    EXPECT_NEAR(ratio, expected, 2.0e-3 * ratio) << channel;
  }
}

TEST_F(Frames, ThickAirDimsTheStarsAsItsMediumTells) {
  View view;
  view.projection = Projection::perspective;
  view.fov = 10.0 * deg;
  view.width = view.height = 64;
  SkyState sky = still_sky();
  sky.observer.height = 2400.0 * metre;
  const Vec3 zenith(0.0, 0.0, 1.0);
  const std::vector<StarRecord> stars{star_of_color(0.3, zenith, 2.54e-7)};
  renderer.load(catalogue_of(stars));
  FrameOptions options = bare_stars();
  const auto light = [&] {
    const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, stars, options));
    return illuminance_in(frame, view, 0, 0, 64, 64);
  };
  const double above_the_air = light();
  options.air.extinction = true;
  const double clear = light();
  ClearAir haze;
  haze.aerosol_optical_depth = 3.0;
  const Medium thick = clear_medium(haze);
  options.air.medium = std::make_shared<const Medium>(thick);
  const double dimmed = light();
  EXPECT_LT(dimmed, clear);
  const double expected = share_through(thick, sky.observer.height, zenith, 0.3).y;
  std::printf("%.2f magnitudes of haze from 2400 m\n", -2.5 * std::log10(dimmed / clear));
  EXPECT_NEAR(dimmed / above_the_air, expected, 2.0e-3 * expected);
}

TEST_F(Frames, TheTableOfExtinctionIsMadeAgainForAnotherSceneOnly) {
  SkyState sky = still_sky();
  sky.refraction = standard_refraction(0.0 * metre, Tier::standard);
  FrameOptions options;
  options.air.medium = std::make_shared<const Medium>(clear_medium());
  const FramePlan first = plan_frame(sky, View(), {}, options);
  const auto made_again = [&] { return plan_frame(sky, View(), {}, options, &first).extinction != first.extinction; };
  ASSERT_NE(first.extinction, nullptr);
  EXPECT_FALSE(made_again());
  sky.observer.height = 100.0 * metre;
  EXPECT_TRUE(made_again());
  sky.observer.height = 0.0 * metre;
  options.air.medium = std::make_shared<const Medium>(published_medium());
  EXPECT_TRUE(made_again());
  options.air.medium = first.options.air.medium;
  sky.refraction.conditions.temperature_c = -20.0;
  EXPECT_TRUE(made_again());
  options.air.refraction = false;
  EXPECT_TRUE(made_again());
  options.air.extinction = false;
  EXPECT_EQ(plan_frame(sky, View(), {}, options, &first).extinction, nullptr);
}

TEST_F(Frames, ScintillationIsAFunctionOfStarTimeAndSeed) {
  View view;
  view.projection = Projection::perspective;
  view.fov = 10.0 * deg;
  view.altitude = 20.0 * deg;
  view.width = view.height = 64;
  const std::vector<StarRecord> stars{white_star(direction_at(view, {32.2, 31.7}), 2.54e-7)};
  StarCatalogue catalogue = catalogue_of(stars);
  catalogue.identities[0].hr = 2491;
  renderer.load(catalogue);
  FrameOptions options = bare_stars();
  options.air.scintillation = true;
  options.air.exposure_s = 0.0;
  options.seed = 5;
  const auto light_at = [&](double seconds) {
    SkyState sky = still_sky();
    sky.seconds = seconds;
    const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, stars, options));
    return illuminance_in(frame, view, 0, 0, 64, 64) / static_cast<double>(stars[0].illuminance);
  };
  const double seconds = 8.4e8 + 0.123;
  const double first = light_at(seconds);
  const unsigned key = f64::hash_pair(2491U, 5U);
  EXPECT_NEAR(first, f64::scintillation(key, seconds, std::sin((20.0 * deg).to(rad)), 0.0, 0.007).y, 0.01 * first);
  EXPECT_EQ(light_at(seconds), first);
  EXPECT_NEAR(light_at(seconds + 1.0e-5), first, 0.03 * first);
  EXPECT_GT(std::abs(light_at(seconds + 10.0) - first), 1.0e-4);
  options.seed = 6;
  EXPECT_GT(std::abs(light_at(seconds) - first), 1.0e-4);
}

TEST_F(Frames, TheCheapTierConservesItsCoreAndAddsGlareToBrightStarsOnly) {
  View view;
  view.projection = Projection::perspective;
  view.fov = 20.0 * deg;
  view.width = view.height = 256;
  SkyState sky = still_sky();
  sky.tier = Tier::cheap;
  sky.sun.altitude = -30.0 * deg;
  const auto light_of = [&](double magnitude) {
    const std::vector<StarRecord> stars{
        white_star(direction_at(view, {128.3, 127.6}), 2.54e-6 * std::pow(10.0, -0.4 * magnitude))};
    renderer.load(catalogue_of(stars));
    const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, stars, bare_stars()));
    return illuminance_in(frame, view, 0, 0, 256, 256) / static_cast<double>(stars[0].illuminance);
  };
  // Point-sampled T(l) of radius 2 px holds its volume to a few percent; that is what makes it the cheap tier.
  EXPECT_NEAR(light_of(5.0), 1.0, 0.05);
  EXPECT_GT(light_of(0.0), 1.1);
  // By day the stars fade.
  sky.sun.altitude = 40.0 * deg;
  EXPECT_LT(light_of(5.0), 0.02);
}

} // namespace
} // namespace vesper::test
