// From the frame in absolute units to display pixels.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/shader_library.hpp"
#include "vesper/plan/view.hpp"

namespace vesper::gpu {

/// Frame in, display pixels out. Adaptation, glare, acuity, noise and tone belong behind this interface; the frame
/// itself only holds the light of the scene.
class DisplayMapping {
public:
  DisplayMapping() = default;
  DisplayMapping(const DisplayMapping&) = delete;
  DisplayMapping& operator=(const DisplayMapping&) = delete;
  virtual ~DisplayMapping() = default;

  /// Of the pixels that it fills: rgba8 or rgba16.
  [[nodiscard]] virtual PixelFormat format() const = 0;

  /// Fills `pixels` (the display's code values) from `frame` (rgba32f: X, Y, Z in cd/m2 and S), both width x height.
  /// \param first_row of the picture that they hold
  virtual void map(const Texture& frame, const Texture& pixels, int width, int height, int first_row) = 0;
};

/// One luminance becomes the display's white; brighter colours keep their hue. Code values are dithered.
class PlainExposure : public DisplayMapping {
public:
  /// \param white luminance that becomes the largest code value for a neutral colour, > 0
  PlainExposure(const ShaderLibrary& library, Luminance white, PixelFormat format = PixelFormat::rgba8);

  [[nodiscard]] PixelFormat format() const override { return format_; }
  void map(const Texture& frame, const Texture& pixels, int width, int height, int first_row) override;

private:
  ProgramHandle program_;
  Luminance white_;
  PixelFormat format_;
};

/// The white luminance at which a V = 5 star seen through no air reaches a sixth of white (code value 114) in its
/// brightest pixel at the centre of the view. It follows the pixels' solid angle, since a point source gets brighter
/// the finer the pixels are: 1.0e-3 cd/m2 for 512 x 512 pixels of the whole sky.
[[nodiscard]] Luminance star_chart_white(const View& view);

/// A view of the same picture in few pixels, to meter.
[[nodiscard]] View metering_view(const View& view);

/// The white luminance at which the log-average of a frame's luminance becomes a third of white, as an automatic camera
/// would have it; not less than `least`. Pixels without light do not count.
[[nodiscard]] Luminance metered_white(const Frame& frame, Luminance least);

/// The same white where discs of Moon and Sun are in the picture: it stays as long as what would be brighter than it
/// takes less than 1/500 of the picture, and is twice their log-average where that is 1/20 or more.
/// \param discs a frame of nothing else
[[nodiscard]] Luminance white_before_discs(Luminance white, const Frame& discs);

} // namespace vesper::gpu
