// The light of the night sky itself.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"

#include <memory>
#include <string>

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
  /// Adds what is in the air, airglow, sky glow and scattered light, for a plan that does not draw it with the sky.
  void draw_air(const Strip& strip);
  /// What that draws: rows and columns of PlannedDarkSky, as texels of X, Y, Z and S.
  [[nodiscard]] const Texture& air_map() const { return map_; }

private:
  void prepare_beyond(const std::string& projection, const View& view, const FramePlan& plan);

  ProgramVariants beyond_programs_;
  ProgramVariants air_programs_;
  VertexArray no_vertices_;
  const ProgramHandle* beyond_ = nullptr; ///< null where there is nothing of it
  int beyond_tiles_ = 0;
  const ProgramHandle* air_ = nullptr; ///< null where the sky's map has it
  Texture zodiacal_;
  Texture shares_;
  Texture bends_;
  std::shared_ptr<const DarkSkyPlace> air_of_; ///< what these two hold
  Texture milky_way_;
  std::shared_ptr<const CubePyramid> milky_way_of_; ///< what the texture holds
  Texture map_;
};

} // namespace vesper::gpu
