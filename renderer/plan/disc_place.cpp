#include "vesper/plan/disc_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vesper {
namespace {

/// The bend of lib/refraction.glsl at an apparent direction.
double bend_at(const Vec3& apparent, const Refraction& refraction) {
  return f64::refraction_bend(apparent, true, refraction_frame(refraction), refraction_sampler(refraction));
}

/// Height over width of a small disc that is seen at a place: the derivative of the apparent altitude by the true one.
double flattening_at(const Vec3& apparent, const Refraction& refraction) {
  constexpr double step = 1.0e-4; // rad
  const double altitude = std::atan2(apparent.z, std::hypot(apparent.x, apparent.y));
  const auto refracted = [&](double at) {
    return bend_at({std::cos(at), 0.0, std::sin(at)}, refraction) * std::cos(at);
  };
  return 1.0 / (1.0 - (refracted(altitude + step) - refracted(altitude - step)) / (2.0 * step));
}

double drawn_sine(const SkyCircle& circle) { return circle.scale * std::sin(circle.radius.to(rad)); }

/// The circle's limb and what it surrounds.
class Limb {
public:
  Limb(const SkyCircle& circle, const View& view, const Refraction& refraction)
      : from_horizon_(view_from_horizon(view)), refraction_(refraction), centre_(circle.direction),
        sine_(drawn_sine(circle)) {
    const Mat3 axes = horizon_from_disc(circle.direction);
    const double cosine = std::sqrt(1.0 - sine_ * sine_);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points.size());
      points.at(i) = seen(axes * Vec3(sine_ * std::cos(angle), sine_ * std::sin(angle), cosine));
    }
    centre = seen(centre_);
  }

  /// Whether what is seen in a direction of view axes lies on the circle, or hardly beside it.
  [[nodiscard]] bool holds(const Vec3& in_view) const {
    const Vec3 place = true_direction(glm::transpose(from_horizon_) * in_view, refraction_);
    return glm::dot(place, centre_) > 0.0 && glm::length(glm::cross(place, centre_)) < 1.05 * sine_ + 1.0e-4;
  }

  /// Whether the circle reaches into a cone about a direction of view axes.
  [[nodiscard]] bool reaches(const Vec3& axis, double half_angle) const {
    double nearest = -1.0;
    for (const Vec3& point : points) {
      nearest = std::max(nearest, glm::dot(point, axis));
    }
    return nearest > std::cos(half_angle) || holds(axis);
  }

  std::array<Vec3, 96> points{}; ///< as they are seen, along view axes
  Vec3 centre{};

private:
  [[nodiscard]] Vec3 seen(const Vec3& direction) const {
    return from_horizon_ * apparent_direction(direction, refraction_);
  }

  Mat3 from_horizon_;
  const Refraction& refraction_;
  Vec3 centre_;
  double sine_;
};

struct Extent {
  Vec2 low{std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity()};

  void add(const Vec2& pixel) {
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
};

/// The pixels of an extent within a part of the picture, with room for limbs that bulge between their points.
std::optional<PixelBox> clipped(const Extent& extent, const PixelBox& part) {
  const Vec2 room = Vec2(2.0) + 0.01 * (extent.high - extent.low);
  const auto pixel = [](double at, int low, int high) {
    return static_cast<int>(std::clamp(at, static_cast<double>(low), static_cast<double>(high)));
  };
  const PixelBox box{pixel(std::floor(extent.low.x - room.x), part.low_x, part.high_x),
                     pixel(std::floor(extent.low.y - room.y), part.low_y, part.high_y),
                     pixel(std::ceil(extent.high.x + room.x), part.low_x, part.high_x),
                     pixel(std::ceil(extent.high.y + room.y), part.low_y, part.high_y)};
  if (box.low_x >= box.high_x || box.low_y >= box.high_y) {
    return std::nullopt;
  }
  return box;
}

/// The part of a picture, or of a cube's face, in which a projection about one point shows the circle.
/// \param axis through its middle, view axes
std::optional<PixelBox> box_about(const Limb& limb, const f64::ProjectionFrame& frame, int face, const Vec3& axis,
                                  const PixelBox& part) {
  const bool plane = frame.kind == f64::projection_perspective || frame.kind == f64::projection_cubemap;
  const double corner_px = 0.5 * std::hypot(part.high_x - part.low_x + 4, part.high_y - part.low_y + 4);
  if (plane && !limb.reaches(axis, std::atan(corner_px / frame.focal))) {
    return std::nullopt;
  }
  Extent extent;
  std::size_t missing = 0;
  for (const Vec3& point : limb.points) {
    Vec2 pixel;
    if (f64::project(point, face, frame, pixel)) {
      extent.add(pixel);
    } else {
      ++missing;
    }
  }
  if (missing == limb.points.size()) {
    return std::nullopt;
  }
  return missing > 0 ? std::optional(part) : clipped(extent, part);
}

/// On a map of longitude and latitude, whose left and right edges meet.
std::vector<PixelBox> boxes_on_map(const Limb& limb, const f64::ProjectionFrame& frame, const PixelBox& all) {
  Vec2 middle;
  f64::project(limb.centre, 0, frame, middle);
  Extent extent;
  for (const Vec3& point : limb.points) {
    Vec2 pixel;
    f64::project(point, 0, frame, pixel);
    extent.add({middle.x + std::remainder(pixel.x - middle.x, frame.size.x), pixel.y});
  }
  const bool top = limb.holds({0.0, 1.0, 0.0});
  const bool bottom = limb.holds({0.0, -1.0, 0.0});
  if (top || bottom) {
    extent.add({0.0, top ? 0.0 : frame.size.y});
    extent.add({frame.size.x, top && bottom ? frame.size.y : extent.low.y});
    extent.low.x = 0.0; // once around
    extent.high.x = frame.size.x;
  }
  std::vector<PixelBox> boxes;
  for (const double turn : {0.0, frame.size.x, -frame.size.x}) {
    Extent turned = extent;
    turned.low.x += turn;
    turned.high.x += turn;
    if (const auto box = clipped(turned, all); box && !(turn != 0.0 && (top || bottom))) {
      boxes.push_back(*box);
    }
  }
  // Pixels are drawn once.
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    const bool right = boxes[i].low_x > boxes[0].low_x;
    boxes[i].low_x = right ? std::max(boxes[i].low_x, boxes[0].high_x) : boxes[i].low_x;
    boxes[i].high_x = right ? boxes[i].high_x : std::min(boxes[i].high_x, boxes[0].low_x);
  }
  std::erase_if(boxes, [](const PixelBox& box) { return box.low_x >= box.high_x; });
  return boxes;
}

} // namespace

f64::DiscFrame disc_frame(const SkyCircle& circle, const View& view, const Refraction& refraction) {
  const Mat3 from_horizon = view_from_horizon(view);
  const Vec3 apparent = apparent_direction(circle.direction, refraction);
  const double bend = bend_at(apparent, refraction);
  const f64::vec2 raising = f64::disc_raising(apparent.z, -bend);
  const Mat3 axes = horizon_from_disc(circle.direction);
  f64::DiscFrame frame{};
  frame.centre = from_horizon * apparent;
  frame.sine = std::sin(circle.radius.to(rad));
  frame.right = from_horizon * axes[0];
  frame.scale = circle.scale;
  frame.upward = from_horizon * axes[1];
  frame.flattening = flattening_at(apparent, refraction);
  frame.zenith = from_horizon[2];
  frame.along = raising.x;
  frame.turn = raising.y;
  frame.up_centre = glm::dot(axes[1], apparent);
  frame.up_zenith = axes[1].z;
  return frame;
}

std::vector<PixelBox> disc_boxes(const SkyCircle& circle, const View& view, const Refraction& refraction) {
  const Limb limb(circle, view, refraction);
  const f64::ProjectionFrame frame = projection_frame(view);
  const PixelBox all{0, 0, view.width, view.height};
  if (view.projection == Projection::equirectangular) {
    return boxes_on_map(limb, frame, all);
  }
  std::vector<PixelBox> boxes;
  if (view.projection == Projection::cubemap) {
    for (int face = 0; face < 6; ++face) {
      const Vec3 axis = f64::cube_from_view(f64::cube_face_axes(face)[2]);
      if (const auto box =
              box_about(limb, frame, face, axis, {0, face * view.width, view.width, (face + 1) * view.width})) {
        boxes.push_back(*box);
      }
    }
    return boxes;
  }
  // Round pictures have the point behind the camera all around them.
  const bool around = view.projection != Projection::perspective && limb.holds({0.0, 0.0, -1.0});
  if (const auto box = around ? std::optional(all) : box_about(limb, frame, 0, {0.0, 0.0, 1.0}, all)) {
    boxes.push_back(*box);
  }
  return boxes;
}

double disc_diameter_px(const SkyCircle& circle, const View& view, const Refraction& refraction) {
  const Vec3 centre = view_from_horizon(view) * apparent_direction(circle.direction, refraction);
  const f64::ProjectionFrame frame = projection_frame(view);
  Vec2 pixel;
  const int face = view.projection == Projection::cubemap ? f64::cube_face_by_rank(centre, 0) : 0;
  if (!f64::project(centre, face, frame, pixel)) {
    return 0.0;
  }
  const double per_steradian = f64::pixels_per_steradian(pixel, {frame.kind, frame.size, frame.focal});
  return 2.0 * drawn_sine(circle) * std::sqrt(std::max(per_steradian, 0.0));
}

} // namespace vesper
