#include "vesper/plan/view.hpp"

#include "vesper/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace vesper {
namespace {

constexpr std::array<std::string_view, 5> projections{"perspective", "fisheye", "stereographic", "equirectangular",
                                                      "cubemap"};
constexpr int largest_side = 16384;

void require(bool holds, const std::string& message, const std::string& remedy) {
  if (!holds) {
    throw Error(ErrorKind::argument, message, {"", "", remedy});
  }
}

} // namespace

std::span<const std::string_view> projection_names() { return projections; }

std::optional<Projection> projection_from_name(std::string_view name) {
  const auto* found = std::find(projections.begin(), projections.end(), name);
  if (found == projections.end()) {
    return std::nullopt;
  }
  return static_cast<Projection>(found - projections.begin());
}

Angle largest_fov(Projection projection) {
  switch (projection) {
  case Projection::perspective:
    return 170.0 * deg;
  case Projection::stereographic:
    return 350.0 * deg;
  default:
    return 360.0 * deg;
  }
}

void validate(const View& view) {
  const double fov = view.fov.to(deg);
  const double limit = largest_fov(view.projection).to(deg);
  const bool inside = view.projection == Projection::fisheye ? fov <= limit : fov < limit;
  const bool sphere = view.projection == Projection::equirectangular || view.projection == Projection::cubemap;
  require(sphere || (std::isfinite(fov) && fov > 0.0 && inside),
          fmt::format("fov {} degrees is outside the range of the {} projection", fov,
                      projections.at(static_cast<std::size_t>(view.projection))),
          fmt::format("Give more than 0 and {} {} degrees",
                      view.projection == Projection::fisheye ? "at most" : "below", limit));
  require(std::abs(view.altitude.to(deg)) <= 90.0,
          fmt::format("altitude {} degrees is outside the sphere", view.altitude.to(deg)), "Give -90 to 90 degrees");
  require(std::isfinite(view.azimuth.to(deg)) && std::isfinite(view.roll.to(deg)), "azimuth or roll is not a number",
          "Give degrees");
  require(view.width >= 1 && view.height >= 1 && view.width <= largest_side && view.height <= 6 * largest_side,
          fmt::format("size {}x{} is outside the range", view.width, view.height),
          fmt::format("Give 1 to {} pixels a side", largest_side));
  require(view.projection != Projection::cubemap || view.height == 6 * view.width,
          fmt::format("size {}x{} is no stack of six square faces", view.width, view.height),
          "Give a height of six times the width");
}

Mat3 view_from_horizon(const View& view) {
  const double azimuth = view.azimuth.to(rad);
  const double altitude = view.altitude.to(rad);
  const double roll = view.roll.to(rad);
  const double sin_az = std::sin(azimuth);
  const double cos_az = std::cos(azimuth);
  const double sin_alt = std::sin(altitude);
  const double cos_alt = std::cos(altitude);
  const Vec3 forward(cos_alt * sin_az, cos_alt * cos_az, sin_alt);
  // These hold at the zenith too, where a cross product with the vertical would fail.
  const Vec3 level_right(cos_az, -sin_az, 0.0);
  const Vec3 level_up(-sin_alt * sin_az, -sin_alt * cos_az, cos_alt);
  // The picture turns clockwise when the camera turns counter-clockwise.
  const Vec3 right = std::cos(roll) * level_right + std::sin(roll) * level_up;
  const Vec3 up = std::cos(roll) * level_up - std::sin(roll) * level_right;
  return glm::transpose(Mat3(right, up, forward));
}

f64::ProjectionFrame projection_frame(const View& view) {
  const double half_side = 0.5 * std::min(view.width, view.height);
  const double half_fov = 0.5 * view.fov.to(rad);
  f64::ProjectionFrame frame{static_cast<int>(view.projection), {view.width, view.height}, 1.0};
  switch (view.projection) {
  case Projection::perspective:
    frame.focal = half_side / std::tan(half_fov);
    break;
  case Projection::fisheye:
    frame.focal = half_side / half_fov;
    break;
  case Projection::stereographic:
    frame.focal = half_side / (2.0 * std::tan(0.5 * half_fov));
    break;
  case Projection::equirectangular:
    frame.focal = view.width / (2.0 * std::numbers::pi);
    break;
  case Projection::cubemap:
    frame.focal = 0.5 * view.width;
    break;
  }
  return frame;
}

double view_pixels_per_degree(const View& view) {
  const f64::ProjectionFrame frame = projection_frame(view);
  const double per_steradian = f64::pixels_per_steradian(0.5 * frame.size, {frame.kind, frame.size, frame.focal});
  return std::sqrt(per_steradian) * (1.0 * deg).to(rad);
}

} // namespace vesper
