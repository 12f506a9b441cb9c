// What the passes of Moon and Sun have in common: the picture of a far sphere.
#pragma once

#include "vesper/gpu/extinction_texture.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/point_pass.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/refraction_texture.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

#include <string>
#include <vector>

namespace vesper::gpu {

/// Draws a planned disc: its pixels with a fragment stage that includes disc_stage.glsl, or the point or the sprite
/// that it is. All but points hide what is drawn already.
class DiscPass {
public:
  /// The library must outlive the pass.
  DiscPass(const ShaderLibrary& library, const std::string& fragment_stage);

  /// \param defines of the fragment stage, beyond those that plan and view ask for
  void prepare(const PlannedDisc& disc, const SkyState& sky, const View& view, const FramePlan& plan,
               const std::vector<std::string>& defines = {});

  /// Whether it is drawn as a point.
  [[nodiscard]] bool is_point() const { return is_point_; }
  /// Marks where it will be drawn as a point.
  void mark(PointTiles& tiles) const {
    if (is_point_) {
      point_.mark(tiles);
    }
  }
  /// Draws into the bound framebuffer, with the stage's own block and textures bound where it is used: for a disc that
  /// is neither point nor sprite.
  void draw(const Strip& strip) { draw(strip, true); }
  /// Only hides what is drawn already, with the same stage; for what is not a point.
  void hide(const Strip& strip) { draw(strip, false); }

private:
  void draw(const Strip& strip, bool shines);

  ProgramVariants programs_;
  ProgramVariants sprite_programs_;
  PointPass point_;
  Buffer uniforms_;
  Buffer sprite_;
  RefractionTexture refraction_;
  ExtinctionTexture extinction_;
  VertexArray no_vertices_;
  const ProgramHandle* program_ = nullptr;
  int boxes_ = 0;
  bool is_point_ = false;
};

} // namespace vesper::gpu
