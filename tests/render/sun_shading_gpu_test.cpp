// The Sun on the GPU, from its shading in a uniform block, against the same text compiled as C++ in single precision.
#include "vesper/gpu/headless_context.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/shader_library.hpp"
#include "vesper/sky/sun_disc.hpp"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <span>
#include <unistd.h>
#include <vector>

namespace vesper::test {
namespace {

/// The Sun's luminance in directions.
std::vector<glm::vec4> luminance_on_gpu(const f32::SunShading& shading, const std::vector<glm::vec4>& directions) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("vesper_sun_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "sun.comp") << R"(
#include "prelude.glsl"
#include "lib/sun.glsl"
layout(local_size_x = 64) in;
layout(std140, binding = 0) uniform Sun { SunShading sun; };
layout(std430, binding = 0) readonly buffer In { vec4 directions[]; };
layout(std430, binding = 1) writeonly buffer Out { vec4 luminances[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < uint(directions.length())) {
    luminances[i] = sun_luminance(directions[i].xyz, sun);
  }
}
)";
  gpu::ProgramHandle program;
  try {
    program = gpu::build_program(gpu::ShaderLibrary(folder), {"sun.comp"});
  } catch (...) {
    std::filesystem::remove_all(folder);
    throw;
  }
  std::filesystem::remove_all(folder);
  const gpu::Buffer block = gpu::make_static_buffer(std::as_bytes(std::span(&shading, 1)));
  const gpu::Buffer in = gpu::make_static_buffer(std::as_bytes(std::span(directions)));
  const gpu::Buffer out = gpu::make_dynamic_buffer(directions.size() * sizeof(glm::vec4));
  glUseProgram(program.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, block.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.name());
  glDispatchCompute(static_cast<GLuint>((directions.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<glm::vec4> luminances(directions.size());
  glGetNamedBufferSubData(out.name(), 0, static_cast<GLsizeiptr>(luminances.size() * sizeof(glm::vec4)),
                          luminances.data());
  gpu::require_no_error("evaluating the Sun's luminance");
  return luminances;
}

TEST(SunShadingGpu, AgreesWithItsTwin) {
  const gpu::HeadlessContext context;
  // A crescent, totality and the whole Sun.
  const Observer burgos{42.34 * deg, -3.70 * deg, 860.0 * metre};
  for (const char* time : {"2026-08-12T18:20:00Z", "2026-08-12T18:29:30Z", "2026-02-12T12:00:00Z"}) {
    for (const LimbDarkening law : {LimbDarkening::neckel, LimbDarkening::hestroffer_magnan}) {
      SunOptions options;
      options.law = law;
      const SunDisc sun = sun_disc(sky_state(parse_instant(time), burgos), options);
      const f32::SunShading shading = in_single(sun.shading);
      // Spirals out to 70 radii, and a few directions all around.
      std::vector<glm::vec4> directions;
      for (int i = 0; i < 4000; ++i) {
        const double turn = 2.4 * i;
        const double r = i < 2000 ? 1.2 * i / 2000.0 : 1.2 * std::exp(4.1 * (i - 2000) / 2000.0);
        const Vec3 aside = std::cos(turn) * sun.shading.aside + std::sin(turn) * sun.shading.upward;
        directions.emplace_back(glm::normalize(sun.direction + r * sun.shading.sin_radius * aside), 0.0);
      }
      for (const Vec3& far : {-sun.direction, sun.shading.aside, sun.shading.moon_direction, Vec3(0, 0, 1)}) {
        directions.emplace_back(far, 0.0);
      }
      const std::vector<glm::vec4> found = luminance_on_gpu(shading, directions);
      float worst = 0.0F;
      int astray = 0;
      int bright = 0;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const f32::vec4 expected = f32::sun_luminance(f32::vec3(directions[i]), shading);
        bright += expected.y > 1.0e5F ? 1 : 0;
        for (int c = 0; c < 4; ++c) {
          const float off = std::abs(found[i][c] - expected[c]);
          // At an edge rounding decides on which side a direction lies; at the limb it is a large part of mu.
          if (!(off <= 1.0e-3F * expected[c] + 1.0e-6F)) {
            ++astray;
          } else if (expected[c] > 0.0F) {
            worst = std::max(worst, off / expected[c]);
          }
        }
      }
      std::printf("%s: worst relative difference %.1e, %d of %zu numbers at edges, %d directions on the disc\n", time,
                  static_cast<double>(worst), astray, 4 * directions.size(), bright);
      EXPECT_LE(astray, 16);
      EXPECT_LT(worst, 1.0e-3F);
    }
  }
}

} // namespace
} // namespace vesper::test
