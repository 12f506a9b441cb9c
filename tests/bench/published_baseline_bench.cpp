// What the published methods cost and how wrong they are at the zenith, against the reference figures: CSV, or with
// --page the text of docs/BASELINES.md.
#include "baselines/published_sky.hpp"

#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/single_scattering.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/error.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace vesper {
namespace {

using baseline::PublishedSky;

/// Tables under test.
struct Entry {
  const char* name;
  const char* column;
  baseline::PublishedOptions options;
};

std::array<Entry, 3> entries() {
  std::array<Entry, 3> result{{{"float tables", "float", {}}, {"half tables", "half", {}}, {"revised", "revised", {}}}};
  result[1].options.storage = baseline::Storage::half;
  result[2].options.sun = baseline::SunMapping::revised;
  return result;
}

struct Row {
  double height_km = 0.0;
  double sun_deg = 0.0;
  double wavelength_nm = 0.0;
  double total = 0.0; ///< of the reference, 1/sr
  double standard_error = 0.0;
  double single = 0.0;
  std::array<double, 3> tables{}; ///< of the entries
};

/// Of all threads together: what else runs on the machine does not count.
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Measurement {
  std::vector<Row> rows;
  std::array<double, 3> fill_s{}; ///< processor time
  double single_ms = 0.0;         ///< a query
};

Vec3 sun_direction(const Row& row) {
  const double altitude = (row.sun_deg * deg).to(rad);
  return {std::cos(altitude), 0.0, std::sin(altitude)};
}

double at_zenith(const PublishedSky& sky, const Row& row) {
  const baseline::Rgb rgb = sky.radiance(static_cast<float>(row.height_km), sun_direction(row), {0.0F, 0.0F, 1.0F});
  return static_cast<double>(row.wavelength_nm > 600.0 ? rgb.x : row.wavelength_nm > 500.0 ? rgb.y : rgb.z);
}

std::vector<Row> reference() {
  const std::string path = VESPER_TEST_DATA "/atmosphere/sky_zenith_radiance.csv";
  const CsvTable table(read_file(path), path);
  const auto number = [&](std::size_t row, const char* column) { return table.number(row, table.column(column)); };
  std::vector<Row> rows(table.row_count());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].height_km = number(i, "height_km");
    rows[i].sun_deg = number(i, "sun_elevation_deg");
    rows[i].wavelength_nm = number(i, "channel_nm");
    rows[i].total = number(i, "total");
    rows[i].standard_error = number(i, "standard_error");
  }
  return rows;
}

Measurement measure() {
  const Medium air = published_medium();
  Measurement result;
  result.rows = reference();
  const double start = processor_s();
  for (Row& row : result.rows) {
    const SkyQuery query{row.height_km * kilometre, sun_direction(row), 0.0 * deg, Vec3(0.0, 0.0, 1.0)};
    row.single = single_scattering(air, query, {row.wavelength_nm}).radiance[0];
  }
  result.single_ms = 1.0e3 * (processor_s() - start) / static_cast<double>(result.rows.size());
  const std::array<Entry, 3> all = entries();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double begin = processor_s();
    const PublishedSky sky(air, all[i].options);
    result.fill_s[i] = processor_s() - begin;
    for (Row& row : result.rows) {
      row.tables[i] = at_zenith(sky, row);
    }
  }
  return result;
}

void print_csv(const Measurement& measured) {
  std::printf("sun_altitude_deg,wavelength_nm,reference_per_sr,standard_error_per_sr,single_per_sr,single_ratio");
  for (const Entry& entry : entries()) {
    std::printf(",%s_per_sr,%s_ratio,%s_fill_s", entry.column, entry.column, entry.column);
  }
  std::puts("");
  for (const Row& row : measured.rows) {
    std::printf("%g,%g,%.6e,%.3e,%.6e,%.4g", row.sun_deg, row.wavelength_nm, row.total, row.standard_error, row.single,
                row.single / row.total);
    for (std::size_t i = 0; i < row.tables.size(); ++i) {
      std::printf(",%.6e,%.4g,%.1f", row.tables[i], row.tables[i] / row.total, measured.fill_s[i]);
    }
    std::puts("");
  }
}

void print_page(const Measurement& measured) {
  std::printf(R"(# Published baselines

What published methods make of the zenith, as a multiple of the reference in
`tests/data/atmosphere/sky_zenith_radiance.csv` (medium `published`, all orders, observer at 10 m): 1 is right. Made by

    build/release/bin/bench_published_baseline --page > docs/BASELINES.md

- **Float tables**: Bruneton and Neyret's precomputation in the form of 2017, with its own sizes (scattering 32 x 128 x
  32 x 8), steps and four orders, in single precision; written from its description (`tests/baselines`). Filled in
  %.0f s of one core's time.
- **Half tables**: the same with the tables of scattering in half floats (%.0f s).
- **Revised**: float tables with the later mapping of the Sun's altitude, which reaches down to -30 degrees (%.0f s).
- **Single**: light scattered once, by quadrature to 1e-6 (`vesper/atmosphere/single_scattering.hpp`); %.1f ms a
  direction.

The tables hold 32 altitudes of the Sun, about one degree apart at the horizon and more below. Between them radiance is
taken as linear where it falls exponentially, which makes the tables too bright there. Below the lowest altitude (-10.3
degrees, revised -30) the last one stands for all.

The last column is the reference's own standard error.

| Sun, degrees | nm | reference, 1/sr | float tables | half tables | revised | single | error |
|---|---|---|---|---|---|---|---|
)",
              measured.fill_s[0], measured.fill_s[1], measured.fill_s[2], measured.single_ms);
  for (const Row& row : measured.rows) {
    std::printf("| %g | %g | %.3e |", row.sun_deg, row.wavelength_nm, row.total);
    for (const double value : {row.tables[0], row.tables[1], row.tables[2], row.single}) {
      std::printf(" %.3g |", value / row.total);
    }
    std::printf(" %.1f %% |\n", 100.0 * row.standard_error / row.total);
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
