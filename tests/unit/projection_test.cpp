// Projections and views: conventions, inverses and the size of the sphere.
#include "vesper/base/error.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/plan/view.hpp"

#include "support/view_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vesper {
namespace {

using test::view_of;

Vec3 horizon_direction(double azimuth_deg, double altitude_deg) {
  const double azimuth = (azimuth_deg * deg).to(rad);
  const double altitude = (altitude_deg * deg).to(rad);
  return {std::cos(altitude) * std::sin(azimuth), std::cos(altitude) * std::cos(azimuth), std::sin(altitude)};
}

Vec2 pixel_of(const View& view, const Vec3& horizon, int face = 0) {
  Vec2 pixel;
  EXPECT_TRUE(f64::project(view_from_horizon(view) * horizon, face, projection_frame(view), pixel));
  return pixel;
}

f64::PixelFrame pixel_frame(const View& view) {
  const f64::ProjectionFrame frame = projection_frame(view);
  return {frame.kind, frame.size, frame.focal};
}

void expect_near(const Vec2& pixel, double x, double y) {
  EXPECT_NEAR(pixel.x, x, 1.0e-6);
  EXPECT_NEAR(pixel.y, y, 1.0e-6);
}

TEST(ViewConventions, TheDefaultPutsSouthBelowAndEastOnTheLeft) {
  const View view;
  expect_near(pixel_of(view, horizon_direction(0, 90)), 512, 512);
  expect_near(pixel_of(view, horizon_direction(180, 0)), 512, 1024);
  expect_near(pixel_of(view, horizon_direction(0, 0)), 512, 0);
  expect_near(pixel_of(view, horizon_direction(90, 0)), 0, 512);
  expect_near(pixel_of(view, horizon_direction(270, 0)), 1024, 512);
  // Equidistant: 45 degrees up is half way.
  expect_near(pixel_of(view, horizon_direction(180, 45)), 512, 768);
}

TEST(ViewConventions, UpIsIncreasingAltitudeAndRightIsIncreasingAzimuth) {
  View view = view_of(Projection::perspective, 90, 800, 600);
  view.azimuth = 120.0 * deg;
  view.altitude = 10.0 * deg;
  expect_near(pixel_of(view, horizon_direction(120, 10)), 400, 300);
  expect_near(pixel_of(view, horizon_direction(120, 55)), 400, 0); // 45 degrees above the centre: the upper edge
  EXPECT_GT(pixel_of(view, horizon_direction(130, 10)).x, 400);
}

TEST(ViewConventions, PositiveRollTurnsThePictureClockwise) {
  View view = view_of(Projection::perspective, 90, 600, 600);
  view.altitude = 0.0 * deg;
  view.roll = 90.0 * deg;
  // What stood on top now stands on the right.
  expect_near(pixel_of(view, horizon_direction(180, 30)), 300 + 300 * std::tan(std::numbers::pi / 6), 300);
}

TEST(ViewConventions, EquirectangularCoversTheSphereAroundTheViewDirection) {
  View view = view_of(Projection::equirectangular, 180, 720, 360);
  view.altitude = 0.0 * deg;
  expect_near(pixel_of(view, horizon_direction(180, 0)), 360, 180);
  expect_near(pixel_of(view, horizon_direction(270, 30)), 540, 120);
}

TEST(ViewConventions, CubeFacesStandAsOpenExrStacksThem) {
  View view = view_of(Projection::cubemap, 180, 100, 600);
  view.altitude = 0.0 * deg;
  view.azimuth = 0.0 * deg; // -Z = north, +X = east, +Y = zenith
  const auto face_of = [&](const Vec3& d) { return f64::cube_face_by_rank(view_from_horizon(view) * d, 0); };
  EXPECT_EQ(face_of(horizon_direction(90, 0)), 0);
  EXPECT_EQ(face_of(horizon_direction(270, 0)), 1);
  EXPECT_EQ(face_of(horizon_direction(0, 90)), 2);
  EXPECT_EQ(face_of(horizon_direction(0, -90)), 3);
  EXPECT_EQ(face_of(horizon_direction(180, 0)), 4);
  EXPECT_EQ(face_of(horizon_direction(0, 0)), 5);
  // Rows of OpenEXR's layout: on +X the picture's right is +Z (south), on +Y up is +Z, on -Y up is -Z.
  EXPECT_GT(pixel_of(view, horizon_direction(100, 0), 0).x, 50);
  EXPECT_LT(pixel_of(view, horizon_direction(180, 80), 2).y, 250);
  EXPECT_LT(pixel_of(view, horizon_direction(0, -80), 3).y, 350);
}

class EveryProjection : public testing::TestWithParam<View> {};

TEST_P(EveryProjection, UnprojectInvertsProject) {
  const View& view = GetParam();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int tested = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 pixel(unit(random) * view.width, unit(random) * view.height);
    Vec3 direction;
    if (!f64::unproject(pixel, pixel_frame(view), direction)) {
      continue;
    }
    EXPECT_NEAR(glm::length(direction), 1.0, 1.0e-12);
    Vec2 back;
    const int face = f64::cube_face_by_rank(direction, 0);
    ASSERT_TRUE(f64::project(direction, face, projection_frame(view), back));
    EXPECT_LT(glm::length(back - pixel), 1.0e-6);
    ++tested;
  }
  EXPECT_GT(tested, 1000);
}

/// Solid angle between the view direction and `angle` from it.
double cap(double angle) { return 2.0 * std::numbers::pi * (1.0 - std::cos(angle)); }

TEST_P(EveryProjection, PixelsAddUpToTheFieldTheyCover) {
  const View& view = GetParam();
  const bool sphere = view.projection == Projection::equirectangular || view.projection == Projection::cubemap;
  // Inside the circle that touches the shorter side, or the whole sphere.
  const double side = 0.5 * std::min(view.width, view.height);
  double sum = 0.0;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const Vec2 pixel(column + 0.5, row + 0.5);
      if (sphere || glm::length(pixel - 0.5 * Vec2(view.width, view.height)) <= side) {
        sum += 1.0 / f64::pixels_per_steradian(pixel, pixel_frame(view));
      }
    }
  }
  const double expected = sphere ? 4.0 * std::numbers::pi : cap(0.5 * view.fov.to(rad));
  // A circle counted in whole pixels is good to a few parts in 1e3 at this size.
  EXPECT_NEAR(sum / expected, 1.0, sphere ? 1.0e-4 : 5.0e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Views, EveryProjection,
    testing::Values(view_of(Projection::perspective, 0.5, 300, 200), view_of(Projection::perspective, 100, 300, 300),
                    view_of(Projection::fisheye, 180, 300, 300), view_of(Projection::fisheye, 340, 400, 400),
                    view_of(Projection::stereographic, 180, 300, 300),
                    view_of(Projection::stereographic, 340, 300, 300),
                    view_of(Projection::equirectangular, 180, 360, 180), view_of(Projection::cubemap, 180, 100, 600)));

TEST(ArcTangent, AgreesWithTheLibraryEverywhere) {
  double worst = 0.0;
  for (int i = 0; i <= 20000; ++i) {
    const double angle = std::numbers::pi * i / 20000.0;
    for (const double radius : {1.0e-8, 1.0, 1.0e6}) {
      const double y = radius * std::sin(angle);
      const double x = radius * std::cos(angle);
      worst = std::max(worst, std::abs(f64::arc_tangent(y, x) - std::atan2(y, x)));
    }
  }
  EXPECT_LT(worst, 1.0e-13);
  EXPECT_EQ(f64::arc_tangent(0.0, 1.0), 0.0);
  EXPECT_NEAR(f64::arc_tangent(0.0, -1.0), std::numbers::pi, 1.0e-12);
  EXPECT_NEAR(f64::arc_tangent(1.0e-300, -1.0), std::numbers::pi, 1.0e-12);
}

TEST(ViewValidation, NamesTheValueAndTheRange) {
  const auto message = [](const View& view) -> std::string {
    try {
      validate(view);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::argument);
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(View()), "");
  EXPECT_NE(message(view_of(Projection::perspective, 170, 10, 10)).find("below 170"), std::string::npos);
  EXPECT_EQ(message(view_of(Projection::fisheye, 360, 10, 10)), "");
  EXPECT_NE(message(view_of(Projection::fisheye, 360.1, 10, 10)).find("at most 360"), std::string::npos);
  EXPECT_NE(message(view_of(Projection::stereographic, 350, 10, 10)).find("below 350"), std::string::npos);
  EXPECT_NE(message(view_of(Projection::fisheye, 0, 10, 10)), "");
  EXPECT_NE(message(view_of(Projection::fisheye, std::nan(""), 10, 10)), "");
  EXPECT_NE(message(view_of(Projection::fisheye, 90, 0, 10)), "");
  EXPECT_NE(message(view_of(Projection::cubemap, 90, 64, 64)).find("six times"), std::string::npos);
}

} // namespace
} // namespace vesper
