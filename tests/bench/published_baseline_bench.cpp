// What the published methods cost and how wrong they are at the zenith, against the reference figures: CSV, or with
// --page the text of docs/BASELINES.md.
#include "baselines/published_sky.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/single_scattering.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/error.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace vesper {
namespace {

using baseline::PublishedSky;
using baseline::Storage;

struct Row {
  double sun_deg;
  double wavelength_nm;
  double total; ///< of the reference, 1/sr
  double standard_error;
  double single;
  double tables;
  double half_tables;
};

class Stopwatch {
public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct Measurement {
  std::vector<Row> rows;
  double tables_seconds = 0.0;
  double half_tables_seconds = 0.0;
  double single_milliseconds = 0.0; ///< a query
};

double at_zenith(const PublishedSky& sky, const Row& row, double height_km, const Vec3& light) {
  const baseline::Rgb rgb = sky.radiance(static_cast<float>(height_km), light, {0.0F, 0.0F, 1.0F});
  return static_cast<double>(row.wavelength_nm > 600.0 ? rgb.x : row.wavelength_nm > 500.0 ? rgb.y : rgb.z);
}

Measurement measure() {
  const Medium air = published_medium();
  Measurement result;
  const Stopwatch tables_watch;
  const PublishedSky tables(air);
  result.tables_seconds = tables_watch.seconds();
  const Stopwatch half_watch;
  const PublishedSky half_tables(air, {}, Storage::half);
  result.half_tables_seconds = half_watch.seconds();

  const std::string path = VESPER_TEST_DATA "/atmosphere/sky_zenith_radiance.csv";
  const CsvTable truth(read_file(path), path);
  const auto number = [&](std::size_t row, const char* column) { return truth.number(row, truth.column(column)); };
  for (std::size_t i = 0; i < truth.row_count(); ++i) {
    Row row{number(i, "sun_elevation_deg"), number(i, "channel_nm"), number(i, "total"), number(i, "standard_error"),
            0.0, 0.0, 0.0};
    const double height_km = number(i, "height_km");
    const double altitude = (row.sun_deg * deg).to(rad);
    const Vec3 light(std::cos(altitude), 0.0, std::sin(altitude));
    const SkyQuery query{height_km * kilometre, light, 0.0 * deg, Vec3(0.0, 0.0, 1.0)};
    const Stopwatch watch;
    row.single = single_scattering(air, query, {row.wavelength_nm}).radiance[0];
    result.single_milliseconds += 1.0e3 * watch.seconds() / static_cast<double>(truth.row_count());
    row.tables = at_zenith(tables, row, height_km, light);
    row.half_tables = at_zenith(half_tables, row, height_km, light);
    result.rows.push_back(row);
  }
  return result;
}

void print_csv(const Measurement& measured) {
  std::puts("sun_altitude_deg,wavelength_nm,reference_per_sr,standard_error_per_sr,tables_per_sr,tables_ratio,"
            "half_tables_per_sr,half_tables_ratio,single_per_sr,single_ratio,tables_s,half_tables_s");
  for (const Row& row : measured.rows) {
    std::printf("%g,%g,%.6e,%.3e,%.6e,%.4f,%.6e,%.4f,%.6e,%.4f,%.1f,%.1f\n", row.sun_deg, row.wavelength_nm, row.total,
                row.standard_error, row.tables, row.tables / row.total, row.half_tables, row.half_tables / row.total,
                row.single, row.single / row.total, measured.tables_seconds, measured.half_tables_seconds);
  }
}

void print_page(const Measurement& measured) {
  std::printf(R"(# Published baselines

What published real-time methods make of the zenith, over the reference figures of
`tests/data/atmosphere/sky_zenith_radiance.csv` (medium `published`, all orders, observer at 10 m). Made by

    build/release/bin/bench_published_baseline --page > docs/BASELINES.md

- **Tables**: Bruneton and Neyret's precomputation (2008, in the form of 2017) with its own sizes, steps and four
  orders, in single precision; once with float tables, once with its tables of scattering in half floats
  (`tests/baselines`). Filled on %u threads in %.0f s and %.0f s.
- **Single**: light scattered once, exact (`vesper/atmosphere/single_scattering.hpp`), %.1f ms a query.

1 is right. The reference's own standard error stands in the last column.

| Sun, degrees | nm | radiance, 1/sr | float tables | half tables | single | error |
|---|---|---|---|---|---|---|
)",
              std::max(1U, std::thread::hardware_concurrency()), measured.tables_seconds,
              measured.half_tables_seconds, measured.single_milliseconds);
  for (const Row& row : measured.rows) {
    std::printf("| %g | %g | %.3e | %.3f | %.3f | %.3f | %.1f %% |\n", row.sun_deg, row.wavelength_nm, row.total,
                row.tables / row.total, row.half_tables / row.total, row.single / row.total,
                100.0 * row.standard_error / row.total);
  }
}

int run(int count, char** arguments) {
  bool page = false;
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--page") {
      page = true;
    } else if (!argument.starts_with("--benchmark_")) { // those are for the other benchmarks
      std::fprintf(stderr, "bench_published_baseline: unknown option '%s'; --page or none\n", arguments[i]);
      return 2;
    }
  }
  const Measurement measured = measure();
  page ? print_page(measured) : print_csv(measured);
  return 0;
}

} // namespace
} // namespace vesper

int main(int count, char** arguments) {
  try {
    return vesper::run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_published_baseline: %s\n", error.what());
    return 1;
  }
}
