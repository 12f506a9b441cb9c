// Cost of glare and acuity at 1920 x 1080, and of the last pass with what they leave, over a plain Hable pass of one
// read and one write a pixel: all in one run and frame by frame in turn.
// Processor time: on a GPU the ratio says nothing.
#include "vesper/gpu/eye_optics.hpp"
#include "vesper/gpu/headless_context.hpp"

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <unistd.h>
#include <vector>

namespace vesper {
namespace {

constexpr int width = 1920;
constexpr int height = 1080;

/// Hable's curve and the sRGB transfer function; with EYE, of what the eye sees.
constexpr const char* hable = R"(
#include "prelude.glsl"
#include "lib/hash.glsl"
#include "lib/display.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0, rgba32f) uniform readonly image2D frame;
layout(binding = 1, rgba8) uniform writeonly image2D pixels;
layout(binding = 0) uniform sampler2D added;
layout(binding = 1) uniform sampler2D shares;

vec3 hable(vec3 x) { return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3; }

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(frame)))) {
    return;
  }
  vec4 light = imageLoad(frame, at);
#ifdef EYE
  vec2 place = (vec2(at) + 0.5) / (4.0 * vec2(textureSize(added, 0)));
  light = textureLod(shares, place, 0.0).x * light + textureLod(added, place, 0.0);
#endif
  vec3 color = hable(2.0 * srgb_from_xyz(light.xyz)) / hable(vec3(11.2));
  imageStore(pixels, at, vec4(srgb_encode(color.x), srgb_encode(color.y), srgb_encode(color.z), 1.0));
}
)";

std::vector<gpu::ProgramHandle> hable_programs() {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("vesper_eye_bench_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "hable.comp") << hable;
  std::vector<gpu::ProgramHandle> programs;
  programs.push_back(gpu::build_program(gpu::ShaderLibrary(folder), {"hable.comp"}));
  programs.push_back(gpu::build_program(gpu::ShaderLibrary(folder), {"hable.comp"}, {"EYE"}));
  std::filesystem::remove_all(folder);
  return programs;
}

/// Time of all processors together, which is what a software rasteriser costs.
double ms_of(const std::function<void()>& work) {
  gpu::finish();
  const std::clock_t start = std::clock();
  work();
  gpu::finish();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void eye_optics(benchmark::State& state, bool glare, bool acuity, bool has_points) {
  const gpu::HeadlessContext context;
  const gpu::ShaderLibrary shaders;
  gpu::EyeOptics eye(shaders);
  View view;
  view.projection = Projection::perspective;
  view.fov = 60.0 * deg;
  view.width = width;
  view.height = height;
  // A dark sky with a Moon in it.
  std::vector<float> light(static_cast<std::size_t>(4 * width * height), 3.0e-4F);
  for (int row = 300; row < 309; ++row) {
    std::fill_n(light.begin() + 4 * (std::ptrdiff_t{row} * width + 500), 36, 2500.0F);
  }
  const gpu::Texture frame = gpu::make_texture(width, height, gpu::PixelFormat::rgba32f);
  const gpu::Texture points = gpu::make_texture(width, height, gpu::PixelFormat::rgba32f);
  const gpu::Texture pixels = gpu::make_texture(width, height, gpu::PixelFormat::rgba8);
  glTextureSubImage2D(frame.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, light.data());
  const std::vector<float> none(light.size(), 0.0F);
  glTextureSubImage2D(points.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, none.data());
  const std::vector<gpu::ProgramHandle> programs = hable_programs();
  const auto see = [&] { eye.see(frame, has_points ? &points : nullptr, view, {.glare = glare, .acuity = acuity}); };
  const auto map = [&](const gpu::ProgramHandle& program) {
    glUseProgram(program.name());
    glBindImageTexture(0, frame.name(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
    glBindImageTexture(1, pixels.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    glBindTextureUnit(0, eye.added().name());
    glBindTextureUnit(1, eye.shares().name());
    glDispatchCompute((width + 15) / 16, (height + 15) / 16, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  };
  see();
  map(programs[0]);
  map(programs[1]);
  std::vector<double> seeing;
  std::vector<double> mapping;
  std::vector<double> plain;
  std::vector<double> ratio;
  for (auto _ : state) {
    seeing.push_back(ms_of(see));
    mapping.push_back(ms_of([&] { map(programs[1]); }));
    plain.push_back(ms_of([&] { map(programs[0]); }));
    ratio.push_back((seeing.back() + mapping.back()) / plain.back());
  }
  state.SetLabel(context.description());
  state.counters["eye_ms"] = median(seeing);
  state.counters["map_ms"] = median(mapping);
  state.counters["hable_ms"] = median(plain);
  state.counters["ratio"] = median(ratio);
}

BENCHMARK_CAPTURE(eye_optics, glare_and_acuity, true, true, false)->Iterations(25);
BENCHMARK_CAPTURE(eye_optics, with_points, true, true, true)->Iterations(25);
BENCHMARK_CAPTURE(eye_optics, glare, true, false, false)->Iterations(25);
BENCHMARK_CAPTURE(eye_optics, acuity, false, true, false)->Iterations(25);

} // namespace
} // namespace vesper

BENCHMARK_MAIN();
