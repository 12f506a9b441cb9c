// What places in the sky cost on one core. Each round takes another instant, so that no answer stays in a cache that a
// moving sky would miss.
#include "vesper/astro/body_place.hpp"
#include "vesper/astro/ephemeris_series.hpp"
#include "vesper/astro/ephemeris_table.hpp"
#include "vesper/sky/sky_state.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace vesper {
namespace {

constexpr double begin_jd = 2437000.5;
constexpr double span_days = 36000.0;

/// Days from the beginning of the span, spread evenly over it by the golden ratio.
class Days {
public:
  double next() {
    days_ = std::fmod(days_ + 0.6180339887498949 * span_days, span_days);
    return days_;
  }

private:
  double days_ = 0.0;
};

/// A frame's step of time: what an animation does.
class Frames {
public:
  Instant next() {
    instant_.tt.fraction += 1.0 / 86400.0;
    instant_.ut1.fraction += 1.0 / 86400.0;
    return instant_;
  }

private:
  Instant instant_ = parse_instant("2026-11-22T22:00:00Z");
};

Observer greenwich() { return {51.4769 * deg, 0.0 * deg, 47.0 * metre}; }

void sun_and_moon_any_date(benchmark::State& state) {
  Days days;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(sun_earth_moon({begin_jd, days.next()}));
  }
  state.SetLabel("target: under 1000 ns");
}

void sun_and_moon_next_frame(benchmark::State& state) {
  JulianDate<TDB> tdb{2461366.5, 0.0};
  for ([[maybe_unused]] auto _ : state) {
    tdb.fraction += 1.0 / 86400.0;
    benchmark::DoNotOptimize(sun_earth_moon(tdb));
  }
  state.SetLabel("target: under 1000 ns");
}

void sun_and_moon_by_series(benchmark::State& state) {
  Days days;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(sun_earth_moon_series({begin_jd - span_days, days.next()}));
  }
}

void seven_planets_any_date(benchmark::State& state) {
  Days days;
  for ([[maybe_unused]] auto _ : state) {
    const JulianDate<TDB> tdb{begin_jd, days.next()};
    for (int planet = 0; planet < planet_count; ++planet) {
      benchmark::DoNotOptimize(planet_heliocentric(static_cast<Planet>(planet), tdb));
    }
  }
}

void seven_planets_by_series(benchmark::State& state) {
  Days days;
  for ([[maybe_unused]] auto _ : state) {
    const JulianDate<TDB> tdb{begin_jd - span_days, days.next()};
    for (int planet = 0; planet < planet_count; ++planet) {
      benchmark::DoNotOptimize(planet_heliocentric_series(static_cast<Planet>(planet), tdb));
    }
  }
}

void seven_planets_from_observer(benchmark::State& state) {
  const EarthState earth = earth_state(Frames().next(), greenwich());
  for ([[maybe_unused]] auto _ : state) {
    for (int planet = 0; planet < planet_count; ++planet) {
      benchmark::DoNotOptimize(planet_from_observer_au(static_cast<Planet>(planet), earth));
    }
  }
}

void nutation_and_lunar_angles(benchmark::State& state) {
  const EphemerisTable& table = EphemerisTable::embedded();
  Days days;
  for ([[maybe_unused]] auto _ : state) {
    const double now = days.next();
    benchmark::DoNotOptimize(table.nutation({begin_jd, now}));
    benchmark::DoNotOptimize(table.lunar_angles({begin_jd, now}));
  }
}

void earth_state_next_frame(benchmark::State& state) {
  Frames frames;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(earth_state(frames.next(), greenwich()));
  }
}

void sky_state_next_frame(benchmark::State& state) {
  Frames frames;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(sky_state(frames.next(), greenwich()));
  }
  state.SetLabel("target: under 5000 ns inside the table");
}

/// The years 1000 to 2960 with the table's century skipped, in no order.
void sky_state_outside_the_table(benchmark::State& state) {
  constexpr double year_days = 365.25;
  double years = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    years = std::fmod(years + 0.6180339887498949 * 1858.0, 1858.0);
    const double year = 1000.0 + years + (years > 958.0 ? 102.0 : 0.0);
    const Instant instant = instant_from_tt({2451545.0, (year - 2000.0) * year_days});
    benchmark::DoNotOptimize(sky_state(instant, greenwich()));
  }
  state.SetLabel("target: under 50000 ns");
}

BENCHMARK(sun_and_moon_any_date);
BENCHMARK(sun_and_moon_next_frame);
BENCHMARK(sun_and_moon_by_series);
BENCHMARK(seven_planets_any_date);
BENCHMARK(seven_planets_by_series);
BENCHMARK(seven_planets_from_observer);
BENCHMARK(nutation_and_lunar_angles);
BENCHMARK(earth_state_next_frame);
BENCHMARK(sky_state_next_frame);
BENCHMARK(sky_state_outside_the_table);

} // namespace
} // namespace vesper
