// Cost of refraction: a traced ray, a table, an altitude from it.
#include "vesper/astro/refraction.hpp"
#include "vesper/astro/refraction_trace.hpp"

#include <benchmark/benchmark.h>

namespace vesper {
namespace {

void table(benchmark::State& state) {
  const RefractionConditions conditions = standard_conditions(47.0 * metre);
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_refraction_table(conditions));
  }
}
BENCHMARK(table)->Unit(benchmark::kMicrosecond);

void horizon_ray(benchmark::State& state, TraceQuality quality) {
  const RefractionTracer tracer(standard_conditions(47.0 * metre), quality);
  for (auto _ : state) {
    benchmark::DoNotOptimize(tracer.trace(0.0 * deg));
  }
}
BENCHMARK_CAPTURE(horizon_ray, fast, fast_trace)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(horizon_ray, fine, fine_trace)->Unit(benchmark::kMicrosecond);

void looked_up(benchmark::State& state, RefractionModel model) {
  const Refraction refraction = with_table({model, standard_conditions(47.0 * metre), nullptr});
  Vec3 direction(0.6, 0.0, 0.8);
  for (auto _ : state) {
    benchmark::DoNotOptimize(direction);
    benchmark::DoNotOptimize(apparent_direction(direction, refraction));
  }
}
BENCHMARK_CAPTURE(looked_up, published, RefractionModel::published);
BENCHMARK_CAPTURE(looked_up, traced, RefractionModel::traced);

void conditions_of_the_standard_atmosphere(benchmark::State& state) {
  double height_m = 0.0;
  for (auto _ : state) {
    height_m = height_m < 5000.0 ? height_m + 1.0 : 0.0;
    benchmark::DoNotOptimize(standard_conditions(height_m * metre));
  }
}
BENCHMARK(conditions_of_the_standard_atmosphere);

} // namespace
} // namespace vesper
