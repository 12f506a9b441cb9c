#include "vesper/gpu/sky_net.hpp"

#include <epoxy/gl.h>

namespace vesper::gpu {

void run_over_map(const ProgramHandle& program, const Texture& map, const SkyMapSize& size, const SkyNet& net) {
  glUseProgram(program.name());
  glProgramUniform2i(program.name(), 0, size.rows_below, size.rows_above);
  glProgramUniform2i(program.name(), 1, net.rows_below, net.rows_above);
  glBindTextureUnit(0, net.texels.name());
  glBindImageTexture(0, map.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  constexpr int group = 8;
  const auto groups = [](int count) { return static_cast<GLuint>((count + group - 1) / group); };
  glDispatchCompute(groups(size.columns), groups(size.rows_below + size.rows_above), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace vesper::gpu
