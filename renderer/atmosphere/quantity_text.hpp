// Quantities as people write them: numbers with their unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vesper {

/// What is measured, and the unit that values are read into.
enum class QuantityKind {
  height,       ///< km; written in km, m
  wavelength,   ///< nm; nm, um, with a micro sign too
  coefficient,  ///< 1/km; /km, /m, 1/km, 1/m
  ozone_column, ///< Dobson units; DU
  pressure,     ///< hPa; hPa, mbar, Pa
  temperature,  ///< degrees Celsius; C, K
};

/// "8 km" or "0, 1200, 2400 m": finite numbers between commas, at least one. The last has a unit, and it holds for all
/// that have none of their own.
/// Throws Error(argument) naming the number or unit that cannot be read, and the units that can.
[[nodiscard]] std::vector<double> parse_quantities(std::string_view text, QuantityKind kind);

/// The name of the unit that values of this kind are read into.
[[nodiscard]] std::string_view unit_of(QuantityKind kind);

} // namespace vesper
