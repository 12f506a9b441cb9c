// The Moon.
#pragma once

#include "vesper/gpu/disc_pass.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

#include <memory>

namespace vesper::gpu {

/// What the fragment stage computes.
enum class MoonShading {
  surface, ///< the Moon's own law, both lights, eclipse and air
  lambert, ///< the same sphere and map under a law of cosines: the yardstick of benchmarks
};

class MoonPass {
public:
  /// The library must outlive the pass.
  explicit MoonPass(const ShaderLibrary& library);

  /// Makes a frame's Moon ready, whose plan has one.
  void prepare(const SkyState& sky, const View& view, const FramePlan& plan,
               MoonShading shading = MoonShading::surface);

  /// Draws it over what the bound framebuffer holds.
  void draw(const Strip& strip);

  /// Whether it is drawn as a point.
  [[nodiscard]] bool is_point() const { return disc_.is_point(); }
  /// Marks where it will be drawn as one.
  void mark(PointTiles& tiles) const { disc_.mark(tiles); }
  /// Only hides what is behind it; for a disc.
  void hide(const Strip& strip);

private:
  void bind() const;

  DiscPass disc_;
  Buffer uniforms_;
  Texture map_;
  Texture eclipse_;
  std::shared_ptr<const MoonGlobe> globe_;
};

} // namespace vesper::gpu
