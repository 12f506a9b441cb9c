// The Sun.
#pragma once

#include "vesper/gpu/disc_pass.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

namespace vesper::gpu {

class SunPass {
public:
  /// The library must outlive the pass.
  explicit SunPass(const ShaderLibrary& library);

  /// Makes a frame's Sun ready, whose plan has one.
  void prepare(const SkyState& sky, const View& view, const FramePlan& plan);

  /// Draws disc and corona, without what the Moon hides of them, over what the bound framebuffer holds.
  void draw(const Strip& strip);

  /// Whether it is drawn as a point.
  [[nodiscard]] bool is_point() const { return disc_.is_point(); }
  /// Marks where it will be drawn as one.
  void mark(PointTiles& tiles) const { disc_.mark(tiles); }
  /// Only hides what is behind it; for a disc.
  void hide(const Strip& strip);

private:
  DiscPass disc_;
  Buffer uniforms_;
};

} // namespace vesper::gpu
