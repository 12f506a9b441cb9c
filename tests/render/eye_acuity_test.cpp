// How the eye pools extended light, against Gaussians.
#include "render/eye_picture.hpp"

#include "support/truth.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <numbers>

namespace vesper::test {
namespace {

using EyeAcuity = RenderTest;

gpu::EyeOpticsSettings without_glare() { return {.glare = false}; }

/// Standard deviation in pixels that Shlaer's acuity asks for.
double pooling_pixels(double luminance, double degrees_per_pixel) {
  const double variance =
      f64::eye_pooling_variance_deg2(f64::acuity_cycles_per_degree(luminance), f64::acuity_cycles_per_degree(1.0e3));
  return std::sqrt(variance) / degrees_per_pixel;
}

TEST_F(EyeAcuity, DarknessBlursAGratingAsAGaussianDoes) {
  gpu::EyeOptics eye(shaders);
  // 0.03 degrees a pixel in the middle.
  const View view = view_of(Projection::perspective, 10.0, 512, 333);
  const double scale = f64::eye_degrees_per_pixel(0.5 * Vec2(view.width, view.height), pixel_frame(view));
  ErrorSum errors;
  for (const double luminance : {3.0e-4, 3.0e-3, 3.0e-2, 0.3, 100.0}) {
    for (const double period : {16.0, 32.0, 64.0, 128.0}) {
      LightPicture picture(view);
      for (int row = 0; row < view.height; ++row) {
        for (int column = 0; column < view.width; ++column) {
          const double wave = 1.0 + 0.3 * std::cos(2.0 * std::numbers::pi * (column + 0.5) / period);
          picture.at(column, row) = glm::vec4(static_cast<float>(luminance * wave));
        }
      }
      const gpu::Texture frame = texture_of(picture);
      eye.see(frame, view, without_glare());
      const LightPicture seen = SeenPicture(eye).extended(picture);
      // The wave that is left in the middle half of the rows and columns.
      double left = 0.0;
      double mean = 0.0;
      int count = 0;
      for (int row = 100; row < 233; ++row) {
        for (int column = 128; column < 384; ++column) {
          const auto light = static_cast<double>(seen.at(column, row).y);
          left += 2.0 * light * std::cos(2.0 * std::numbers::pi * (column + 0.5) / period);
          mean += light;
          ++count;
        }
      }
      const double modulation = left / (0.3 * luminance * count);
      const double sigma = pooling_pixels(luminance, scale);
      const double expected = std::exp(-2.0 * std::pow(std::numbers::pi * sigma / period, 2.0));
      errors.add(modulation - expected);
      EXPECT_NEAR(mean / count / luminance, 1.0, 0.002);
      std::printf("  %g cd/m2, period %g pixels: %.3f of the wave is left, %.3f by a Gaussian of %.2f pixels\n",
                  luminance, period, modulation, expected, sigma);
    }
  }
  // Worst at two texels a period of the level that is read: what would be a faint wave can come out as none.
  errors.hold("contrast of gratings in the dark against a Gaussian's response", 0.16, "of full contrast");
}

TEST_F(EyeAcuity, PointsStaySharpAndLightIsKept) {
  gpu::EyeOptics eye(shaders);
  const View view = view_of(Projection::perspective, 5.0, 256, 256);
  LightPicture all(view, glm::vec4(1.0e-3F));
  LightPicture points(view);
  points.at(100, 90) = glm::vec4(1.0F);
  all.at(100, 90) += glm::vec4(1.0F);
  const gpu::Texture frame = texture_of(all);
  const gpu::Texture of_points = texture_of(points);
  gpu::PointTiles tiles(shaders);
  tiles.start(view.width, view.height);
  tiles.mark(std::vector{gpu::PointTiles::Box{100.0F, 90.0F, 101.0F, 91.0F}});
  tiles.list({0, view.height});
  eye.start(view, without_glare(), true);
  eye.add({frame, of_points, tiles, {0, view.height}});
  eye.finish();
  const SeenPicture seen(eye);
  EXPECT_FLOAT_EQ(seen.shares({100.5, 90.5}).y, 1.0F);
  // What is seen of extended light knows nothing of the star.
  const LightPicture sky(view, glm::vec4(1.0e-3F));
  for (const glm::vec4& light : seen.extended(sky).light) {
    ASSERT_NEAR(light.y, 1.0e-3F, 1.0e-6F);
  }
}

TEST_F(EyeAcuity, PatchSpreadsAroundItsMiddleAndKeepsItsLight) {
  gpu::EyeOptics eye(shaders);
  const View view = view_of(Projection::perspective, 5.0, 256, 256);
  const double scale = f64::eye_degrees_per_pixel({128.0, 128.0}, pixel_frame(view));
  // A soft patch, so faint that the darkness stays what it is.
  constexpr double radius = 6.0;
  LightPicture picture(view);
  double given = 0.0;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const double squared = std::pow(column - 121.0, 2.0) + std::pow(row - 134.0, 2.0);
      const double more = 1.0e-4 * std::exp(-0.5 * squared / (radius * radius));
      picture.at(column, row) = glm::vec4(static_cast<float>(1.0e-3 + more));
      given += more;
    }
  }
  const gpu::Texture frame = texture_of(picture);
  eye.see(frame, view, without_glare());
  const LightPicture seen = SeenPicture(eye).extended(picture);
  double light = 0.0;
  Vec2 middle(0.0);
  double squares = 0.0;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const double more = static_cast<double>(seen.at(column, row).y) - 1.0e-3;
      light += more;
      middle += more * Vec2(column, row);
      squares += more * (std::pow(column - 121.0, 2.0) + std::pow(row - 134.0, 2.0));
    }
  }
  const double sigma = std::sqrt(0.5 * squares / light);
  const double expected = std::hypot(radius, pooling_pixels(1.0e-3, scale));
  std::printf("a patch in the dark: %.4f of its light, %.2f pixels wide for %.2f\n", light / given, sigma, expected);
  EXPECT_NEAR(light / given, 1.0, 0.02);
  EXPECT_NEAR(sigma / expected, 1.0, 0.03);
  EXPECT_NEAR(middle.x / light, 121.0, 0.2);
  EXPECT_NEAR(middle.y / light, 134.0, 0.2);
}

} // namespace
} // namespace vesper::test
