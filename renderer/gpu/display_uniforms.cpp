#include "vesper/gpu/display_uniforms.hpp"

#include <epoxy/gl.h>

namespace vesper::gpu {

void set_display(const ProgramHandle& program, int first_location, const f64::DisplayModel& display) {
  const f32::mat3 rgb_from_xyz(display.rgb_from_xyz);
  glProgramUniformMatrix3fv(program.name(), first_location, 1, GL_FALSE, &rgb_from_xyz[0][0]);
  glProgramUniform1i(program.name(), first_location + 1, display.transfer);
  GLint location = first_location + 2;
  for (const double number : {display.gamma, display.black_cd_m2, display.range_cd_m2, display.ambient_cd_m2,
                              display.cross_reflection, display.pixel_sr}) {
    glProgramUniform1f(program.name(), location++, static_cast<float>(number));
  }
}

} // namespace vesper::gpu
