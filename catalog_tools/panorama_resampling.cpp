#include "vesper/catalog_tools/panorama_resampling.hpp"

#include "vesper/base/shader_math.hpp"
#include "vesper/base/worker_pool.hpp"
#include "vesper/catalog_tools/pixel_corners.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vesper {
namespace {

constexpr int tile_side = 64;              // pixels
constexpr std::size_t tiles_at_once = 128; // whose patches are held before they are added to the cube
constexpr std::size_t most_patch_texels = std::size_t{1} << 19;

using Quad = std::array<Vec3, 4>;

/// What a tile of pixels gives to the cube.
struct TileLight {
  std::vector<LightPatch> patches;
  LightTotal total;
};

/// One tile of pixels on its way to the cube.
class Tile {
public:
  Tile(const PictureStrip& strip, PictureWcs& wcs, const PixelBox& box, int face_size)
      : strip_(strip), wcs_(wcs), box_(box), face_size_(face_size), corners_(wcs, box), directions_(corners_.all()),
        local_(directions_.size()) {
    if (std::find(directions_.begin(), directions_.end(), Vec3(0.0)) != directions_.end()) {
      close_gaps();
    }
  }

  void spread(TileLight& result) {
    if (directions_.empty()) {
      return;
    }
    // A face's pyramid is convex: what has all corners in one touches no other.
    const int home = f64::cube_face(directions_[0], 0);
    const bool at_home = std::all_of(directions_.begin(), directions_.end(),
                                     [&](const Vec3& direction) { return f64::cube_face(direction, 0) == home; });
    for (int face = 0; face < 6; ++face) {
      if ((!at_home || face == home) && !spread_on_face(face, result)) {
        return; // done in halves
      }
    }
  }

private:
  /// Near the border of the sky in the picture each pixel has corners of its own.
  void close_gaps() {
    quads_.resize(static_cast<std::size_t>(box_.width) * static_cast<std::size_t>(box_.height));
    directions_.clear();
    for (std::size_t i = 0; i < quads_.size(); ++i) {
      const auto width = static_cast<std::size_t>(box_.width);
      quads_[i] = corners_.of_pixel(box_.x + static_cast<int>(i % width), box_.y + static_cast<int>(i / width));
      if (quads_[i]) {
        directions_.insert(directions_.end(), quads_[i]->begin(), quads_[i]->end());
      }
    }
    local_.resize(directions_.size());
  }

  /// The texels of the face that the tile's corners span, as a patch without its sums; its width is 0 for none.
  LightPatch patch_on_face(int face) {
    const Mat3 local_from_icrs = transpose(f64::cube_face_axes(face));
    const auto size = static_cast<double>(face_size_);
    LightPatch patch;
    patch.face = face;
    Vec2 low(size);
    Vec2 high(0.0);
    all_before_face_ = true;
    bool any = false;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      local_[i] = local_from_icrs * directions_[i];
      if (lies_well_before_face(local_[i])) {
        const Vec2 place = texel_place(local_[i], face_size_);
        low = min(low, place);
        high = max(high, place);
        any = true;
      } else {
        all_before_face_ = false;
      }
    }
    if (!any) {
      return patch;
    }
    if (!all_before_face_) {
      low = Vec2(0.0);
      high = Vec2(size);
    }
    low = max(floor(low), Vec2(0.0));
    high = min(ceil(high), Vec2(size));
    if (low.x < high.x && low.y < high.y) {
      patch.column = static_cast<int>(low.x);
      patch.row = static_cast<int>(low.y);
      patch.width = static_cast<int>(high.x) - patch.column;
      patch.height = static_cast<int>(high.y) - patch.row;
    }
    return patch;
  }

  /// False where the patch would be too large and the tile was spread in halves instead.
  bool spread_on_face(int face, TileLight& result) {
    LightPatch patch = patch_on_face(face);
    if (patch.width == 0) {
      return true;
    }
    const std::size_t texels = static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height);
    if (texels > most_patch_texels && result.patches.empty() && box_.width + box_.height > 2) {
      spread_halves(result);
      return false;
    }
    patch.sums.resize(texels);
    if (all_before_face_ && quads_.empty()) {
      places_.resize(local_.size());
      std::transform(local_.begin(), local_.end(), places_.begin(),
                     [&](const Vec3& local) { return texel_place(local, face_size_); });
    }
    double spread_sr = 0.0;
    for (int y = 0; y < box_.height; ++y) {
      std::array<const float*, 3> rows{};
      for (int channel = 0; channel < strip_.channels; ++channel) {
        rows[static_cast<std::size_t>(channel)] = strip_.row(channel, box_.y + y) + box_.x;
      }
      for (int x = 0; x < box_.width; ++x) {
        std::array<float, 3> brightness{};
        bool known = true;
        for (std::size_t channel = 0; channel < static_cast<std::size_t>(strip_.channels); ++channel) {
          brightness[channel] = rows[channel][x];
          known = known && std::isfinite(brightness[channel]);
        }
        if (!known) {
          continue;
        }
        const double solid_angle = spread_pixel_at(x, y, brightness, patch);
        spread_sr += solid_angle;
        for (std::size_t channel = 0; channel < 3; ++channel) {
          result.total.light[channel] += solid_angle * static_cast<double>(brightness[channel]);
        }
      }
    }
    if (spread_sr != 0.0) {
      result.total.solid_angle_sr += spread_sr;
      result.patches.push_back(std::move(patch));
    }
    return true;
  }

  double spread_pixel_at(int x, int y, const std::array<float, 3>& brightness, LightPatch& patch) {
    if (!quads_.empty()) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(box_.width) + static_cast<std::size_t>(x);
      if (!quads_[pixel]) {
        return 0.0;
      }
      const Mat3 local_from_icrs = transpose(f64::cube_face_axes(patch.face));
      Quad local = *quads_[pixel];
      for (Vec3& corner : local) {
        corner = local_from_icrs * corner;
      }
      return spread_pixel(local, brightness, face_size_, patch);
    }
    const auto a = static_cast<std::size_t>(y) * static_cast<std::size_t>(box_.width + 1) + static_cast<std::size_t>(x);
    const std::size_t b = a + static_cast<std::size_t>(box_.width + 1);
    if (all_before_face_) {
      return spread_pixel(std::array{places_[a], places_[a + 1], places_[b + 1], places_[b]}, brightness, face_size_,
                          patch);
    }
    return spread_pixel(std::array{local_[a], local_[a + 1], local_[b + 1], local_[b]}, brightness, face_size_, patch);
  }

  void spread_halves(TileLight& result) {
    PixelBox first = box_;
    PixelBox second = box_;
    if (box_.width > 1) {
      first.width = box_.width / 2;
      second.x += first.width;
      second.width -= first.width;
    } else {
      first.height = box_.height / 2;
      second.y += first.height;
      second.height -= first.height;
    }
    for (const PixelBox& half : {first, second}) {
      TileLight light;
      Tile(strip_, wcs_, half, face_size_).spread(light);
      result.total.add(light.total);
      std::move(light.patches.begin(), light.patches.end(), std::back_inserter(result.patches));
    }
  }

  const PictureStrip& strip_;
  PictureWcs& wcs_;
  PixelBox box_;
  int face_size_;
  PixelCorners corners_;
  std::vector<Vec3> directions_;
  std::vector<Vec3> local_;
  std::vector<Vec2> places_;
  std::vector<std::optional<Quad>> quads_;
  bool all_before_face_ = true;
};

} // namespace

void PanoramaResampler::add(const PictureStrip& strip, int first, int last) {
  std::vector<PixelBox> boxes;
  for (int y = first; y < last; y += tile_side) {
    for (int x = 0; x < strip.width; x += tile_side) {
      boxes.push_back({x, y, std::min(tile_side, strip.width - x), std::min(tile_side, last - y)});
    }
  }
  std::vector<TileLight> lights;
  for (std::size_t begin = 0; begin < boxes.size(); begin += tiles_at_once) {
    const std::size_t count = std::min(tiles_at_once, boxes.size() - begin);
    lights.assign(count, {});
    constexpr std::size_t tiles_a_call = 4; // share a copy of the coordinates
    parallel_for(count, tiles_a_call, [&](std::size_t from, std::size_t to) {
      PictureWcs wcs(wcs_);
      for (std::size_t i = from; i < to; ++i) {
        Tile(strip, wcs, boxes[begin + i], cube_.face_size).spread(lights[i]);
      }
    });
    for (const TileLight& light : lights) {
      for (const LightPatch& patch : light.patches) {
        cube_.add(patch);
      }
      total_.add(light.total);
    }
  }
}

} // namespace vesper
