// Cost of the display chain, metering included, against a plain pass of Hable's curve with one read and one write a
// pixel: both in one run and frame by frame in turn.
#include "vesper/gpu/display_chain.hpp"
#include "vesper/gpu/headless_context.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
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

gpu::ProgramHandle hable_program() {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("vesper_display_bench_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "plain_hable.comp") << R"(
#include "prelude.glsl"
#include "lib/hash.glsl"
#include "lib/visibility.glsl"
#include "lib/mesopic.glsl"
#include "lib/tone.glsl"
#include "lib/display.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D frame;
layout(binding = 0) uniform writeonly image2D pixels;
layout(location = 0) uniform float exposure;
void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(pixels)))) { return; }
  vec3 rgb = exposure * srgb_from_xyz(texelFetch(frame, at, 0).xyz);
  imageStore(pixels, at, vec4(srgb_encode(hable_curve(rgb.x)), srgb_encode(hable_curve(rgb.y)),
                              srgb_encode(hable_curve(rgb.z)), 1.0));
}
)";
  gpu::ProgramHandle program;
  try {
    program = gpu::build_program(gpu::ShaderLibrary(folder), {"plain_hable.comp"});
  } catch (...) {
    std::filesystem::remove_all(folder);
    throw;
  }
  std::filesystem::remove_all(folder);
  return program;
}

double milliseconds(const std::function<void()>& work) {
  gpu::finish();
  const auto start = std::chrono::steady_clock::now();
  work();
  gpu::finish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// A sky of a luminance at the zenith, with a star in one pixel of 400.
void measure(benchmark::State& state, double luminance) {
  const gpu::HeadlessContext context;
  const gpu::ShaderLibrary shaders;
  View view;
  view.projection = Projection::perspective;
  view.fov = 60.0 * deg;
  view.width = width;
  view.height = height;
  std::vector<float> light;
  std::vector<float> stars;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double y = luminance * std::exp(2.0 * row / height);
      const bool star = column % 20 < 3 && row % 60 < 3;
      const double point = star ? luminance : 0.0;
      for (const double part : {0.9, 1.0, 1.3, 2.2}) {
        light.push_back(static_cast<float>(part * (y + point)));
        stars.push_back(static_cast<float>(part * point));
      }
    }
  }
  const gpu::Texture frame = gpu::make_table_texture(width, light);
  const gpu::Texture points = gpu::make_table_texture(width, stars);
  const gpu::Texture pixels = gpu::make_texture(width, height, gpu::PixelFormat::rgba8);
  const gpu::ProgramHandle hable = hable_program();
  glProgramUniform1f(hable.name(), 0, static_cast<float>(0.2 / luminance));
  gpu::DisplayChain chain(shaders);
  const gpu::StripLight strip{frame, points, {0, height}};
  const auto plain = [&] {
    glUseProgram(hable.name());
    glBindTextureUnit(0, frame.name());
    glBindImageTexture(0, pixels.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    glDispatchCompute((width + 15) / 16, (height + 15) / 16, 1);
  };
  const auto look = [&] {
    chain.start(view);
    chain.look(strip);
  };
  plain();
  look();
  chain.map(strip, pixels);
  std::vector<double> plains;
  std::vector<double> looks;
  std::vector<double> maps;
  for ([[maybe_unused]] auto step : state) {
    plains.push_back(milliseconds(plain));
    looks.push_back(milliseconds(look));
    maps.push_back(milliseconds([&] { chain.map(strip, pixels); }));
  }
  state.counters["hable_ms"] = median(plains);
  state.counters["look_ms"] = median(looks);
  state.counters["curve_and_map_ms"] = median(maps);
  state.counters["ratio"] = (median(looks) + median(maps)) / median(plains);
}

void day(benchmark::State& state) { measure(state, 3.0e3); }
void night(benchmark::State& state) { measure(state, 3.0e-4); }
BENCHMARK(day)->Iterations(15)->Unit(benchmark::kMillisecond);
BENCHMARK(night)->Iterations(15)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace vesper
