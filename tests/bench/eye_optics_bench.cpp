// Cost of glare and acuity at 1920 x 1080 over a plain Hable pass of one read and one write a pixel: both in one run
// and frame by frame in turn.
#include "bench/plain_hable.hpp"
#include "bench/timing.hpp"

#include "vesper/gpu/eye_optics.hpp"
#include "vesper/gpu/headless_context.hpp"

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vesper {
namespace {

constexpr int width = 1920;
constexpr int height = 1080;

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
  const gpu::Texture frame = gpu::make_table_texture(width, light);
  const gpu::Texture points = gpu::make_table_texture(width, std::vector<float>(light.size(), 0.0F));
  const gpu::Texture pixels = gpu::make_texture(width, height, gpu::PixelFormat::rgba8);
  const bench::PlainHable hable(1.0F);
  gpu::PointTiles tiles(shaders);
  tiles.start(width, height);
  tiles.list({0, height});
  const auto see = [&] {
    const gpu::EyeOpticsSettings settings{.glare = glare, .acuity = acuity};
    if (!has_points) {
      eye.see(frame, view, settings);
      return;
    }
    eye.start(view, settings, true);
    eye.add({frame, points, tiles, {0, height}});
    eye.finish();
  };
  const auto plain = [&] { hable.run(frame, pixels, width, height); };
  see();
  plain();
  std::vector<double> seeing;
  std::vector<double> plains;
  std::vector<double> ratio;
  for (auto _ : state) {
    seeing.push_back(bench::processor_ms(see));
    plains.push_back(bench::processor_ms(plain));
    ratio.push_back(seeing.back() / plains.back());
  }
  state.SetLabel(context.description());
  state.counters["eye_ms"] = bench::median(seeing);
  state.counters["hable_ms"] = bench::median(plains);
  state.counters["ratio"] = bench::median(ratio);
}

BENCHMARK_CAPTURE(eye_optics, glare_and_acuity, true, true, false)->Iterations(25);
BENCHMARK_CAPTURE(eye_optics, with_points, true, true, true)->Iterations(25);
BENCHMARK_CAPTURE(eye_optics, glare, true, false, false)->Iterations(25);
BENCHMARK_CAPTURE(eye_optics, acuity, false, true, false)->Iterations(25);

} // namespace
} // namespace vesper

BENCHMARK_MAIN();
