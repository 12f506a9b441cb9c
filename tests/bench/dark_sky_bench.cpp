// Cost of the dark sky beside the sky pass's: what is beyond the air is a draw, what is in it makes the sky's dearer.
// Frames with and without a dark sky are drawn in turn.
#include "bench/timing.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/gpu/headless_context.hpp"
#include "vesper/gpu/renderer.hpp"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

namespace vesper {
namespace {

void dark_sky_pass(benchmark::State& state, Projection projection, double fov_deg) {
  const gpu::HeadlessContext context;
  const gpu::ShaderLibrary shaders;
  gpu::Renderer renderer(shaders);
  View view;
  view.projection = projection;
  view.altitude = 30.0 * deg;
  view.fov = fov_deg * deg;
  view.width = view.height = 768;
  FrameOptions options;
  options.air.sky_tables = std::make_shared<const SkyTables>(make_sky_tables(clear_medium(), {2, 2, 2, 2}));
  // A crescent in a moonlit sky, so that there is a sky pass to compare with.
  const SkyState sky = sky_state(parse_instant("2026-08-16T19:30:00Z"), {28.3 * deg, -16.5 * deg, 2400.0 * metre});
  const FramePlan plan = plan_frame(sky, view, {}, options);
  for (const Layer layer : {Layer::milky_way, Layer::airglow, Layer::zodiacal, Layer::sky_glow}) {
    options.layers.reset(static_cast<std::size_t>(layer));
  }
  const FramePlan without = plan_frame(sky, view, {}, options);
  const auto draw = [&](const FramePlan& drawn) {
    return renderer.render(sky, view, drawn, {.xyzs = false, .timings = true});
  };
  static_cast<void>(draw(plan)); // compiles the programs
  static_cast<void>(draw(without));
  std::vector<double> beyond;
  std::vector<double> air;
  std::vector<double> alone;
  for (auto _ : state) {
    const gpu::Frame frame = draw(plan);
    alone.push_back(bench::pass_ms(draw(without), "sky"));
    beyond.push_back(bench::pass_ms(frame, "zodiacal"));
    air.push_back(bench::pass_ms(frame, "sky") - alone.back());
  }
  state.SetLabel(context.description());
  state.counters["beyond_ms"] = bench::median(beyond);
  state.counters["air_ms"] = bench::median(air);
  state.counters["sky_ms"] = bench::median(alone);
  state.counters["ratio"] = (bench::median(beyond) + bench::median(air)) / bench::median(alone);
}

BENCHMARK_CAPTURE(dark_sky_pass, whole_sky, Projection::fisheye, 180.0)->Iterations(25);
BENCHMARK_CAPTURE(dark_sky_pass, thirty_degrees, Projection::perspective, 30.0)->Iterations(25);

} // namespace
} // namespace vesper

BENCHMARK_MAIN();
