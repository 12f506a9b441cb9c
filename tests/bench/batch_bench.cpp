// What a row of vesper-report --batch costs: all columns, text in and text out.
#include "report/batch.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace vesper {
namespace {

constexpr int row_count = 20000;

/// Instants between two years and places all over the Earth, in no order.
Bytes scenes(double first_year, double last_year) {
  std::string text = "jd_tt,jd_ut1,latitude_deg,longitude_deg,height_m\n";
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < row_count; ++i) {
    const double share = std::fmod(i * golden, 1.0);
    const double jd = 2451545.0 + (first_year + share * (last_year - first_year) - 2000.0) * 365.25;
    text += fmt::format("{0:.9f},{0:.9f},{1:.4f},{2:.4f},{3}\n", jd, 180.0 * std::fmod(share * 97.0, 1.0) - 90.0,
                        360.0 * std::fmod(share * 89.0, 1.0) - 180.0, i % 3000);
  }
  Bytes bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

void batch(benchmark::State& state, double first_year, double last_year) {
  const CsvTable table(scenes(first_year, last_year), "scenes.csv");
  const std::vector<SceneColumn> columns = select_columns("");
  const SceneAir air{SceneOptions()};
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(batch_report(table, columns, SceneOptions(), air));
  }
  // By the processor time of all threads: the rate of one core.
  state.SetItemsProcessed(state.iterations() * row_count);
  state.SetLabel("target: 20000 items a second");
}

BENCHMARK_CAPTURE(batch, in_the_table, 1961.0, 2058.0)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(batch, outside_it, 1000.0, 1950.0)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace vesper
