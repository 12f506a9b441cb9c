// Cost of the sky pass with Sun and Moon, its map's computation included, against a pass of four trilinear look-ups a
// pixel in a 32-bit float 3-D texture of the size of a sky table: both in one run and frame by frame in turn.
#include "bench/timing.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/sky_tables.hpp"
#include "vesper/gpu/headless_context.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/renderer.hpp"

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace vesper {
namespace {

constexpr int width = 1920;
constexpr int height = 1080;

/// Tables of the default size whose contents do not matter for the cost.
std::shared_ptr<const SkyTables> tables_of_default_size() {
  static const auto tables = [] {
    SkyTables made = make_sky_tables(published_medium(), {2, 2, 2, 2});
    const SkyTableSize size;
    made.frame.heights = size.heights;
    made.frame.views_below = size.views_below;
    made.frame.views_above = size.views_above;
    made.frame.lights = size.lights;
    const auto texels = static_cast<std::size_t>(size.heights) * static_cast<std::size_t>(size.lights) *
                        static_cast<std::size_t>(size.views_below + size.views_above) * f32::sky_azimuths;
    made.other.assign(texels, f32::vec4(-5.0F));
    made.aerosol.assign(texels, f32::vec4(-7.0F));
    made.ground.assign(static_cast<std::size_t>(size.lights), f32::vec4(-4.0F));
    return std::make_shared<const SkyTables>(std::move(made));
  }();
  return tables;
}

/// A full Moon in the south and the Sun in dusk; or high above the ground.
SkyState sky_at(Length observer_height) {
  SkyState sky;
  sky.observer.height = observer_height;
  sky.sun.direction_horizon = {-std::cos(0.05), 0.0, -std::sin(0.05)};
  sky.sun.distance = 1.0 * astronomical_unit;
  sky.sun.direction_equatorial = sky.sun.direction_horizon;
  sky.moon.place.direction_horizon = {0.0, -std::cos(0.6), std::sin(0.6)};
  sky.moon.place.direction_equatorial = sky.moon.place.direction_horizon;
  sky.moon.place.distance = 384400.0 * kilometre;
  return sky;
}

/// Four look-ups a pixel, at places that move through the texture as those of neighbouring pixels do.
gpu::ProgramHandle yardstick_program() {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("vesper_sky_bench_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "yardstick.frag") << R"(
layout(binding = 0) uniform sampler3D table;
layout(location = 0) out vec4 luminance;
void main() {
  vec3 at = vec3(0.9 * gl_FragCoord.xy / vec2(1920.0, 1080.0), 0.3);
  luminance = texture(table, at) + texture(table, at.yxz) + texture(table, at + vec3(0.1)) +
              texture(table, at.yxz + vec3(0.1));
}
)";
  gpu::ProgramHandle program;
  try {
    program = gpu::build_program(gpu::ShaderLibrary(folder), {"fullscreen.vert", "yardstick.frag"});
  } catch (...) {
    std::filesystem::remove_all(folder);
    throw;
  }
  std::filesystem::remove_all(folder);
  return program;
}

class Yardstick {
public:
  explicit Yardstick(const SkyTables& tables) : program_(yardstick_program()), vertices_(gpu::make_vertex_array()) {
    const f32::sampler3D size = sampler(tables, tables.other);
    table_ = gpu::make_volume_texture(size.width, size.height, size.depth);
    glTextureSubImage3D(table_.name(), 0, 0, 0, 0, size.width, size.height, size.depth, GL_RGBA, GL_FLOAT,
                        tables.other.data());
    gpu::interpolate(table_);
    frame_ = gpu::make_texture(width, height, gpu::PixelFormat::rgba32f);
    framebuffer_ = gpu::make_framebuffer(frame_);
  }

  double ms() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width, height);
    gpu::finish();
    const auto start = std::chrono::steady_clock::now();
    glBindTextureUnit(0, table_.name());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram(program_.name());
    glBindVertexArray(vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    gpu::finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }

private:
  gpu::ProgramHandle program_;
  gpu::VertexArray vertices_;
  gpu::Texture table_;
  gpu::Texture frame_;
  gpu::Framebuffer framebuffer_;
};

struct PassTime {
  double map_ms = 0.0;
  double draw_ms = 0.0;
};

PassTime sky_time(gpu::Renderer& renderer, const SkyState& sky, const View& view, const FramePlan& plan) {
  const gpu::Frame frame = renderer.render(sky, view, plan, {.xyzs = false, .timings = true});
  return {bench::pass_ms(frame, "sky map"), bench::pass_ms(frame, "sky")};
}

void sky_pass(benchmark::State& state, Projection projection, double height_km) {
  const gpu::HeadlessContext context;
  const gpu::ShaderLibrary shaders;
  gpu::Renderer renderer(shaders);
  FrameOptions options;
  options.layers.reset().set(static_cast<std::size_t>(Layer::sky)).set(static_cast<std::size_t>(Layer::ground));
  options.air.extinction = false;
  options.air.refraction = false;
  options.air.sky_tables = tables_of_default_size();
  View view;
  view.projection = projection;
  view.altitude = 20.0 * deg;
  view.fov = projection == Projection::perspective ? 60.0 * deg : 180.0 * deg;
  view.width = width;
  view.height = height;
  const SkyState sky = sky_at(height_km * kilometre);
  const FramePlan plan = plan_frame(sky, view, {}, options);
  const Yardstick yardstick(*options.air.sky_tables);
  static_cast<void>(sky_time(renderer, sky, view, plan)); // compiles the programs
  static_cast<void>(yardstick.ms());
  std::vector<double> map;
  std::vector<double> draw;
  std::vector<double> lookups;
  std::vector<double> ratio;
  for (auto _ : state) {
    const PassTime time = sky_time(renderer, sky, view, plan);
    map.push_back(time.map_ms);
    draw.push_back(time.draw_ms);
    lookups.push_back(yardstick.ms());
    ratio.push_back((time.map_ms + time.draw_ms) / lookups.back());
  }
  state.SetLabel(context.description());
  state.counters["lights"] = static_cast<double>(plan.lights.size());
  state.counters["map_ms"] = bench::median(map);
  state.counters["draw_ms"] = bench::median(draw);
  state.counters["four_lookups_ms"] = bench::median(lookups);
  state.counters["ratio"] = bench::median(ratio);
}

BENCHMARK_CAPTURE(sky_pass, perspective, Projection::perspective, 0.05)->Iterations(25);
BENCHMARK_CAPTURE(sky_pass, stereographic, Projection::stereographic, 0.05)->Iterations(25);
BENCHMARK_CAPTURE(sky_pass, equirectangular, Projection::equirectangular, 0.05)->Iterations(25);
BENCHMARK_CAPTURE(sky_pass, from_space, Projection::perspective, 400.0)->Iterations(25);

} // namespace
} // namespace vesper

BENCHMARK_MAIN();
