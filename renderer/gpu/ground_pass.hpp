// The opaque Earth below the horizon.
#pragma once

#include "vesper/gpu/frame.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/plan/view.hpp"

namespace vesper::gpu {

class GroundPass {
public:
  /// The library must outlive the pass.
  explicit GroundPass(const ShaderLibrary& library);

  void prepare(const View& view, const FramePlan& plan);

  /// Takes the light that the ground covers out of the bound framebuffer.
  void draw(const Strip& strip);

private:
  ProgramVariants programs_;
  VertexArray no_vertices_;
  const ProgramHandle* program_ = nullptr;
};

} // namespace vesper::gpu
