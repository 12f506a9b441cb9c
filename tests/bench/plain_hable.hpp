// The pass against which others are measured: Hable's curve on each component and the sRGB transfer function, one read
// and one write a pixel. It reads an image, which costs Mesa's software driver a sixth less than a texture.
#pragma once

#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"

#include <epoxy/gl.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace vesper::bench {

class PlainHable {
public:
  explicit PlainHable(float exposure) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("vesper_plain_hable_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "plain_hable.comp") << text;
    try {
      program_ = gpu::build_program(gpu::ShaderLibrary(folder), {"plain_hable.comp"});
    } catch (...) {
      std::filesystem::remove_all(folder);
      throw;
    }
    std::filesystem::remove_all(folder);
    glProgramUniform1f(program_.name(), 0, exposure);
  }

  /// \param frame  rgba32f, X, Y, Z
  /// \param pixels rgba8 of the same size
  void run(const gpu::Texture& frame, const gpu::Texture& pixels, int width, int height) const {
    glUseProgram(program_.name());
    glBindImageTexture(1, frame.name(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
    glBindImageTexture(0, pixels.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    glDispatchCompute(static_cast<GLuint>(width + 15) / 16, static_cast<GLuint>(height + 15) / 16, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  }

private:
  static constexpr const char* text = R"(
#include "prelude.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 1, rgba32f) uniform readonly image2D frame;
layout(binding = 0) uniform writeonly image2D pixels;
layout(location = 0) uniform float exposure;

vec3 srgb_from_xyz(vec3 xyz) {
  return vec3(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
              -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
              0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z);
}

vec3 hable(vec3 x) { return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3; }

float encoded(float linear) {
  float v = clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(pixels)))) {
    return;
  }
  vec3 color = hable(2.0 * exposure * srgb_from_xyz(imageLoad(frame, at).xyz)) / hable(vec3(11.2));
  imageStore(pixels, at, vec4(encoded(color.x), encoded(color.y), encoded(color.z), 1.0));
}
)";

  gpu::ProgramHandle program_;
};

} // namespace vesper::bench
