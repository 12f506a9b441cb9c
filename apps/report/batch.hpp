// Many scenes from one table.
#pragma once

#include "report/scene_columns.hpp"

#include "common/scene_options.hpp"

#include "vesper/base/csv.hpp"

#include <string>

namespace vesper {

struct BatchReport {
  std::string csv;
  std::size_t rows_taken_as_ut1 = 0; ///< UTC stamps outside the known leap seconds
  std::size_t first_such_line = 0;   ///< of the input
  Instant farthest;                  ///< the row's that is farthest from J2000
  std::size_t farthest_line = 0;     ///< 0 without rows
};

/// One output row for each row of `input`: its fields as they stand, then `columns`.
///
/// Input columns: `jd_tt` and `jd_ut1`, or else `utc`; `latitude_deg`, `longitude_deg`, `height_m`. A place column may
/// be missing when `defaults` gives its value. Throws Error(input) naming line and column.
/// \param air of `defaults`, for columns that need it
/// \param threads 0 for one per core; the result does not depend on it
[[nodiscard]] BatchReport batch_report(const CsvTable& input, std::span<const SceneColumn> columns,
                                       const SceneOptions& defaults, const SceneAir& air, unsigned threads = 0);

} // namespace vesper
