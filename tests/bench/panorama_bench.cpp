// The cost of spreading a picture of the sky over a cube, without reading and writing.
#include "support/sky_picture.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace vesper;

/// range(0): pixels across, range(1): texels along a face.
void spread(benchmark::State& state) {
  const int width = static_cast<int>(state.range(0));
  const test::SkyHeader header{"CAR", "GLON", "GLAT", width, width / 2, 360.0 / width, 0.0, 0.0, ""};
  test::MadePicture picture = header.picture(3);
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(make_panorama(picture, header.wcs(), "made.fits", "HDU 1",
                                           test::plain_options(3, static_cast<int>(state.range(1)))));
  }
  state.counters["Mpixel"] = static_cast<double>(width) * width / 2e6;
}

} // namespace

BENCHMARK(spread)
    ->Args({900, 256})
    ->Args({1800, 512})
    ->Args({3600, 1024})
    ->Args({7200, 1024})
    ->Unit(benchmark::kMillisecond);
