// A table of extinction on the GPU, for any pass that includes lib/extinction.glsl.
#pragma once

#include "vesper/base/shader_math.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/plan/frame_plan.hpp"

#include <memory>

namespace vesper::gpu {

class ExtinctionTexture {
public:
  /// Copies a plan's table if it is not the one copied last. None leaves all light.
  void update(const std::shared_ptr<const PlannedExtinction>& planned);

  /// How the texture is read.
  [[nodiscard]] const f64::StarExtinctionFrame& frame() const { return frame_; }

  /// Binds the texture (a sampler2D) to a unit.
  void bind(unsigned int unit) const;

private:
  Texture texture_;
  f64::StarExtinctionFrame frame_{};
  std::shared_ptr<const PlannedExtinction> planned_;
};

} // namespace vesper::gpu
