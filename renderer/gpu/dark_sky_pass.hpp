// The light of the night sky itself.
#pragma once

#include "vesper/gpu/extinction_texture.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/refraction_texture.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"

#include <memory>

namespace vesper::gpu {

/// Draws a plan's dark sky in two parts, between which all that is nearer than the stars comes.
class DarkSkyPass {
public:
  /// The library must outlive the pass.
  explicit DarkSkyPass(const ShaderLibrary& library);

  /// For a plan that has a dark sky.
  void prepare(const View& view, const FramePlan& plan);

  /// Adds what comes through the air to the bound framebuffer: zodiacal light and faint stars.
  void draw_beyond(const Strip& strip);
  /// Adds what is in the air: airglow, sky glow and scattered light.
  void draw_air(const Strip& strip);

private:
  void prepare_beyond(const View& view, const FramePlan& plan);
  void prepare_milky_way(const FramePlan& plan);
  void draw(const ProgramHandle& program, const Strip& strip);

  ProgramVariants programs_;
  VertexArray no_vertices_;
  const ProgramHandle* beyond_ = nullptr; ///< null where there is nothing of it
  const ProgramHandle* air_ = nullptr;
  ExtinctionTexture extinction_;
  RefractionTexture refraction_;
  Texture zodiacal_;
  Texture milky_way_;
  std::shared_ptr<const CubePyramid> milky_way_of_; ///< what the texture holds
  Texture map_;
};

} // namespace vesper::gpu
