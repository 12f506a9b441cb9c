// Cost of the Moon pass against the same sphere and map under a law of cosines, both in one run and frame by frame in
// turn; and of a Moon a few pixels wide against one bright star.
#include "bench/timing.hpp"

#include "vesper/gpu/headless_context.hpp"
#include "vesper/gpu/renderer.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace vesper {
namespace {

/// The Moon of an instant in the middle of the picture.
struct MoonScene {
  SkyState sky;
  View view;
  FrameOptions options;

  MoonScene(const char* stamp, double fov_deg, int side)
      : sky(sky_state(parse_instant(stamp), {50.0 * deg, 10.0 * deg, 100.0 * metre})) {
    view.projection = Projection::perspective;
    view.fov = fov_deg * deg;
    view.azimuth = sky.moon.place.azimuth;
    view.altitude = sky.moon.place.altitude;
    view.width = view.height = side;
    options.layers.reset().set(static_cast<std::size_t>(Layer::moon));
  }
};

void moon_pass(benchmark::State& state, const char* stamp, double fov_deg, int side) {
  const gpu::HeadlessContext context;
  const gpu::ShaderLibrary shaders;
  gpu::Renderer renderer(shaders);
  const MoonScene scene(stamp, fov_deg, side);
  const FramePlan plan = plan_frame(scene.sky, scene.view, {}, scene.options);
  const auto ms = [&](gpu::MoonShading shading) {
    return bench::pass_ms(
        renderer.render(scene.sky, scene.view, plan, {.xyzs = false, .timings = true, .moon_shading = shading}),
        "moon");
  };
  // The first frame of each compiles its program.
  static_cast<void>(ms(gpu::MoonShading::surface));
  static_cast<void>(ms(gpu::MoonShading::lambert));
  std::vector<double> surface;
  std::vector<double> lambert;
  for (auto _ : state) {
    surface.push_back(ms(gpu::MoonShading::surface));
    lambert.push_back(ms(gpu::MoonShading::lambert));
  }
  state.SetLabel(context.description());
  state.counters["moon_ms"] = bench::median(surface);
  state.counters["lambert_ms"] = bench::median(lambert);
  state.counters["ratio"] = bench::median(surface) / bench::median(lambert);
}

BENCHMARK_CAPTURE(moon_pass, full, "2026-05-01T23:00:00Z", 0.6, 1024)->Iterations(30);
BENCHMARK_CAPTURE(moon_pass, crescent, "2026-05-19T20:00:00Z", 0.6, 1024)->Iterations(30);
BENCHMARK_CAPTURE(moon_pass, eclipsed, "2025-09-07T18:30:00Z", 0.6, 1024)->Iterations(30);
BENCHMARK_CAPTURE(moon_pass, narrow, "2026-05-01T23:00:00Z", 10.0, 1024)->Iterations(60);
BENCHMARK_CAPTURE(moon_pass, thin_crescent, "2026-05-18T12:00:00Z", 0.6, 1024)->Iterations(30);
BENCHMARK_CAPTURE(moon_pass, crescent_200px, "2026-05-19T20:00:00Z", 0.6, 226)->Iterations(60);
BENCHMARK_CAPTURE(moon_pass, thin_crescent_200px, "2026-05-18T12:00:00Z", 0.6, 226)->Iterations(60);
// The worst: the yardstick's pixels are not cut any more, and the crescent has as many places as a large one.
BENCHMARK_CAPTURE(moon_pass, thin_crescent_44px, "2026-05-18T12:00:00Z", 2.75, 226)->Iterations(200);
BENCHMARK_CAPTURE(moon_pass, thin_crescent_24px, "2026-05-18T12:00:00Z", 5.0, 226)->Iterations(200);
BENCHMARK_CAPTURE(moon_pass, thin_crescent_20px, "2026-05-18T12:00:00Z", 6.0, 226)->Iterations(200);

/// A Moon too narrow for a disc, and wider ones, against one star as bright as stars get.
void few_pixels(benchmark::State& state, double pixels) {
  const gpu::HeadlessContext context;
  const gpu::ShaderLibrary shaders;
  gpu::Renderer renderer(shaders);
  MoonScene scene("2026-05-01T23:00:00Z", 0.53 * 512.0 / pixels, 512);
  const FramePlan moon = plan_frame(scene.sky, scene.view, {}, scene.options);
  StarCatalogue catalogue;
  StarRecord star{};
  const Vec3 at = glm::transpose(scene.sky.stars.horizon_from_icrs) * scene.sky.moon.place.direction_horizon;
  star.position = {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
  star.illuminance = 1.0e-5F;
  star.color = {1.0F, 1.0F, 1.0F, 2.0F};
  catalogue.stars.push_back(star);
  catalogue.identities.resize(1);
  renderer.load(catalogue);
  scene.options.layers.reset().set(static_cast<std::size_t>(Layer::stars));
  const FramePlan one_star = plan_frame(scene.sky, scene.view, catalogue.stars, scene.options);
  const auto ms = [&](const FramePlan& plan, const char* pass) {
    return bench::pass_ms(renderer.render(scene.sky, scene.view, plan, {.xyzs = false, .timings = true}), pass);
  };
  // Apart from the passes, so that they find the processor as idle as each other.
  std::vector<double> plans;
  for (int i = 0; i < 20; ++i) {
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(plan_frame(scene.sky, scene.view, {}, moon.options, &moon));
    plans.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  static_cast<void>(ms(moon, "moon"));
  static_cast<void>(ms(one_star, "stars"));
  std::vector<double> moons;
  std::vector<double> stars;
  for (auto _ : state) {
    moons.push_back(ms(moon, "moon"));
    stars.push_back(ms(one_star, "stars"));
  }
  state.counters["moon_ms"] = bench::median(moons);
  state.counters["plan_ms"] = bench::median(plans);
  state.counters["star_ms"] = bench::median(stars);
  state.counters["ratio"] = bench::median(moons) / bench::median(stars);
}

BENCHMARK_CAPTURE(few_pixels, two, 2.0)->Iterations(60);
BENCHMARK_CAPTURE(few_pixels, four, 4.0)->Iterations(60);
BENCHMARK_CAPTURE(few_pixels, eight, 8.0)->Iterations(60);
BENCHMARK_CAPTURE(few_pixels, fifteen, 15.0)->Iterations(60);
BENCHMARK_CAPTURE(few_pixels, twenty, 20.0)->Iterations(60);

} // namespace
} // namespace vesper
