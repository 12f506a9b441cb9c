// From the frame in absolute units to display pixels.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/plan/view.hpp"

namespace vesper::gpu {

/// The light of a picture, or of a strip of it, on the GPU. Textures have the picture's width and at least the strip's
/// rows; row 0 of the texture is the strip's first.
struct PictureLight {
  const Texture& frame;  ///< rgba32f: X, Y, Z in cd/m2 and S, all light of the scene
  const Texture& points; ///< likewise, the part of it that comes from points (stars, planets, discs too small to show)
  const View& view;      ///< of the whole picture
  Strip strip;
};

/// Frame in, display pixels out. Adaptation, glare, acuity, noise and tone belong behind this interface; the frame
/// itself only holds the light of the scene.
class DisplayMapping {
public:
  DisplayMapping() = default;
  DisplayMapping(const DisplayMapping&) = delete;
  DisplayMapping& operator=(const DisplayMapping&) = delete;
  virtual ~DisplayMapping() = default;

  /// What map() fills.
  [[nodiscard]] virtual PixelFormat pixel_format() const { return PixelFormat::rgba8; }

  /// Looks at a whole picture before its strips are mapped. Where the picture is drawn in strips, it is a smaller one
  /// of the same view without stars.
  virtual void meter(const PictureLight& picture) = 0;

  /// Fills `pixels` (code values; row 0 is the strip's first) from a strip.
  virtual void map(const PictureLight& strip, const Texture& pixels) = 0;
};

/// A view of the same picture in few pixels, to meter.
[[nodiscard]] View metering_view(const View& view);

} // namespace vesper::gpu
