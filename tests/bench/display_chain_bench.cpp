// Cost of the display chain at 1920 x 1080, metering included, against a plain pass of Hable's curve with one read and
// one write a pixel: both in one run and frame by frame in turn.
#include "bench/plain_hable.hpp"
#include "bench/timing.hpp"

#include "vesper/gpu/display_chain.hpp"
#include "vesper/gpu/headless_context.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace vesper {
namespace {

constexpr int width = 1920;
constexpr int height = 1080;

/// A sky of a luminance in its darkest row, with a star of 3 x 3 pixels in every 20 x 60.
void display_chain(benchmark::State& state, double luminance, const gpu::DisplaySettings& settings) {
  const gpu::HeadlessContext context;
  const gpu::ShaderLibrary shaders;
  View view;
  view.projection = Projection::perspective;
  view.fov = 60.0 * deg;
  view.width = width;
  view.height = height;
  std::vector<float> light;
  std::vector<float> stars;
  std::vector<gpu::PointTiles::Box> boxes;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double y = luminance * std::exp(2.0 * row / height);
      const bool star = column % 20 < 3 && row % 60 < 3;
      const double point = star ? luminance : 0.0;
      if (column % 20 == 0 && row % 60 == 0) {
        boxes.push_back({static_cast<float>(column), static_cast<float>(row), static_cast<float>(column + 3),
                         static_cast<float>(row + 3)});
      }
      for (const double part : {0.9, 1.0, 1.3, 2.2}) {
        light.push_back(static_cast<float>(part * (y + point)));
        stars.push_back(static_cast<float>(part * point));
      }
    }
  }
  const gpu::Texture frame = gpu::make_table_texture(width, light);
  const gpu::Texture points = gpu::make_table_texture(width, stars);
  const gpu::Texture pixels = gpu::make_texture(width, height, settings.format);
  const gpu::Texture plain_pixels = gpu::make_texture(width, height, gpu::PixelFormat::rgba8);
  const bench::PlainHable hable(static_cast<float>(0.2 / luminance));
  gpu::DisplayChain chain(shaders, settings);
  gpu::PointTiles tiles(shaders);
  const gpu::StripLight strip{frame, points, tiles, {0, height}};
  const auto plain = [&] { hable.run(frame, plain_pixels, width, height); };
  const auto look = [&] {
    tiles.start(width, height);
    tiles.mark(boxes);
    tiles.list({0, height});
    chain.start(view);
    chain.look(strip);
  };
  const auto map = [&] { chain.map(strip, pixels); };
  plain();
  look();
  map();
  std::vector<double> plains;
  std::vector<double> looks;
  std::vector<double> maps;
  std::vector<double> ratios;
  for ([[maybe_unused]] auto step : state) {
    plains.push_back(bench::processor_ms(plain));
    looks.push_back(bench::processor_ms(look));
    maps.push_back(bench::processor_ms(map));
    ratios.push_back((looks.back() + maps.back()) / plains.back());
  }
  state.SetLabel(context.description());
  state.counters["hable_ms"] = bench::median(plains);
  state.counters["look_ms"] = bench::median(looks);
  state.counters["map_ms"] = bench::median(maps);
  state.counters["ratio"] = bench::median(ratios);
}

constexpr double noon = 3.0e3;
constexpr double night = 3.0e-4;

gpu::DisplaySettings without_optics() {
  gpu::DisplaySettings settings;
  settings.optics.glare = settings.optics.acuity = false;
  return settings;
}

gpu::DisplaySettings with_grain() {
  gpu::DisplaySettings settings;
  settings.noise = true;
  return settings;
}

BENCHMARK_CAPTURE(display_chain, day, noon, {})->Iterations(25);
BENCHMARK_CAPTURE(display_chain, night, night, {})->Iterations(25);
BENCHMARK_CAPTURE(display_chain, day_without_glare_and_acuity, noon, without_optics())->Iterations(25);
BENCHMARK_CAPTURE(display_chain, night_without_glare_and_acuity, night, without_optics())->Iterations(25);
BENCHMARK_CAPTURE(display_chain, night_with_grain, night, with_grain())->Iterations(9);

} // namespace
} // namespace vesper
