// The veil over a picture against the CIE's equation, in doubles.
#include "render/eye_picture.hpp"

#include "support/truth.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <numbers>

namespace vesper::test {
namespace {

using EyeGlare = RenderTest;

/// The CIE's total glare function as printed (CIE 135/1-6, eq. 8), 1/sr, and its integral over the sphere by quadrature of
/// its own.
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
  const auto luminance = static_cast<float>(
      f64::pixels_per_steradian({source.column + 0.5, source.row + 0.5}, pixel_frame(view)));
  picture.at(source.column, source.row) = {0.9F * luminance, luminance, 1.1F * luminance, 2.5F * luminance};
  return picture;
}

TEST_F(EyeGlare, VeilFollowsTheCie) {
  gpu::EyeOptics eye(shaders);
  struct Case {
    const char* name;
    View view;
    Source source;
  };
  const std::vector<Case> cases{
      {"perspective 40", view_of(Projection::perspective, 40.0, 720, 480), {361, 238}},
      {"perspective 100, off the middle", view_of(Projection::perspective, 100.0, 720, 480), {150, 117}},
      {"fisheye 180", view_of(Projection::fisheye, 180.0, 512, 512), {255, 259}},
      {"fisheye 180, at 60 degrees", view_of(Projection::fisheye, 180.0, 512, 512), {117, 160}},
      {"stereographic 160", view_of(Projection::stereographic, 160.0, 512, 512), {333, 120}},
      {"sphere", view_of(Projection::equirectangular, 0.0, 1024, 512), {517, 130}},
      {"sphere, at the seam", view_of(Projection::equirectangular, 0.0, 1024, 512), {1023, 301}},
  };
  for (const double age : {20.0, 70.0}) {
    const double whole = cie_light_within(180.0, age, 0.5);
    for (const auto& [low, high, limit] : {std::array{0.9, 3.0, 6.0}, std::array{3.0, 12.0, 6.0}, std::array{12.0, 90.0, 4.0}}) {
      ErrorSum errors;
      for (const Case& c : cases) {
        const LightPicture picture = lone_pixel(c.view, c.source);
        const gpu::Texture frame = texture_of(picture);
        eye.see(frame, nullptr, c.view, {.acuity = false, .age_years = age});
        const SeenPicture seen(eye);
        const Vec3 towards = direction_at(c.view, {c.source.column + 0.5, c.source.row + 0.5});
        ErrorSum of_case;
        for (int row = 0; row < c.view.height; row += 3) {
          for (int column = 0; column < c.view.width; column += 3) {
            const Vec2 pixel(column + 0.5, row + 0.5);
            if (f64::pixels_per_steradian(pixel, pixel_frame(c.view)) == 0.0) {
              continue;
            }
            const double angle = separation(direction_at(c.view, pixel), towards).to(deg);
            // Where the picture resolves it: from five pixels on.
            const double scale = f64::eye_degrees_per_pixel(Vec2(c.source.column + 0.5, c.source.row + 0.5), pixel_frame(c.view));
            if (angle < low || angle > high || angle < 8.0 * scale) {
              continue;
            }
            const double error = 100.0 * (static_cast<double>(seen.added(pixel).y) * whole / cie_spread(angle, age, 0.5) - 1.0);
            errors.add(error);
            of_case.add(error);
          }
        }
        of_case.print(fmt::format("  {}, {} to {} degrees, age {}", c.name, low, high, age).c_str(), "%");
      }
      errors.hold(fmt::format("veil of a point, {} to {} degrees, age {}, against the CIE's function", low, high, age),
                  limit, "%");
    }
  }
}

} // namespace
} // namespace vesper::test
