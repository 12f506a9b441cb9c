// Frames of stars where methods fail: poles, zenith, horizon, exact opposition, extreme records and fields.
#include "render/render_fixture.hpp"

#include <limits>

namespace vesper::test {
namespace {

using StarFrameStability = RenderTest;

std::vector<View> every_view() {
  std::vector<View> views;
  for (const auto& [projection, fov] :
       {std::pair{Projection::perspective, 1.0e-3}, std::pair{Projection::perspective, 169.99},
        std::pair{Projection::fisheye, 1.0e-3}, std::pair{Projection::fisheye, 180.0},
        std::pair{Projection::fisheye, 360.0}, std::pair{Projection::stereographic, 349.9},
        std::pair{Projection::equirectangular, 180.0}, std::pair{Projection::cubemap, 180.0}}) {
    for (const double altitude : {90.0, 0.0, -90.0}) {
      View view;
      view.projection = projection;
      view.fov = fov * deg;
      view.altitude = altitude * deg;
      view.width = 48;
      view.height = projection == Projection::cubemap ? 288 : 48;
      views.push_back(view);
    }
  }
  return views;
}

/// Every value finite and none negative.
void expect_sound(const gpu::Frame& frame, const View& view) {
  for (const float value : frame.xyzs) {
    ASSERT_TRUE(std::isfinite(value) && value >= 0.0F)
        << projection_names()[static_cast<std::size_t>(view.projection)] << " fov " << view.fov.to(deg) << " altitude "
        << view.altitude.to(deg);
  }
}

TEST_F(StarFrameStability, SpecialDirectionsInEveryProjection) {
  // Axes hit the zenith, the nadir, the view direction, its opposite, the poles of maps and the cube's corners.
  std::vector<StarRecord> stars;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        if (x != 0.0 || y != 0.0 || z != 0.0) {
          stars.push_back(white_star(glm::normalize(Vec3(x, y, z)), 2.54e-7));
        }
      }
    }
  }
  renderer.load(catalogue_of(stars));
  SkyState sky = still_sky();
  for (const Tier tier : {Tier::standard, Tier::cheap}) {
    sky.tier = tier;
    for (const View& view : every_view()) {
      FrameOptions options;
      options.layers = all_layers();
      expect_sound(renderer.render(sky, view, plan_frame(sky, view, stars, options)), view);
      options.layers = bare_stars().layers;
      expect_sound(renderer.render(sky, view, plan_frame(sky, view, stars, options)), view);
    }
  }
}

TEST_F(StarFrameStability, ExtremeRecords) {
  std::vector<StarRecord> stars(6, white_star(Vec3(0.0, 0.0, 1.0), 2.54e-6));
  stars[0].illuminance = 130000.0F; // the Sun as a star
  stars[1].parallax = 0.5F;         // half a radian: two astronomical units away
  stars[2].radial_velocity = -3.0e4F;
  stars[3].proper_motion = {1.0e-2F, 0.0F, 0.0F};
  stars[4].illuminance = std::numeric_limits<float>::min();
  stars[5].color = {0.0F, 0.0F, 0.0F, 0.0F};
  renderer.load(catalogue_of(stars));
  const Observer pole{90.0 * deg, 180.0 * deg, 0.0 * metre};
  for (const char* time : {"1000-01-01T00:00:00Z", "2026-11-22T22:00:00Z", "3000-12-31T23:59:59Z"}) {
    for (const Tier tier : {Tier::standard, Tier::cheap}) {
      const SkyState sky = sky_state(parse_instant(time), pole, tier);
      const View view;
      expect_sound(renderer.render(sky, view, plan_frame(sky, view, stars)), view);
    }
  }
}

TEST_F(StarFrameStability, ExtremeAir) {
  const std::vector<StarRecord> stars{white_star(glm::normalize(Vec3(1.0, 0.0, 1.0e-7)), 2.54e-6),
                                      white_star(Vec3(0.0, 0.0, 1.0), 2.54e-6)};
  renderer.load(catalogue_of(stars));
  const View view;
  for (const double height : {-400.0, 0.0, 9000.0, 100000.0}) {
    SkyState sky = still_sky();
    sky.observer.height = height * metre;
    sky.refraction = {RefractionModel::traced, standard_conditions(sky.observer.height), nullptr};
    for (const double exposure : {0.0, 1.0e-6, 0.1, 1.0e6}) {
      FrameOptions options;
      options.air.exposure_s = exposure;
      options.air.pupil_m = exposure > 0.05 ? 10.0 : 1.0e-6;
      expect_sound(renderer.render(sky, view, plan_frame(sky, view, stars, options)), view);
    }
  }
}

TEST_F(StarFrameStability, NoStarsAndOnePixel) {
  const SkyState sky = still_sky();
  View view;
  view.width = view.height = 1;
  expect_sound(renderer.render(sky, view, plan_frame(sky, view, {})), view);
  const std::vector<StarRecord> stars{white_star(Vec3(0.0, 0.0, 1.0), 2.54e-6)};
  renderer.load(catalogue_of(stars));
  expect_sound(renderer.render(sky, view, plan_frame(sky, view, stars)), view);
  renderer.load(StarCatalogue{});
  expect_sound(renderer.render(sky, view, plan_frame(sky, view, {})), view);
}

} // namespace
} // namespace vesper::test
