// The refraction table on the GPU, for any pass that includes lib/refraction.glsl.
#pragma once

#include "vesper/astro/refraction.hpp"
#include "vesper/gpu/objects.hpp"

#include <memory>

namespace vesper::gpu {

class RefractionTexture {
public:
  /// Copies the table if it is not the one copied last. A refraction without a table reads zeros.
  void update(const Refraction& refraction);

  /// Binds the texture (a sampler1D) to a unit.
  void bind(unsigned int unit) const;

private:
  Texture texture_;
  std::shared_ptr<const RefractionTable> table_;
};

} // namespace vesper::gpu
