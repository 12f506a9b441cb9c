#include "vesper/light/embedded_spectrum.hpp"

#include "vesper/base/csv.hpp"
#include "vesper/base/error.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vesper {

Spectrum embedded_spectrum(const EmbeddedTable& tables, std::string_view name, std::string_view column) {
  const EmbeddedFile* file = tables.find(name);
  if (file == nullptr) {
    throw Error(ErrorKind::file, "is not embedded", {std::string(name), "", "Build the library again"});
  }
  const auto bytes = std::as_bytes(file->data);
  const CsvTable table({bytes.begin(), bytes.end()}, std::string(name));
  std::vector<double> nm;
  std::vector<double> values;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    nm.push_back(table.number(row, 0));
    values.push_back(table.number(row, table.column(column)));
  }
  return {std::move(nm), std::move(values)};
}

} // namespace vesper
