#include "vesper/light/response_functions.hpp"

#include "vesper/base/embedded.hpp"
#include "vesper/light/embedded_spectrum.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace vesper {

extern const EmbeddedTable embedded_light_tables;

namespace {

constexpr std::size_t grid_size = response_last_nm - response_first_nm + 1;
using Grid = std::array<double, grid_size>;

/// A column of a table in our own data folder, against its first one.
Spectrum column_of(std::string_view name, std::string_view column) {
  return embedded_spectrum(embedded_light_tables, name, column);
}

/// The spectrum at the grid's wavelengths. Walks through the samples once: a search for each would cost more than all
/// the rest.
Grid on_grid(const Spectrum& spectrum) {
  const std::vector<double>& nm = spectrum.wavelengths_nm();
  const std::vector<double>& values = spectrum.values();
  Grid grid{};
  std::size_t after = 1;
  for (std::size_t i = 0; i < grid_size; ++i) {
    const double at = response_first_nm + static_cast<double>(i);
    if (at < nm.front() || at > nm.back()) {
      continue;
    }
    while (after + 1 < nm.size() && nm[after] < at) {
      ++after;
    }
    const double t = (at - nm[after - 1]) / (nm[after] - nm[after - 1]);
    grid[i] = values[after - 1] + t * (values[after] - values[after - 1]);
  }
  return grid;
}

double integral(const Grid& a, const Grid& b) {
  double sum = 0.5 * (a.front() * b.front() + a.back() * b.back());
  for (std::size_t i = 1; i + 1 < grid_size; ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

} // namespace

Chromaticity chromaticity(const Xyzs& light) {
  const double sum = light.x + light.y + light.z;
  return {light.x / sum, light.y / sum};
}

const Spectrum& cie_x_bar() {
  static const Spectrum table = column_of("cie_1931_2deg_xyz.csv", "x_bar");
  return table;
}

const Spectrum& cie_y_bar() {
  static const Spectrum table = column_of("cie_1931_2deg_xyz.csv", "y_bar");
  return table;
}

const Spectrum& cie_z_bar() {
  static const Spectrum table = column_of("cie_1931_2deg_xyz.csv", "z_bar");
  return table;
}

const Spectrum& cie_scotopic() {
  static const Spectrum table = column_of("cie_1951_scotopic.csv", "v_prime");
  return table;
}

const Spectrum& v_band() {
  static const Spectrum table = column_of("bessell_1990_v.csv", "v");
  return table;
}

Xyzs integrate_xyzs(const Spectrum& spectrum) {
  static const std::array<Grid, 4> responses{on_grid(cie_x_bar()), on_grid(cie_y_bar()), on_grid(cie_z_bar()),
                                             on_grid(cie_scotopic())};
  const Grid light = on_grid(spectrum);
  return {
      photopic_efficacy_lm_w * integral(light, responses[0]), photopic_efficacy_lm_w * integral(light, responses[1]),
      photopic_efficacy_lm_w * integral(light, responses[2]), scotopic_efficacy_lm_w * integral(light, responses[3])};
}

double integrate_v_band(const Spectrum& spectrum) {
  static const Grid response = on_grid(v_band());
  return integral(on_grid(spectrum), response);
}

} // namespace vesper
