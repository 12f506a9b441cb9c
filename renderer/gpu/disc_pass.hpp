// What the passes of Moon and Sun have in common: the picture of a far sphere.
#pragma once

#include "vesper/gpu/extinction_texture.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/refraction_texture.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"

#include <string>
#include <vector>

namespace vesper::gpu {

/// Draws the pixels of a planned disc with a fragment stage that includes disc_stage.glsl. They hide what is drawn
/// already as far as the stage says.
class DiscPass {
public:
  /// The library must outlive the pass.
  DiscPass(const ShaderLibrary& library, const std::string& fragment_stage);

  /// \param defines of the fragment stage, beyond those that plan and view ask for
  void prepare(const PlannedDisc& disc, const View& view, const FramePlan& plan,
               const std::vector<std::string>& defines = {});

  /// Draws into the bound framebuffer, with the stage's own block and textures bound.
  void draw(const Strip& strip) { draw(strip, true); }
  /// Only hides what is drawn already, with the same stage.
  void hide(const Strip& strip) { draw(strip, false); }

private:
  void draw(const Strip& strip, bool shines);

  ProgramVariants programs_;
  Buffer uniforms_;
  RefractionTexture refraction_;
  ExtinctionTexture extinction_;
  VertexArray no_vertices_;
  const ProgramHandle* program_ = nullptr;
  int boxes_ = 0;
};

} // namespace vesper::gpu
