// What rendering tests share: a context, synthetic skies and sums over pixels.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/gpu/headless_context.hpp"
#include "vesper/gpu/renderer.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/spectrum.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace vesper::test {

/// A context and a renderer for every case.
class RenderTest : public testing::Test {
protected:
  gpu::HeadlessContext context;
  gpu::ShaderLibrary shaders;
  gpu::Renderer renderer{shaders};
};

/// A sky whose ICRS axes are the horizon's, with the observer at rest: a star stands where its record says.
inline SkyState still_sky() {
  SkyState sky;
  sky.stars.horizon_from_icrs = Mat3(1.0);
  sky.observer.height = 0.0 * metre;
  return sky;
}

/// Stars alone, with nothing between them and the observer.
inline FrameOptions bare_stars() {
  FrameOptions options;
  options.layers.reset();
  options.layers.set(static_cast<std::size_t>(Layer::stars));
  options.air.refraction = false;
  options.air.extinction = false;
  options.air.scintillation = false;
  return options;
}

inline StarRecord white_star(const Vec3& direction, double illuminance_lux) {
  StarRecord star{};
  star.position = {static_cast<float>(direction.x), static_cast<float>(direction.y), static_cast<float>(direction.z)};
  star.illuminance = static_cast<float>(illuminance_lux);
  star.color = {0.95F, 1.0F, 1.09F, 2.2F};
  return star;
}

/// A black body of a colour index.
inline StarRecord star_of_color(double b_v, const Vec3& direction, double illuminance_lux) {
  StarRecord star = white_star(direction, illuminance_lux);
  const Xyzs color = star_color(b_v);
  star.color = {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z),
                static_cast<float>(color.s)};
  return star;
}

/// The share of its X, Y, Z and S that comes through the air, by quadrature along the straight ray and over the
/// spectrum.
inline Vec4 share_through(const Medium& medium, Length height, const Vec3& direction, double b_v) {
  const Vec3 eye(0.0, 0.0, (medium.ground_radius + height).to(kilometre));
  const AirColumns columns = columns_to_space(medium, eye, glm::normalize(direction));
  const Spectrum above = planck_spectrum(star_temperature_k(b_v));
  std::vector<double> left = above.values();
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] *= optical_depth(medium, columns, above.wavelengths_nm()[i]).transmittance();
  }
  const Xyzs all = integrate_xyzs(above);
  const Xyzs some = integrate_xyzs({above.wavelengths_nm(), std::move(left)});
  return {some.x / all.x, some.y / all.y, some.z / all.z, some.s / all.s};
}

inline StarCatalogue catalogue_of(std::vector<StarRecord> stars) {
  StarCatalogue catalogue;
  catalogue.identities.resize(stars.size());
  catalogue.stars = std::move(stars);
  return catalogue;
}

inline f64::PixelFrame pixel_frame(const View& view) {
  const f64::ProjectionFrame projection = projection_frame(view);
  return {projection.kind, projection.size, projection.focal};
}

/// Horizon direction through a point of the picture.
inline Vec3 direction_at(const View& view, const Vec2& pixel) {
  Vec3 direction;
  f64::unproject(pixel, pixel_frame(view), direction);
  return glm::transpose(view_from_horizon(view)) * direction;
}

/// Solid angle of a spherical triangle (van Oosterom and Strackee 1983), sr.
inline double triangle_solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double volume = std::abs(glm::dot(a, glm::cross(b, c)));
  return 2.0 * std::atan2(volume, 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

/// Solid angle of a pixel from its corners on the sphere: independent of the area element that the shaders use.
inline double pixel_solid_angle(const View& view, int column, int row) {
  const f64::PixelFrame frame = pixel_frame(view);
  const auto corner = [&](int dx, int dy) {
    // Just inside, so that a corner of a cube face is taken on that face.
    const double inset = 1.0e-6;
    Vec3 direction;
    f64::unproject({column + (dx == 0 ? inset : 1.0 - inset), row + (dy == 0 ? inset : 1.0 - inset)}, frame, direction);
    return direction;
  };
  const Vec3 a = corner(0, 0);
  const Vec3 b = corner(1, 0);
  const Vec3 c = corner(1, 1);
  const Vec3 d = corner(0, 1);
  return triangle_solid_angle(a, b, c) + triangle_solid_angle(a, c, d);
}

/// Sum of luminance times solid angle over a window clipped to the frame, in one channel: an illuminance in lux.
inline double illuminance_in(const gpu::Frame& frame, const View& view, int first_column, int first_row, int columns,
                             int rows, int channel = 1) {
  double sum = 0.0;
  for (int row = std::max(first_row, 0); row < std::min(first_row + rows, frame.height); ++row) {
    for (int column = std::max(first_column, 0); column < std::min(first_column + columns, frame.width); ++column) {
      const auto luminance = static_cast<double>(frame.pixel(column, row)[channel]);
      if (luminance != 0.0) {
        sum += luminance * pixel_solid_angle(view, column, row);
      }
    }
  }
  return sum;
}

} // namespace vesper::test
