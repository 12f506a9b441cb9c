#include "report/batch.hpp"

#include "common/progress_bar.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/worker_pool.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace vesper {
namespace {

constexpr double last_jd = 5373484.5; // the end of year 9999
constexpr std::size_t quick_rows_per_chunk = 64;

struct InputColumns {
  std::optional<std::size_t> utc, jd_tt, jd_ut1, latitude, longitude, height;
};

std::optional<std::size_t> place_column(const CsvTable& input, std::string_view name, bool has_default) {
  return has_default ? input.find_column(name) : std::optional(input.column(name));
}

InputColumns find_columns(const CsvTable& input, const SceneOptions& defaults) {
  InputColumns found;
  found.jd_tt = input.find_column("jd_tt");
  found.jd_ut1 = input.find_column("jd_ut1");
  if (found.jd_tt.has_value() != found.jd_ut1.has_value() && !input.find_column("utc")) {
    found.jd_tt = input.column("jd_tt"); // throws for the one that is missing
    found.jd_ut1 = input.column("jd_ut1");
  }
  if (!found.jd_tt || !found.jd_ut1) {
    found.utc = input.column("utc");
  }
  found.latitude = place_column(input, "latitude_deg", defaults.latitude_given);
  found.longitude = place_column(input, "longitude_deg", defaults.longitude_given);
  found.height = place_column(input, "height_m", defaults.height_given);
  return found;
}

/// A Julian date in two parts, so that its fraction keeps all its digits.
struct SplitDate {
  double day, fraction;
};
SplitDate julian_date(const CsvTable& input, std::size_t row, std::size_t column) {
  const double whole = input.number(row, column, 0.0, last_jd);
  const std::string_view text = input.cell(row, column);
  const std::size_t point = text.find('.');
  double fraction = 0.0;
  if (point != std::string_view::npos) {
    const auto [end, error] = std::from_chars(text.data() + point, text.data() + text.size(), fraction);
    const bool plain = error == std::errc() && text.find_first_of("eE") == std::string_view::npos;
    if (plain) {
      return {std::floor(whole - fraction + 0.5), fraction};
    }
  }
  return {std::floor(whole), whole - std::floor(whole)};
}

/// Without the spaces around it, which numbers may have too.
std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

Instant instant_of_row(const CsvTable& input, std::size_t row, const InputColumns& columns,
                       const SceneOptions& defaults) {
  if (columns.utc) {
    try {
      return parse_instant(trimmed(input.cell(row, *columns.utc)), defaults.time_scale, defaults.calendar);
    } catch (const Error& e) {
      ErrorContext context = input.context(row, *columns.utc);
      context.remedy = e.context().remedy;
      throw Error(ErrorKind::input, e.message(), context);
    }
  }
  const SplitDate tt = julian_date(input, row, *columns.jd_tt);
  const SplitDate ut1 = julian_date(input, row, *columns.jd_ut1);
  Instant instant = instant_from({tt.day, tt.fraction}, {ut1.day, ut1.fraction});
  constexpr double most_delta_t_s = 3.0 * seconds_per_day; // reached about the years -6000 and 11000
  if (std::abs(instant.delta_t_s) > most_delta_t_s) {
    input.fail(row, *columns.jd_ut1, "lies more than three days from jd_tt");
  }
  return instant;
}

Observer observer_of_row(const CsvTable& input, std::size_t row, const InputColumns& columns,
                         const Observer& defaults) {
  Observer observer = defaults;
  if (columns.latitude) {
    observer.latitude = input.number(row, *columns.latitude, -90.0, 90.0) * deg;
  }
  if (columns.longitude) {
    observer.longitude = input.number(row, *columns.longitude, -180.0, 360.0) * deg;
  }
  if (columns.height) {
    observer.height = input.number(row, *columns.height, lowest_height_m, highest_height_m) * metre;
  }
  return observer;
}

double days_from_j2000(const Instant& instant) { return std::abs(instant.tt.days_since({2451545.0, 0.0})); }

std::string header_of(const CsvTable& input, std::span<const SceneColumn> columns) {
  std::string header;
  for (const std::string_view name : input.header()) {
    append_csv_field(header, name);
    header += ',';
  }
  for (const SceneColumn& column : columns) {
    if (input.find_column(column.name)) {
      throw Error(ErrorKind::input, fmt::format("column '{}' stands in the input already", column.name),
                  {input.file(), "line 1", "Rename it, or leave it out of --columns"});
    }
    header.append(column.name);
    header += ',';
  }
  header.back() = '\n';
  return header;
}

} // namespace

BatchReport batch_report(const CsvTable& input, std::span<const SceneColumn> columns, const SceneOptions& defaults,
                         const SceneAir& air, unsigned threads) {
  const InputColumns found = find_columns(input, defaults);
  BatchReport report;
  report.csv = header_of(input, columns);
  const std::size_t rows = input.row_count();
  const bool lit = std::any_of(columns.begin(), columns.end(), [](const auto& column) { return column.of_light; });
  const std::size_t rows_per_chunk = lit && air.model() == SkyModel::reference ? 1 : quick_rows_per_chunk;
  if (lit && air.model() != SkyModel::reference) {
    static_cast<void>(air.tables()); // with a progress bar of their own
  }

  struct Chunk {
    std::string csv;
    std::size_t taken_as_ut1 = 0;
    std::size_t first_line = 0;
    Instant farthest;
    std::size_t farthest_line = 0;
  };
  std::vector<Chunk> chunks((rows + rows_per_chunk - 1) / rows_per_chunk);
  ProgressBar progress("scenes", rows);
  parallel_for(
      rows, rows_per_chunk,
      [&](std::size_t begin, std::size_t end) {
        Chunk& chunk = chunks[begin / rows_per_chunk];
        for (std::size_t row = begin; row < end; ++row) {
          const Instant instant = instant_of_row(input, row, found, defaults);
          if (!instant.note.empty() && chunk.taken_as_ut1++ == 0) {
            chunk.first_line = input.line(row);
          }
          if (chunk.farthest_line == 0 || days_from_j2000(instant) > days_from_j2000(chunk.farthest)) {
            chunk.farthest = instant;
            chunk.farthest_line = input.line(row);
          }
          const SkyState sky = sky_state_of(defaults, instant, observer_of_row(input, row, found, defaults.observer));
          for (std::size_t column = 0; column < input.header().size(); ++column) {
            append_csv_field(chunk.csv, input.cell(row, column));
            chunk.csv += ',';
          }
          const ReportedScene scene{sky, air, {}, {}};
          for (const SceneColumn& column : columns) {
            append_number(chunk.csv, column.value(scene));
            chunk.csv += ',';
          }
          chunk.csv.back() = '\n';
        }
        progress.advance(end - begin);
      },
      threads);
  for (const Chunk& chunk : chunks) {
    report.csv += chunk.csv;
    if (report.rows_taken_as_ut1 == 0) {
      report.first_such_line = chunk.first_line;
    }
    report.rows_taken_as_ut1 += chunk.taken_as_ut1;
    if (report.farthest_line == 0 || days_from_j2000(chunk.farthest) > days_from_j2000(report.farthest)) {
      report.farthest = chunk.farthest;
      report.farthest_line = chunk.farthest_line;
    }
  }
  return report;
}

} // namespace vesper
