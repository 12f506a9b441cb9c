// Stars as instanced billboards, added to the frame.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/gpu/extinction_texture.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/point_tiles.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/refraction_texture.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

#include <string>
#include <vector>

namespace vesper::gpu {

/// What the fragment stage computes.
enum class StarShading {
  psf,            ///< the point-spread function
  constant_color, ///< the same billboards in one colour: the yardstick of benchmarks
};

class StarPass {
public:
  /// The library must outlive the pass. `defines` are for star.comp, beyond those that a frame's plan asks for.
  explicit StarPass(const ShaderLibrary& library, std::vector<std::string> defines = {});

  /// Copies a catalogue to the GPU in place of the one before.
  void load(const StarCatalogue& catalogue);

  /// Places the stars of a frame in the picture, on the GPU.
  void place(const SkyState& sky, const View& view, const FramePlan& plan, StarShading shading = StarShading::psf);

  /// Marks where the placed stars will be drawn.
  void mark(PointTiles& tiles) const;

  /// Draws the placed stars into the bound framebuffer.
  void draw(const Strip& strip);

private:
  std::vector<std::string> defines_;
  ProgramVariants place_programs_;
  ProgramVariants draw_programs_;
  Buffer records_;
  Buffer numbers_;
  Buffer billboards_;
  Buffer uniforms_;
  RefractionTexture refraction_;
  ExtinctionTexture extinction_;
  VertexArray vertices_;
  const ProgramHandle* draw_program_ = nullptr;
  std::size_t instances_ = 0;
  double epoch_jyear_ = 2000.0;
};

} // namespace vesper::gpu
