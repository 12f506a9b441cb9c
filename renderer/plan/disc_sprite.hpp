// Discs of a few pixels, whose light is shared out among them rather than drawn.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/plan/disc_place.hpp"
#include "vesper/plan/view.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace vesper {

/// A disc in the equal squares of a grid about it, rows upward (horizon_from_disc).
struct DiscGrid {
  struct Cell {
    Vec2 place;          ///< of its middle, in units of the disc's radius
    double inside = 0.0; ///< share inside the limb; over all cells the disc's area
    Vec4 light{};        ///< X, Y, Z, S, in any unit: what counts is how the cells share the whole
    double hides = 0.0;  ///< share that nothing behind is seen through
  };
  int edge; ///< cells of a row
  std::vector<Cell> cells;

  /// A dark disc that hides nothing. \param cells_of_edge at least 1
  explicit DiscGrid(int cells_of_edge);
  /// The place that is the mean of the light in Y; the middle without any.
  [[nodiscard]] Vec2 centre_of_light() const;
};

/// One pixel as the GPU reads it (shaders/sprite.frag, std430).
struct SpritePixel {
  f32::vec4 luminance{0.0F}; ///< X, Y, Z, S behind the air, cd/m2
  float cover = 0.0F;        ///< share of what lies behind that is hidden
  std::array<float, 3> padding{};
};

struct DiscSprite {
  PixelBox box;
  std::vector<SpritePixel> pixels; ///< by rows, those of small y first
};

/// The air's shares of X, Y, Z and S by sine of apparent altitude and light.
using AirShares = std::function<Vec4(double, const Vec4&)>;

/// \param boxes disc_boxes() of the circle
/// \param light of the whole disc above the air: X, Y, Z, S in lux
/// Nothing where the picture wraps round or ends within the disc's box, where it takes more than `largest_sprite_edge`
/// pixels across, or is wider than 6 degrees: there the picture is not the smooth one of nine places on the disc that
/// its pixels are found from.
[[nodiscard]] std::optional<DiscSprite> disc_sprite(const SkyCircle& circle, const View& view,
                                                    const Refraction& refraction, const std::vector<PixelBox>& boxes,
                                                    const DiscGrid& grid, const Vec4& light, const AirShares& air);
inline constexpr int largest_sprite_edge = 48;

} // namespace vesper
