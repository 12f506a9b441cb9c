// How long it takes to find the rises, sets, transits and twilights of a day and of a year.
#include "vesper/astro/sky_events.hpp"

#include <array>
#include <benchmark/benchmark.h>

namespace {

using namespace vesper;

constexpr std::array<SkyBody, 2> sun_and_moon{Luminary::sun, Luminary::moon};

void events_of_sun_and_moon(benchmark::State& state) {
  const Observer observer{51.4769 * deg, 0.0 * deg, 47.0 * metre};
  const Instant begin = parse_instant("2026-01-01");
  const Instant end = later(begin, 86400.0 * static_cast<double>(state.range(0)));
  std::size_t count = 0;
  for ([[maybe_unused]] auto _ : state) {
    const std::vector<BodyEvents> bodies = sky_events(begin, end, observer, sun_and_moon);
    count = bodies[0].events.size() + bodies[1].events.size();
    benchmark::DoNotOptimize(count);
  }
  state.counters["events"] = static_cast<double>(count);
  state.SetLabel(state.range(0) == 1 ? "target: under 1 ms" : "a year");
}

} // namespace

BENCHMARK(events_of_sun_and_moon)->Arg(1)->Arg(365)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
