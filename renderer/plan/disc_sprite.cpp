#include "vesper/plan/disc_sprite.hpp"

#include "vesper/astro/spherical.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vesper {
namespace {

/// Lagrange's polynomials for places of -1, 0 and 1.
Vec3 weights_at(double t) { return {0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0)}; }

/// Where a disc's places are seen: nine of them exactly, the others between them.
class SeenPlaces {
public:
  SeenPlaces(const SkyCircle& circle, const Refraction& refraction)
      : axes_(horizon_from_disc(circle.direction)), refraction_(refraction),
        sine_(circle.scale * std::sin(circle.radius.to(rad))) {}

  /// Direction, horizon frame.
  [[nodiscard]] Vec3 seen(const Vec2& place) const {
    const Vec2 across = sine_ * place;
    return apparent_direction(axes_ * Vec3(across, std::sqrt(1.0 - glm::dot(across, across))), refraction_);
  }
  [[nodiscard]] double sine() const { return sine_; }

  /// Finds the pixels of the nine. False where the picture has one not.
  bool project(const View& view, int face) {
    const f64::ProjectionFrame frame = projection_frame(view);
    const Mat3 from_horizon = view_from_horizon(view);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        if (!f64::project(from_horizon * seen({column - 1, row - 1}), face, frame, pixels_[index(column, row)])) {
          return false;
        }
      }
    }
    return true;
  }
  [[nodiscard]] Vec2 pixel(const Vec2& place) const {
    const Vec3 x = weights_at(place.x);
    const Vec3 y = weights_at(place.y);
    Vec2 sum(0.0);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        sum += x[column] * y[row] * pixels_[index(column, row)];
      }
    }
    return sum;
  }

private:
  static std::size_t index(int column, int row) {
    return 3 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column);
  }

  Mat3 axes_;
  const Refraction& refraction_;
  double sine_;
  std::array<Vec2, 9> pixels_{};
};

/// A cell in the picture.
struct SeenCell {
  Vec2 middle;
  Vec2 size; ///< along the pixels' edges: of the rectangle with the same moments of inertia
  double area;
};

SeenCell cell_between(const Vec2& a, const Vec2& right, const Vec2& up, const Vec2& b) {
  const Vec2 across = 0.5 * (right - a + b - up);
  const Vec2 upward = 0.5 * (up - a + b - right);
  const Vec2 one = b - a;
  const Vec2 other = up - right;
  return {0.25 * (a + right + up + b),
          {std::hypot(across.x, upward.x), std::hypot(across.y, upward.y)},
          0.5 * std::abs(one.x * other.y - one.y * other.x)};
}

/// Share of a tent from -1 to 1 that lies below t.
double tent_below(double t) {
  const double rest = 1.0 - std::min(std::abs(t), 1.0);
  return t < 0.0 ? 0.5 * rest * rest : 1.0 - 0.5 * rest * rest;
}

/// Calls `with(pixel, share)` along one axis. A cell is spread as a tent over twice its size: whichever way cells are
/// turned against the pixels, together they are even within a thousandth.
template <class With> void for_pixels(double middle, double size, const With& with) {
  const int end = static_cast<int>(std::ceil(middle + size));
  double below = 0.0;
  for (int pixel = static_cast<int>(std::floor(middle - size)); pixel < end; ++pixel) {
    const double to_its_end = tent_below((pixel + 1 - middle) / size);
    with(pixel, to_its_end - below);
    below = to_its_end;
  }
}

/// Adds a cell to the pixels that it lies on.
void add(DiscSprite& sprite, const SeenCell& cell, const Vec4& luminance, double hides) {
  const PixelBox& box = sprite.box;
  for_pixels(cell.middle.y, cell.size.y, [&](int y, double of_rows) {
    for_pixels(cell.middle.x, cell.size.x, [&](int x, double of_columns) {
      if (x >= box.low_x && x < box.high_x && y >= box.low_y && y < box.high_y) {
        const double area = cell.area * of_rows * of_columns;
        SpritePixel& pixel =
            sprite.pixels[static_cast<std::size_t>((y - box.low_y) * (box.high_x - box.low_x) + x - box.low_x)];
        pixel.luminance += f32::vec4(area * luminance);
        pixel.cover += static_cast<float>(area * hides);
      }
    });
  });
}

} // namespace

DiscGrid::DiscGrid(int cells_of_edge) : edge(cells_of_edge) {
  const double width = 2.0 / edge;
  for (int row = 0; row < edge; ++row) {
    for (int column = 0; column < edge; ++column) {
      const Vec2 place = width * Vec2(column + 0.5, row + 0.5) - 1.0;
      cells.push_back({place, f64::disc_cover(glm::length(place), width)});
    }
  }
}

Vec2 DiscGrid::centre_of_light() const {
  Vec2 weighted(0.0);
  double sum = 0.0;
  for (const Cell& cell : cells) {
    weighted += cell.light.y * cell.place;
    sum += cell.light.y;
  }
  return sum > 0.0 ? weighted / sum : Vec2(0.0);
}

std::optional<DiscSprite> disc_sprite(const SkyCircle& circle, const View& view, const Refraction& refraction,
                                      const std::vector<PixelBox>& boxes, const DiscGrid& grid, const Vec4& light,
                                      const AirShares& air) {
  if (boxes.size() != 1 || boxes[0].high_x - boxes[0].low_x > largest_sprite_edge ||
      boxes[0].high_y - boxes[0].low_y > largest_sprite_edge) {
    return std::nullopt;
  }
  SeenPlaces places(circle, refraction);
  const int face = view.projection == Projection::cubemap ? boxes[0].low_y / view.width : 0;
  if (places.sine() > 0.05 || !places.project(view, face)) {
    return std::nullopt;
  }
  DiscSprite sprite{boxes[0], {}};
  sprite.pixels.resize(static_cast<std::size_t>(sprite.box.high_x - sprite.box.low_x) *
                       static_cast<std::size_t>(sprite.box.high_y - sprite.box.low_y));
  Vec4 whole(0.0);
  for (const DiscGrid::Cell& cell : grid.cells) {
    whole += cell.light;
  }
  const int edge = grid.edge;
  const double width = 2.0 / edge;
  const Vec4 luminance = light / glm::max(whole, 1.0e-300) / std::pow(width * places.sine(), 2); // of a cell's light
  const auto corners_of = [&](int row) {
    std::vector<Vec2> corners;
    for (int column = 0; column <= edge; ++column) {
      corners.push_back(places.pixel(width * Vec2(column, row) - 1.0));
    }
    return corners;
  };
  std::vector<Vec2> below = corners_of(0);
  auto cell = grid.cells.begin();
  for (int row = 0; row < edge; ++row) {
    std::vector<Vec2> above = corners_of(row + 1);
    Vec4 of_row(0.0);
    std::for_each(cell, cell + edge, [&](const DiscGrid::Cell& each) { of_row += each.light; });
    const double sin_altitude = places.seen({0.0, cell->place.y}).z;
    const Vec4 seen = of_row.y > 0.0 ? luminance * air(sin_altitude, luminance * of_row) : Vec4(0.0);
    for (std::size_t column = 0; column < static_cast<std::size_t>(edge); ++column, ++cell) {
      if (cell->hides > 0.0) {
        add(sprite, cell_between(below[column], below[column + 1], above[column], above[column + 1]),
            seen * cell->light, cell->hides);
      }
    }
    below = std::move(above);
  }
  for (SpritePixel& pixel : sprite.pixels) {
    pixel.cover = pixel.cover > 0.999F ? 1.0F : pixel.cover; // opaque
  }
  return sprite;
}

} // namespace vesper
