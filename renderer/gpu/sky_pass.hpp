// The light of the air and of the ground below it.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/sky_map.hpp"
#include "vesper/gpu/sky_textures.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

#include <optional>

namespace vesper::gpu {

/// Draws what a plan's lights make of its tables, for an observer at any height.
class SkyPass {
public:
  /// The library must outlive the pass.
  explicit SkyPass(const ShaderLibrary& library);

  /// Frames that other tables take to come in once they are copied, 2 MiB a frame; 0: they are there at once.
  void change_over(int frames) { change_frames_ = frames; }

  /// Computes the map of a frame whose plan has lights.
  /// \param dark_air DarkSkyPass::air_map for a plan that draws it with the sky, else null; must outlive the drawing
  void prepare(const SkyState& sky, const View& view, const FramePlan& plan, const Texture* dark_air);

  /// Adds the sky to the bound framebuffer.
  void draw(const Strip& strip);

private:
  /// Brings the tables of a plan one frame nearer to be drawn; returns their share.
  double advance(const std::shared_ptr<const SkyTables>& wanted);

  SkyMap map_;
  ProgramVariants programs_;
  ProgramVariants peak_programs_;
  VertexArray no_vertices_;
  const ProgramHandle* program_ = nullptr;
  const Texture* dark_air_ = nullptr;
  const ProgramHandle* peak_program_ = nullptr;
  int peak_tiles_ = 0; ///< of all lights
  std::optional<SkyTextures> now_;
  std::optional<SkyTextures> next_;
  int change_frames_ = 0;
  int frames_blended_ = 0;
};

} // namespace vesper::gpu
