// The planets as point sources, drawn like stars.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/star_pass.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

namespace vesper::gpu {

/// Extinction, point-spread function and scintillation are the star pass's; the disc's width calms the scintillation.
/// Topocentric places are computed on the CPU, since parallax and light time are the planets' own.
class PlanetPass {
public:
  /// The library must outlive the pass.
  explicit PlanetPass(const ShaderLibrary& library) : points_(library, {"DISCS"}) {}

  /// Places the planets of a frame that are not fainter than the plan's limit in the picture.
  void place(const SkyState& sky, const View& view, const FramePlan& plan);

  /// Marks where the placed planets will be drawn.
  void mark(PointTiles& tiles) const { points_.mark(tiles); }

  /// Draws the placed planets into the bound framebuffer.
  void draw(const Strip& strip) { points_.draw(strip); }

private:
  StarPass points_;
  Buffer discs_;
};

} // namespace vesper::gpu
