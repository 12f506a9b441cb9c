// How long it takes to find the rises, sets, transits and twilights of the Sun and the Moon.
#include "vesper/astro/sky_events.hpp"

#include <array>
#include <benchmark/benchmark.h>

namespace {

using namespace vesper;

constexpr std::array<SkyBody, 2> sun_and_moon{Luminary::sun, Luminary::moon};

void events_of_sun_and_moon(benchmark::State& state) {
  const Observer observer{51.4769 * deg, 0.0 * deg, 47.0 * metre};
  const Instant begin = instant_from_ut1({static_cast<double>(state.range(1)), 0.5});
  const Instant end = later(begin, 86400.0 * static_cast<double>(state.range(0)));
  std::size_t count = 0;
  for ([[maybe_unused]] auto _ : state) {
    const std::vector<BodyEvents> bodies = sky_events(begin, end, observer, sun_and_moon);
    count = bodies[0].events.size() + bodies[1].events.size();
    benchmark::DoNotOptimize(count);
  }
  state.counters["events"] = static_cast<double>(count);
  state.SetLabel(state.range(0) == 1 ? "target: under 1 ms" : "");
}

} // namespace

BENCHMARK(events_of_sun_and_moon)
    ->ArgNames({"days", "jd"})
    ->Args({1, 2461041}) // 2026, inside the ephemeris table
    ->Args({365, 2461041})
    ->Args({1, 2415020}) // 1900, by series
    ->Unit(benchmark::kMillisecond);
