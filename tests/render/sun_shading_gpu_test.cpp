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

/// The luminance of disc and corona at places in units of the Sun's radius.
std::vector<glm::vec4> luminance_on_gpu(const f32::SunShading& shading, const std::vector<glm::vec2>& places) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("vesper_sun_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "sun.comp") << R"(
#include "prelude.glsl"
#include "lib/sun.glsl"
layout(local_size_x = 64) in;
layout(std140, binding = 0) uniform Sun { SunShading sun; };
layout(std430, binding = 0) readonly buffer In { vec2 places[]; };
layout(std430, binding = 1) writeonly buffer Out { vec4 luminances[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < uint(places.length())) {
    float r = length(places[i]);
    luminances[i] = r <= 1.0 ? sun_disc_luminance(r, sun) : corona_luminance(places[i], sun);
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
  const gpu::Buffer in = gpu::make_static_buffer(std::as_bytes(std::span(places)));
  const gpu::Buffer out = gpu::make_dynamic_buffer(places.size() * sizeof(glm::vec4));
  glUseProgram(program.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, block.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.name());
  glDispatchCompute(static_cast<GLuint>((places.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<glm::vec4> luminances(places.size());
  glGetNamedBufferSubData(out.name(), 0, static_cast<GLsizeiptr>(luminances.size() * sizeof(glm::vec4)),
                          luminances.data());
  gpu::require_no_error("evaluating the Sun's luminance");
  return luminances;
}

TEST(SunShadingGpu, AgreesWithItsTwin) {
  const gpu::HeadlessContext context;
  const SkyState sky = sky_state(parse_instant("2026-08-12T18:29:30Z"), {42.34 * deg, -3.70 * deg, 860.0 * metre});
  // A spiral out to 70 radii.
  std::vector<glm::vec2> places;
  for (int i = 0; i < 4000; ++i) {
    const double turn = 2.4 * i;
    const double r = i < 2000 ? 1.2 * i / 2000.0 : 1.2 * std::exp(4.1 * (i - 2000) / 2000.0);
    places.emplace_back(r * std::cos(turn), r * std::sin(turn));
  }
  for (const LimbDarkening law : {LimbDarkening::neckel, LimbDarkening::hestroffer_magnan}) {
    SunOptions options;
    options.law = law;
    const f32::SunShading shading = in_single(sun_disc(sky, options).shading);
    const std::vector<glm::vec4> found = luminance_on_gpu(shading, places);
    float worst = 0.0F;
    int astray = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const float r = glm::length(places[i]);
      const f32::vec4 expected =
          r <= 1.0F ? f32::sun_disc_luminance(r, shading) : f32::corona_luminance(places[i], shading);
      for (int c = 0; c < 4; ++c) {
        const float off = std::abs(found[i][c] - expected[c]);
        // Rounding decides on which side of the limb a place lies; there it is a large part of mu.
        if (!(off <= 1.0e-3F * expected[c] + 1.0e-6F)) {
          ++astray;
        } else if (expected[c] > 0.0F) {
          worst = std::max(worst, off / expected[c]);
        }
      }
    }
    std::printf("the Sun's shading: worst relative difference %.1e, %d of %zu numbers at the limb\n",
                static_cast<double>(worst), astray, 4 * places.size());
    EXPECT_LE(astray, 8);
    EXPECT_LT(worst, 1.0e-3F);
  }
}

} // namespace
} // namespace vesper::test
