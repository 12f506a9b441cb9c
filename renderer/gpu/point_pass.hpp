// Discs too small to show as such: points as sharp as the picture draws stars.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/star_pass.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

namespace vesper::gpu {

class PointPass {
public:
  /// The library must outlive the pass.
  explicit PointPass(const ShaderLibrary& library) : points_(library) {}

  void place(const PointLight& point, const SkyState& sky, const View& view, const FramePlan& plan);

  /// Marks where it will be drawn.
  void mark(PointTiles& tiles) const { points_.mark(tiles); }

  /// Adds the point to the bound framebuffer.
  void draw(const Strip& strip) { points_.draw(strip); }

private:
  StarPass points_;
};

} // namespace vesper::gpu
