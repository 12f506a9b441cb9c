// The veil over a picture against the CIE's equation, in doubles.
#include "render/eye_picture.hpp"

#include "vesper/base/error.hpp"

#include "support/truth.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <numbers>

namespace vesper::test {
namespace {

using EyeGlare = RenderTest;

/// The CIE's total glare function as printed (CIE 135/1-6, eq. 8), 1/sr, and its integral over the sphere by quadrature
/// of its own.
double cie_spread(double theta_deg, double age, double p) {
  const double aged = std::pow(age / 70.0, 4.0);
  const auto bell = [&](double a, double power) { return std::pow(1.0 + std::pow(theta_deg / a, 2.0), -power); };
  return (1.0 - 0.08 * aged) * (9.2e6 * bell(0.0046, 1.5) + 1.5e5 * bell(0.045, 1.5)) +
         (1.0 + 1.6 * aged) * (400.0 * bell(0.1, 1.0) + 3.0e-8 * theta_deg * theta_deg +
                               p * (1300.0 * bell(0.1, 1.5) + 0.8 * bell(0.1, 0.5))) +
         2.5e-3 * p;
}

/// Its light within an angle, not divided by the whole.
double cie_light_within(double angle_deg, double age, double p) {
  const int steps = 4000;
  const double top = std::log(angle_deg / 1.0e-5);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double theta = 1.0e-5 * std::exp(top * (i + 0.5) / steps);
    sum += cie_spread(theta, age, p) * std::sin(theta * std::numbers::pi / 180.0) * theta;
  }
  return sum * top / steps * 2.0 * std::numbers::pi * std::numbers::pi / 180.0;
}

struct Source {
  int column;
  int row;
};

/// One lux from a single pixel.
LightPicture lone_pixel(const View& view, const Source& source) {
  LightPicture picture(view);
  const auto luminance =
      static_cast<float>(f64::pixels_per_steradian({source.column + 0.5, source.row + 0.5}, pixel_frame(view)));
  picture.at(source.column, source.row) = {0.9F * luminance, luminance, 1.1F * luminance, 2.5F * luminance};
  return picture;
}

/// Errors of the veil of a lone pixel within a range of angles from it, %. Angles below `least_pixels` of the picture
/// around the source are left out.
ErrorSum veil_errors(gpu::EyeOptics& eye, const View& view, const Source& source, double age, double low, double high) {
  constexpr double least_pixels = 16.0;
  const LightPicture picture = lone_pixel(view, source);
  const gpu::Texture frame = texture_of(picture);
  eye.see(frame, view, {.acuity = false, .age_years = age});
  const SeenPicture seen(eye);
  const double whole = cie_light_within(180.0, age, 0.5);
  const Vec2 middle(source.column + 0.5, source.row + 0.5);
  const Vec3 towards = direction_at(view, middle);
  ErrorSum errors;
  for (int row = 0; row < view.height; row += 2) {
    for (int column = 0; column < view.width; column += 2) {
      const Vec2 pixel(column + 0.5, row + 0.5);
      if (f64::pixels_per_steradian(pixel, pixel_frame(view)) == 0.0 || glm::distance(pixel, middle) < least_pixels) {
        continue;
      }
      const double angle = separation(direction_at(view, pixel), towards).to(deg);
      if (angle >= low && angle <= high) {
        errors.add(100.0 * (static_cast<double>(seen.added(pixel).y) * whole / cie_spread(angle, age, 0.5) - 1.0));
      }
    }
  }
  return errors;
}

TEST_F(EyeGlare, VeilFollowsTheCieNearASource) {
  gpu::EyeOptics eye(shaders);
  for (const double age : {20.0, 70.0}) {
    const View view = view_of(Projection::perspective, 30.0, 480, 480); // 0.06 degrees a pixel
    veil_errors(eye, view, {243, 238}, age, 0.95, 1.05)
        .hold(fmt::format("veil 1 degree from a point, age {}", age), 10.0, "%");
    veil_errors(eye, view, {243, 238}, age, 4.8, 5.2)
        .hold(fmt::format("veil 5 degrees from a point, age {}", age), 4.0, "%");
    veil_errors(eye, view, {103, 138}, age, 1.0, 14.0)
        .hold(fmt::format("veil 1 to 14 degrees from a point off the middle, age {}", age), 15.0, "%");
  }
}

TEST_F(EyeGlare, VeilFollowsTheCieFarFromASource) {
  gpu::EyeOptics eye(shaders);
  struct Case {
    const char* name;
    View view;
    Source source;
  };
  const std::vector<Case> cases{
      {"perspective", view_of(Projection::perspective, 100.0, 360, 240), {75, 58}},
      {"fisheye", view_of(Projection::fisheye, 180.0, 256, 256), {127, 129}},
      {"fisheye, at 60 degrees", view_of(Projection::fisheye, 180.0, 256, 256), {58, 80}},
      {"stereographic", view_of(Projection::stereographic, 160.0, 256, 256), {166, 60}},
      {"sphere", view_of(Projection::equirectangular, 0.0, 512, 256), {258, 65}},
      {"sphere, at the seam", view_of(Projection::equirectangular, 0.0, 512, 256), {511, 150}},
  };
  for (const Case& c : cases) {
    veil_errors(eye, c.view, c.source, 30.0, 29.0, 31.0)
        .hold(fmt::format("veil 30 degrees from a point, {}", c.name), 5.0, "%");
    veil_errors(eye, c.view, c.source, 30.0, 5.0, 15.0)
        .print(fmt::format("  5 to 15 degrees, {}", c.name).c_str(), "%");
    veil_errors(eye, c.view, c.source, 30.0, 15.0, 29.0)
        .print(fmt::format("  15 to 29 degrees, {}", c.name).c_str(), "%");
    veil_errors(eye, c.view, c.source, 30.0, 31.0, 90.0)
        .print(fmt::format("  31 to 90 degrees, {}", c.name).c_str(), "%");
  }
}

TEST_F(EyeGlare, KeepsTheLightOfTheSphere) {
  gpu::EyeOptics eye(shaders);
  const View view = view_of(Projection::equirectangular, 0.0, 512, 256);
  std::mt19937 random(3);
  LightPicture field(view, {1.0F, 1.0F, 1.0F, 1.0F});
  for (glm::vec4& light : field.light) {
    light *= std::exp2(static_cast<float>(random() % 16U));
  }
  ErrorSum errors;
  const std::vector<LightPicture> pictures{lone_pixel(view, {256, 128}), lone_pixel(view, {3, 71}),
                                           lone_pixel(view, {511, 220}), field};
  for (const LightPicture& picture : pictures) {
    for (const double age : {20.0, 75.0}) {
      const gpu::Texture frame = texture_of(picture);
      eye.see(frame, view, {.acuity = false, .age_years = age});
      errors.add(100.0 * (illuminance_of(SeenPicture(eye).extended(picture)) / illuminance_of(picture) - 1.0));
    }
  }
  errors.hold("light of the whole sphere after glare", 0.5, "%");
}

TEST_F(EyeGlare, LeavesInAFieldWhatTheCieHasThere) {
  gpu::EyeOptics eye(shaders);
  const double whole = cie_light_within(180.0, 30.0, 0.5);
  ErrorSum errors;
  for (const double fov : {1.0, 3.0, 10.0, 30.0, 90.0, 180.0}) {
    const View view = view_of(Projection::fisheye, fov, 256, 256);
    const LightPicture picture = lone_pixel(view, {128, 127});
    const gpu::Texture frame = texture_of(picture);
    eye.see(frame, view, {.acuity = false});
    const double share = illuminance_of(SeenPicture(eye).extended(picture)) / illuminance_of(picture);
    const double expected = cie_light_within(0.5 * fov, 30.0, 0.5) / whole;
    std::printf("  field of %g degrees: %.4f of the light, %.4f by the CIE\n", fov, share, expected);
    errors.add(100.0 * (share - expected));
  }
  errors.hold("light of a point that stays in a field of 1 to 180 degrees", 0.5, "% of the light");
}

TEST_F(EyeGlare, EvenSkyStaysEven) {
  gpu::EyeOptics eye(shaders);
  const std::vector<View> views{
      view_of(Projection::perspective, 1.0, 301, 200), view_of(Projection::perspective, 90.0, 301, 200),
      view_of(Projection::stereographic, 120.0, 257, 257), view_of(Projection::equirectangular, 0.0, 512, 256)};
  ErrorSum errors;
  for (const View& view : views) {
    const LightPicture picture(view, {2.0F, 3.0F, 4.0F, 5.0F});
    const gpu::Texture frame = texture_of(picture);
    eye.see(frame, view, {.acuity = false});
    ErrorSum of_view;
    for (const glm::vec4& light : SeenPicture(eye).extended(picture).light) {
      errors.add(100.0 * (static_cast<double>(light.y) / 3.0 - 1.0));
      of_view.add(100.0 * (static_cast<double>(light.y) / 3.0 - 1.0));
    }
    of_view.print("  one view", "%");
  }
  errors.hold("even sky after glare", 2.0, "%");
}

TEST_F(EyeGlare, VeilIsRoundAndFallsWithoutSteps) {
  gpu::EyeOptics eye(shaders);
  const View view = view_of(Projection::stereographic, 60.0, 480, 480);
  for (const Source source : {Source{240, 240}, Source{238, 241}, Source{133, 310}}) {
    const LightPicture picture = lone_pixel(view, source);
    const gpu::Texture frame = texture_of(picture);
    eye.see(frame, view, {.acuity = false});
    const SeenPicture seen(eye);
    const Vec2 middle(source.column + 0.5, source.row + 0.5);
    double before = 0.0;
    ErrorSum roundness;
    for (double radius = 12.0; radius < 130.0; radius *= 1.1) {
      double least = 1.0e30;
      double most = 0.0;
      double mean = 0.0;
      for (int i = 0; i < 32; ++i) {
        const double angle = i * std::numbers::pi / 16.0;
        const double veil = static_cast<double>(seen.added(middle + radius * Vec2(std::cos(angle), std::sin(angle))).y);
        least = std::min(least, veil);
        most = std::max(most, veil);
        mean += veil / 32.0;
      }
      roundness.add(100.0 * (most - least) / mean);
      if (before > 0.0) {
        EXPECT_LT(mean, before) << radius;
      }
      before = mean;
    }
    roundness.hold("difference round a circle about a point, 12 to 130 pixels", 15.0, "%");
  }
}

TEST_F(EyeGlare, HoldsExtremeLight) {
  gpu::EyeOptics eye(shaders);
  for (const View& view :
       {view_of(Projection::fisheye, 360.0, 96, 96), view_of(Projection::perspective, 169.0, 131, 66),
        view_of(Projection::stereographic, 340.0, 100, 60), view_of(Projection::perspective, 0.05, 64, 64),
        view_of(Projection::equirectangular, 0.0, 90, 45), view_of(Projection::perspective, 60.0, 1, 1),
        view_of(Projection::perspective, 60.0, 700, 3)}) {
    LightPicture sun(view, glm::vec4(1.0e-6F));
    for (int row = 0; row < view.height; ++row) {
      for (int column = 0; column < view.width / 2; ++column) {
        sun.at(column, row) = glm::vec4(2.0e9F);
      }
    }
    for (const LightPicture& picture : {LightPicture(view), sun, lone_pixel(view, {view.width - 1, view.height - 1})}) {
      const gpu::Texture frame = texture_of(picture);
      eye.see(frame, view, {});
      const bool black = picture.light == LightPicture(view).light;
      for (const glm::vec4& light : SeenPicture(eye).extended(picture).light) {
        for (int channel = 0; channel < 4; ++channel) {
          ASSERT_TRUE(std::isfinite(light[channel])) << static_cast<int>(view.projection);
          ASSERT_GE(light[channel], 0.0F) << static_cast<int>(view.projection);
          ASSERT_LT(light[channel], 1.0e10F);
          if (black) {
            ASSERT_EQ(light[channel], 0.0F);
          }
        }
      }
    }
  }
}

TEST_F(EyeGlare, PointsSendNoMoreWhereAPictureMagnifies) {
  gpu::EyeOptics eye(shaders);
  const View view = view_of(Projection::perspective, 5.0, 240, 240);
  const LightPicture star = lone_pixel(view, {121, 117});
  const gpu::Texture frame = texture_of(star);
  gpu::PointTiles tiles(shaders);
  tiles.start(view.width, view.height);
  tiles.mark(std::vector{gpu::PointTiles::Box{121.0F, 117.0F, 122.0F, 118.0F}});
  tiles.list({0, view.height});
  ErrorSum errors;
  for (const double magnification : {1.0, 3.0, 20.0}) {
    const gpu::EyeOpticsSettings settings{.acuity = false, .magnification = magnification};
    eye.see(frame, view, settings);
    const SeenPicture larger(eye);
    eye.start(view, settings);
    eye.add({frame, frame, tiles, {0, view.height}});
    eye.finish();
    const SeenPicture as_point(eye);
    for (const Vec2& pixel : {Vec2(121.5, 140.0), Vec2(60.0, 80.0), Vec2(230.0, 10.0)}) {
      const auto ratio = static_cast<double>(larger.added(pixel).y / as_point.added(pixel).y);
      errors.add(100.0 * (ratio / (magnification * magnification) - 1.0));
    }
  }
  errors.hold("veil of an extended source over that of a point, over the magnification squared", 0.01, "%");
}

TEST_F(EyeGlare, OldEyesScatterMoreAndUnseenSourcesShow) {
  gpu::EyeOptics eye(shaders);
  View view = view_of(Projection::perspective, 40.0, 240, 160);
  view.altitude = 0.0 * deg;
  const LightPicture black(view);
  const gpu::Texture frame = texture_of(black);
  const Vec3 source = direction_at(view, {400.5, 80.5});
  ErrorSum errors;
  double youngest = 0.0;
  for (const double age : {20.0, 50.0, 70.0, 85.0}) {
    eye.see(frame, view, {.acuity = false, .age_years = age, .unseen = {{source, Vec4(1.0)}}});
    const SeenPicture seen(eye);
    for (const Vec2& pixel : {Vec2(20.0, 30.0), Vec2(120.0, 80.0), Vec2(236.0, 80.0)}) {
      const double angle = separation(direction_at(view, pixel), source).to(deg);
      errors.add(100.0 * (static_cast<double>(seen.added(pixel).y) * cie_light_within(180.0, age, 0.5) /
                              cie_spread(angle, age, 0.5) -
                          1.0));
    }
    const double veil = static_cast<double>(seen.added({120.0, 80.0}).y);
    EXPECT_GT(veil, youngest);
    youngest = veil;
  }
  errors.hold("veil of a source outside the picture, ages 20 to 85", 2.0, "%");
}

TEST_F(EyeGlare, RefusesWhatIsOutOfRange) {
  gpu::EyeOptics eye(shaders);
  const View view = view_of(Projection::fisheye, 180.0, 16, 16);
  const gpu::Texture frame = texture_of(LightPicture(view));
  EXPECT_THROW(eye.see(frame, view, {.age_years = 101.0}), Error);
  EXPECT_THROW(eye.see(frame, view, {.pigmentation = -0.1}), Error);
  EXPECT_THROW(eye.see(frame, view, {.magnification = 0.0}), Error);
  EXPECT_THROW(eye.see(frame, view_of(Projection::cubemap, 0.0, 16, 96), {}), Error);
}

} // namespace
} // namespace vesper::test
