// Cost of the star pass against the same billboards in one colour, both in one run and frame by frame in turn.
#include "bench/timing.hpp"

#include "vesper/assets/default_stars.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/star_extinction_table.hpp"
#include "vesper/gpu/headless_context.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/renderer.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace vesper {
namespace {

/// Wall-clock milliseconds of the pass alone, as the frame graph times it.
double star_pass_ms(gpu::Renderer& renderer, const SkyState& sky, const View& view, const FramePlan& plan,
                    gpu::StarShading shading) {
  return bench::pass_ms(renderer.render(sky, view, plan, {.xyzs = false, .timings = true, .star_shading = shading}),
                        "stars");
}

void star_pass(benchmark::State& state, Projection projection, double fov_deg, int width, int height) {
  const gpu::HeadlessContext context;
  const gpu::ShaderLibrary shaders;
  gpu::Renderer renderer(shaders);
  const StarCatalogue& catalogue = default_star_catalogue();
  renderer.load(catalogue);
  const SkyState sky = sky_state(parse_instant("2026-11-22T22:00:00Z"), {51.4769 * deg, 0.0 * deg, 47.0 * metre});
  View view;
  view.projection = projection;
  view.fov = fov_deg * deg;
  view.altitude = projection == Projection::perspective ? 40.0 * deg : 90.0 * deg;
  view.width = width;
  view.height = height;
  const FramePlan plan = plan_frame(sky, view, catalogue.stars);
  std::vector<double> psf;
  std::vector<double> flat;
  // The first frame of each compiles its program.
  static_cast<void>(star_pass_ms(renderer, sky, view, plan, gpu::StarShading::psf));
  static_cast<void>(star_pass_ms(renderer, sky, view, plan, gpu::StarShading::constant_color));
  for (auto _ : state) {
    psf.push_back(star_pass_ms(renderer, sky, view, plan, gpu::StarShading::psf));
    flat.push_back(star_pass_ms(renderer, sky, view, plan, gpu::StarShading::constant_color));
  }
  state.SetLabel(context.description());
  state.counters["stars_ms"] = bench::median(psf);
  state.counters["constant_color_ms"] = bench::median(flat);
  state.counters["ratio"] = bench::median(psf) / bench::median(flat);
}

BENCHMARK_CAPTURE(star_pass, fisheye_1024, Projection::fisheye, 180.0, 1024, 1024)->Iterations(40);
BENCHMARK_CAPTURE(star_pass, fisheye_4096, Projection::fisheye, 180.0, 4096, 4096)->Iterations(12);
BENCHMARK_CAPTURE(star_pass, perspective_1080p, Projection::perspective, 60.0, 1920, 1080)->Iterations(40);
BENCHMARK_CAPTURE(star_pass, stereographic_1024, Projection::stereographic, 180.0, 1024, 1024)->Iterations(40);
BENCHMARK_CAPTURE(star_pass, equirectangular_2048, Projection::equirectangular, 180.0, 2048, 1024)->Iterations(40);
BENCHMARK_CAPTURE(star_pass, cubemap_512, Projection::cubemap, 180.0, 512, 3072)->Iterations(40);

/// What a sky costs on the CPU before anything is drawn.
void sky_of_an_instant(benchmark::State& state) {
  const Observer observer{51.4769 * deg, 0.0 * deg, 47.0 * metre};
  Instant instant = parse_instant("2026-11-22T22:00:00Z");
  for (auto _ : state) {
    instant = later(instant, 0.1);
    benchmark::DoNotOptimize(sky_state(instant, observer));
  }
}
BENCHMARK(sky_of_an_instant);

/// What it costs when the medium or the observer's height changes.
void table_of_star_extinction(benchmark::State& state) {
  const Medium medium = clear_medium();
  const RefractionConditions conditions = standard_conditions(47.0 * metre);
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_star_extinction(medium, 47.0 * metre, conditions));
  }
}
BENCHMARK(table_of_star_extinction)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace vesper
