#include "render/shader_harness.hpp"

#include "vesper/gpu/extinction_texture.hpp"
#include "vesper/gpu/refraction_texture.hpp"

#include <epoxy/gl.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <span>
#include <unistd.h>

namespace vesper::test {

std::vector<glm::vec4> evaluate_on_gpu(const std::string& expression, const Inputs& inputs,
                                       const Refraction& refraction, const FramePlan& plan) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("vesper_harness_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "harness.comp") << R"(
#include "prelude.glsl"
#include "lib/hash.glsl"
#include "lib/star_place.glsl"
#include "lib/cube_map.glsl"
#include "lib/projection.glsl"
#include "lib/star_psf.glsl"
#include "lib/refraction.glsl"
#include "lib/extinction.glsl"
#include "lib/disc.glsl"
#include "lib/scintillation.glsl"
#include "lib/eclipse.glsl"
#include "lib/moon_shadow.glsl"
#include "lib/moon_surface.glsl"
#include "lib/lunar_eclipse.glsl"
#include "lib/visibility.glsl"
#include "lib/mesopic.glsl"
#include "lib/vision.glsl"
#include "lib/tone.glsl"
#include "lib/display.glsl"
#include "lib/phase.glsl"
#include "lib/sky_table.glsl"
#include "lib/sky_to_point.glsl"
#include "lib/sun.glsl"
#include "lib/dark_sky.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler1D table; // of refraction
layout(binding = 1) uniform sampler2D extinction_table;
layout(std430, binding = 0) readonly buffer In { vec4 inputs[]; };
layout(std430, binding = 1) writeonly buffer Out { vec4 outputs[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(inputs.length())) { return; }
  vec4 v = inputs[i];
  outputs[i] = )" << expression << ";\n}\n";
  gpu::ProgramHandle program;
  try {
    program = gpu::build_program(gpu::ShaderLibrary(folder), {"harness.comp"});
  } catch (...) {
    std::filesystem::remove_all(folder);
    throw;
  }
  std::filesystem::remove_all(folder);

  const gpu::Buffer in = gpu::make_static_buffer(std::as_bytes(std::span(inputs)));
  const gpu::Buffer out = gpu::make_dynamic_buffer(inputs.size() * sizeof(glm::vec4));
  gpu::RefractionTexture table;
  table.update(refraction);
  table.bind(0);
  gpu::ExtinctionTexture extinction;
  extinction.update(plan.extinction);
  extinction.bind(1);
  glUseProgram(program.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.name());
  glDispatchCompute(static_cast<GLuint>((inputs.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<glm::vec4> results(inputs.size());
  glGetNamedBufferSubData(out.name(), 0, static_cast<GLsizeiptr>(results.size() * sizeof(glm::vec4)), results.data());
  gpu::require_no_error("evaluating a shader function");
  return results;
}

Inputs grid(const glm::vec4& low, const glm::vec4& high, int steps) {
  Inputs points;
  const auto count = [&](int axis) { return low[axis] == high[axis] ? 1 : steps; };
  const auto at = [&](int axis, int i) {
    return count(axis) == 1
               ? low[axis]
               : low[axis] + (high[axis] - low[axis]) * static_cast<float>(i) / static_cast<float>(steps - 1);
  };
  for (int a = 0; a < count(0); ++a) {
    for (int b = 0; b < count(1); ++b) {
      for (int c = 0; c < count(2); ++c) {
        for (int d = 0; d < count(3); ++d) {
          points.emplace_back(at(0, a), at(1, b), at(2, c), at(3, d));
        }
      }
    }
  }
  return points;
}

void expect_twins(const std::vector<FunctionCase>& functions) {
  for (const FunctionCase& function : functions) {
    SCOPED_TRACE(function.name);
    const Inputs inputs = grid(function.low, function.high, function.steps);
    const std::vector<glm::vec4> results = evaluate_on_gpu(function.glsl, inputs);
    std::vector<glm::vec4> expected;
    float largest = 0.0F;
    for (const glm::vec4& input : inputs) {
      expected.push_back(function.cpp(input));
      for (int c = 0; c < 4; ++c) {
        largest = std::max(largest, std::abs(expected.back()[c]));
      }
    }
    ASSERT_GT(largest, 0.0F);
    float worst = 0.0F;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (int c = 0; c < 4; ++c) {
        const float scale = std::max(std::abs(expected[i][c]), 1.0e-3F * largest);
        const float error = std::abs(results[i][c] - expected[i][c]) / scale;
        ASSERT_TRUE(std::isfinite(results[i][c])) << "input " << i;
        worst = std::max(worst, error);
      }
    }
    std::printf("%-38s worst relative difference %.1e over %zu points\n", function.name.c_str(),
                static_cast<double>(worst), inputs.size());
    EXPECT_LE(worst, function.tolerance);
  }
}

} // namespace vesper::test
