// Draws frames of the sky.
#pragma once

#include "vesper/assets/star_catalogue.hpp"
#include "vesper/gpu/dark_sky_pass.hpp"
#include "vesper/gpu/display_mapping.hpp"
#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/ground_pass.hpp"
#include "vesper/gpu/moon_pass.hpp"
#include "vesper/gpu/planet_pass.hpp"
#include "vesper/gpu/point_tiles.hpp"
#include "vesper/gpu/shader_library.hpp"
#include "vesper/gpu/sky_pass.hpp"
#include "vesper/gpu/star_pass.hpp"
#include "vesper/gpu/sun_pass.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"
#include "vesper/sky/sky_state.hpp"

#include <memory>

namespace vesper::gpu {

/// What render() hands back.
struct RenderOutputs {
  bool xyzs = true;                  ///< the frame itself
  DisplayMapping* mapping = nullptr; ///< display pixels through it, in its depth; none if null
  bool timings = false;              ///< wall-clock time per pass; costs a wait for the GPU after each
  StarShading star_shading = StarShading::psf;
  MoonShading moon_shading = MoonShading::surface;
};

/// Needs a current OpenGL 4.5 core context from construction to destruction, all on one thread. A picture larger than
/// the GPU's largest texture is drawn in strips, with the same pixels as in one piece; twice where it is mapped for a
/// display, which looks at all of it first.
class Renderer {
public:
  /// The library must outlive the renderer. There are no stars until load().
  explicit Renderer(const ShaderLibrary& library);
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  ~Renderer();

  /// Copies a catalogue to the GPU in place of the one before. Plans for a frame must be made from the same one.
  void load(const StarCatalogue& catalogue) { star_pass_.load(catalogue); }

  /// Draws one frame. Throws Error(argument) for a view out of range and Error(gpu) when the GPU fails.
  [[nodiscard]] Frame render(const SkyState& sky, const View& view, const FramePlan& plan,
                             const RenderOutputs& outputs = {});

  /// Frames that other tables of the sky take to come in; 0, the default: none, so that a frame depends on nothing that
  /// was drawn before. A running picture shows no step and does not wait while they are copied.
  void change_sky_over(int frames) { sky_pass_.change_over(frames); }

  /// Rows that a strip may have at most; 0 for what the GPU takes. For tests.
  void limit_strip_rows(int rows) { strip_limit_ = rows; }

private:
  struct Target;
  Target& target(int width, int rows, const DisplayMapping* mapping);

  StarPass star_pass_;
  PlanetPass planet_pass_;
  DarkSkyPass dark_sky_pass_;
  MoonPass moon_pass_;
  SunPass sun_pass_;
  GroundPass ground_pass_;
  SkyPass sky_pass_;
  PointTiles point_tiles_;
  std::unique_ptr<Target> target_;
  int strip_limit_ = 0;
};

} // namespace vesper::gpu
