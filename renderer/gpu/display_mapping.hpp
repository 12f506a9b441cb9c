// From the frame in absolute units to display pixels.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/point_tiles.hpp"
#include "vesper/plan/view.hpp"

namespace vesper::gpu {

/// The light of a picture's strip on the GPU. Textures have the picture's width and at least the strip's rows; their
/// row 0 is the strip's first.
struct StripLight {
  const Texture& frame;    ///< rgba32f: X, Y, Z in cd/m2 and S, all light of the scene
  const Texture& points;   ///< likewise, the part of it that comes from points: stars, planets, discs too small to show
  const PointTiles& tiles; ///< the strip's are listed; elsewhere than in those with points, `points` is 0
  Strip strip;             ///< its first row is a multiple of 4
};

/// Frame in, display pixels out. Adaptation, glare, acuity, noise and tone belong behind this interface; the frame
/// itself only holds the light of the scene. A picture is looked at as a whole before it is mapped: start(), look() at
/// every strip, map() every strip.
class DisplayMapping {
public:
  DisplayMapping() = default;
  DisplayMapping(const DisplayMapping&) = delete;
  DisplayMapping& operator=(const DisplayMapping&) = delete;
  virtual ~DisplayMapping() = default;

  /// Of the pixels that it fills: rgba8 or rgba16.
  [[nodiscard]] virtual PixelFormat format() const = 0;

  /// Begins a picture.
  virtual void start(const View& view) = 0;

  /// Takes in a strip for what depends on the whole picture.
  virtual void look(const StripLight& light) = 0;

  /// Fills `pixels` (the display's code values; row 0 is the strip's first, what lies past its last is undefined) once
  /// all strips have been looked at.
  virtual void map(const StripLight& light, const Texture& pixels) = 0;
};

} // namespace vesper::gpu
