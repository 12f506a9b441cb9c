// Where the GPU puts a star against where the CPU's double precision puts it.
#include "render/render_fixture.hpp"

#include "vesper/astro/star_place.hpp"

#include <cstdio>
#include <numbers>

namespace vesper::test {
namespace {

constexpr double tolerance_px = 0.02;

/// A star of the catalogue's kind: nearby ones move and swing.
StarRecord random_star(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Vec3 position = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
  StarRecord star = white_star(position, 2.54e-8);
  const Vec3 tangent = glm::normalize(glm::cross(position, Vec3(normal(random), normal(random), normal(random))));
  const double motion = std::abs(normal(random)) * (0.5 * arcsec).to(rad);
  star.proper_motion = {static_cast<float>(motion * tangent.x), static_cast<float>(motion * tangent.y),
                        static_cast<float>(motion * tangent.z)};
  star.parallax = static_cast<float>(std::abs(normal(random)) * (0.1 * arcsec).to(rad));
  star.radial_velocity = static_cast<float>(30.0 * normal(random));
  return star;
}

/// The pixel that the double-precision chain gives from the same record.
Vec2 expected_pixel(const StarRecord& star, const SkyState& sky, const View& view) {
  const Vec3 icrs = f64::star_place(Vec3(star.position[0], star.position[1], star.position[2]),
                                    Vec3(star.proper_motion[0], star.proper_motion[1], star.proper_motion[2]),
                                    static_cast<double>(star.parallax), static_cast<double>(star.radial_velocity),
                                    place_frame(sky.stars));
  const Vec3 seen = apparent_direction(glm::normalize(sky.stars.horizon_from_icrs * icrs), sky.refraction);
  const Vec3 direction = view_from_horizon(view) * seen;
  Vec2 pixel;
  EXPECT_TRUE(f64::project(direction, 0, projection_frame(view), pixel));
  return pixel;
}

/// Centre of light (luminance times solid angle) of the only star in a window around a pixel.
Vec2 centroid(const gpu::Frame& frame, const View& view, const Vec2& near) {
  double sum = 0.0;
  Vec2 moment(0.0);
  for (int row = std::max(0, static_cast<int>(near.y) - 5); row < std::min(frame.height, static_cast<int>(near.y) + 6);
       ++row) {
    for (int column = std::max(0, static_cast<int>(near.x) - 5);
         column < std::min(frame.width, static_cast<int>(near.x) + 6); ++column) {
      const double light = static_cast<double>(frame.pixel(column, row)[1]) /
                           f64::pixels_per_steradian({column + 0.5, row + 0.5}, pixel_frame(view));
      sum += light;
      moment += light * Vec2(column + 0.5, row + 0.5);
    }
  }
  EXPECT_GT(sum, 0.0);
  return moment / sum;
}

SkyState real_sky() {
  const Observer observer{48.137 * deg, 11.575 * deg, 520.0 * metre};
  SkyState sky = sky_state(parse_instant("2061-03-05T21:17:42Z"), observer);
  sky.refraction = Refraction{};
  return sky;
}

FrameOptions refracted_stars() {
  FrameOptions options = bare_stars();
  options.air.refraction = true;
  return options;
}

using StarPlaceGpu = RenderTest;

TEST_F(StarPlaceGpu, WholeSkyFisheyeAt4096) {
  const SkyState sky = real_sky();
  View view;
  view.width = view.height = 4096;
  std::mt19937_64 random(3);
  std::vector<StarRecord> stars;
  std::vector<Vec2> pixels;
  while (stars.size() < 400) {
    const StarRecord star = random_star(random);
    const Vec3 icrs(star.position[0], star.position[1], star.position[2]);
    if ((sky.stars.horizon_from_icrs * icrs).z < 0.02) {
      continue;
    }
    const Vec2 pixel = expected_pixel(star, sky, view);
    const bool isolated = std::none_of(pixels.begin(), pixels.end(),
                                       [&](const Vec2& other) { return glm::length(other - pixel) < 14.0; });
    if (isolated) {
      stars.push_back(star);
      pixels.push_back(pixel);
    }
  }
  renderer.load(catalogue_of(stars));
  const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, stars, bare_stars()));
  double worst = 0.0;
  for (std::size_t i = 0; i < stars.size(); ++i) {
    worst = std::max(worst, glm::length(centroid(frame, view, pixels[i]) - pixels[i]));
  }
  std::printf("fisheye 180 deg, 4096 px: worst %.5f px over %zu stars\n", worst, stars.size());
  EXPECT_LT(worst, tolerance_px);
}

TEST_F(StarPlaceGpu, HalfDegreePerspectiveAt1024) {
  const SkyState sky = real_sky();
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> offset(-0.2, 0.2);
  double worst = 0.0;
  constexpr int frames = 60;
  for (int i = 0; i < frames; ++i) {
    const std::vector<StarRecord> stars{random_star(random)};
    const Vec3 icrs(stars[0].position[0], stars[0].position[1], stars[0].position[2]);
    const Vec3 horizon = sky.stars.horizon_from_icrs * icrs;
    View view;
    view.projection = Projection::perspective;
    view.fov = 0.5 * deg;
    view.altitude = std::asin(horizon.z) * rad + offset(random) * deg;
    view.azimuth = std::atan2(horizon.x, horizon.y) * rad + offset(random) * deg;
    const Vec2 pixel = expected_pixel(stars[0], sky, view);
    renderer.load(catalogue_of(stars));
    const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, stars, bare_stars()));
    worst = std::max(worst, glm::length(centroid(frame, view, pixel) - pixel));
  }
  std::printf("perspective 0.5 deg, 1024 px: worst %.5f px over %d frames\n", worst, frames);
  EXPECT_LT(worst, tolerance_px);
}

TEST_F(StarPlaceGpu, RefractedTowardsTheHorizon) {
  // Each star alone, in a view half a degree wide: a pixel is 1.8 arcsec. Its light is all there.
  SkyState sky = still_sky();
  sky.observer.height = 2400.0 * metre;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> azimuth(0.0, 2.0 * std::numbers::pi);
  for (const RefractionModel model : {RefractionModel::traced, RefractionModel::published}) {
    sky.refraction = with_table({model, standard_conditions(sky.observer.height), nullptr});
    double worst_px = 0.0;
    double worst_light = 0.0;
    double most_raised_px = 0.0;
    for (const double altitude_deg : {-2.0, -1.0, -0.5, 0.0, 0.01, 0.5, 2.0, 10.0, 45.0, 89.99, 90.0}) {
      const double altitude = (altitude_deg * deg).to(rad);
      const double a = azimuth(random);
      const Vec3 direction(std::cos(altitude) * std::sin(a), std::cos(altitude) * std::cos(a), std::sin(altitude));
      const std::vector<StarRecord> stars{white_star(direction, 2.54e-8)};
      const auto& stored = stars[0].position;
      const Vec3 seen = apparent_direction(glm::normalize(Vec3(stored[0], stored[1], stored[2])), sky.refraction);
      View view;
      view.projection = Projection::perspective;
      view.fov = 0.5 * deg;
      view.width = view.height = 1000;
      view.altitude = std::atan2(seen.z, std::hypot(seen.x, seen.y)) * rad;
      view.azimuth = std::atan2(seen.x, seen.y) * rad;
      const Vec2 pixel = expected_pixel(stars[0], sky, view);
      renderer.load(catalogue_of(stars));
      const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, stars, refracted_stars()));
      worst_px = std::max(worst_px, glm::length(centroid(frame, view, pixel) - pixel));
      const double light = illuminance_in(frame, view, 0, 0, view.width, view.height);
      worst_light = std::max(worst_light, std::abs(light / static_cast<double>(stars[0].illuminance) - 1.0));
      most_raised_px = std::max(most_raised_px, glm::length(seen - direction) * projection_frame(view).focal);
    }
    std::printf("%s refraction: worst %.5f px of up to %.0f px, light within %.1e\n",
                model == RefractionModel::traced ? "traced" : "published", worst_px, most_raised_px, worst_light);
    EXPECT_LT(worst_px, tolerance_px);
    EXPECT_LT(worst_light, 1.0e-4);
    EXPECT_GT(most_raised_px, 1000.0); // at least half a degree
  }
}

TEST_F(StarPlaceGpu, StarsSetWhereTheHorizonIsDrawn) {
  for (const double height_m : {0.0, 47.0, 9000.0}) {
    SkyState sky = still_sky();
    sky.observer.height = height_m * metre;
    sky.refraction = with_table({RefractionModel::traced, standard_conditions(sky.observer.height), nullptr});
    const Angle setting = true_altitude(sky.refraction.table->horizon, *sky.refraction.table);
    View view;
    view.projection = Projection::perspective;
    view.fov = 2.0 * deg;
    view.width = view.height = 1000;
    view.azimuth = 0.0 * deg;
    view.altitude = sky.refraction.table->horizon;
    FrameOptions options = refracted_stars();
    options.layers.set(static_cast<std::size_t>(Layer::ground));
    // A star's spread is some 5 pixels of 7 arcsec; the sky is squeezed there.
    for (const double above_arcmin : {-4.0, 4.0}) {
      const double altitude = (setting + above_arcmin * arcmin).to(rad);
      const std::vector<StarRecord> stars{white_star({0.0, std::cos(altitude), std::sin(altitude)}, 2.54e-8)};
      renderer.load(catalogue_of(stars));
      const gpu::Frame frame = renderer.render(sky, view, plan_frame(sky, view, stars, options));
      const double light = illuminance_in(frame, view, 0, 0, view.width, view.height);
      EXPECT_NEAR(light / 2.54e-8, above_arcmin > 0.0 ? 1.0 : 0.0, 1.0e-3) << height_m << " m";
    }
  }
}

} // namespace
} // namespace vesper::test
