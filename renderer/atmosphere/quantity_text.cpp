#include "vesper/atmosphere/quantity_text.hpp"

#include "vesper/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <span>

namespace vesper {
namespace {

/// value = factor * written + offset
struct Unit {
  std::string_view name;
  double factor = 1.0;
  double offset = 0.0;
};

constexpr std::array height_units{Unit{"km"}, Unit{"m", 1.0e-3}};
constexpr std::array wavelength_units{Unit{"nm"}, Unit{"um", 1.0e3}, Unit{"\u00b5m", 1.0e3}};
constexpr std::array coefficient_units{Unit{"/km"}, Unit{"/m", 1.0e3}, Unit{"1/km"}, Unit{"1/m", 1.0e3}};
constexpr std::array ozone_units{Unit{"DU"}};
constexpr std::array pressure_units{Unit{"hPa"}, Unit{"mbar"}, Unit{"Pa", 1.0e-2}};
constexpr std::array temperature_units{Unit{"C"}, Unit{"K", 1.0, -273.15}};

std::span<const Unit> units_of(QuantityKind kind) {
  switch (kind) {
  case QuantityKind::height:
    return height_units;
  case QuantityKind::wavelength:
    return wavelength_units;
  case QuantityKind::coefficient:
    return coefficient_units;
  case QuantityKind::ozone_column:
    return ozone_units;
  case QuantityKind::pressure:
    return pressure_units;
  case QuantityKind::temperature:
    break;
  }
  return temperature_units;
}

std::string unit_names(QuantityKind kind) {
  std::string names;
  for (const Unit& unit : units_of(kind)) {
    names.append(names.empty() ? "" : ", ").append(unit.name);
  }
  return names;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  const std::size_t end = text.find_last_not_of(blanks) + 1;
  return text.substr(begin, std::max(end, begin) - begin);
}

struct Written {
  double number;
  std::string_view unit; ///< empty where none stands
};

Written read_item(std::string_view text, QuantityKind kind) {
  std::string_view digits = trimmed(text);
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') {
    digits.remove_prefix(1);
  }
  Written item{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), item.number);
  if (error != std::errc() || !std::isfinite(item.number)) {
    throw Error(ErrorKind::argument, fmt::format("'{}' does not begin with a finite number", trimmed(text)),
                {"", "", "Write a number with one of the units " + unit_names(kind)});
  }
  item.unit = trimmed(digits.substr(static_cast<std::size_t>(std::distance(digits.data(), end))));
  return item;
}

const Unit& find_unit(std::string_view name, std::string_view text, QuantityKind kind) {
  if (name.empty()) {
    throw Error(ErrorKind::argument, fmt::format("'{}' has no unit", trimmed(text)),
                {"", "", "Write one of the units " + unit_names(kind) + " behind it"});
  }
  const auto units = units_of(kind);
  const auto unit = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name; });
  if (unit == units.end()) {
    throw Error(ErrorKind::argument, fmt::format("'{}' has the unit '{}'", trimmed(text), name),
                {"", "", "Here stand the units " + unit_names(kind)});
  }
  return *unit;
}

} // namespace

std::vector<double> parse_quantities(std::string_view text, QuantityKind kind) {
  std::vector<Written> items;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    items.push_back(read_item(text.substr(begin, end - begin), kind));
    begin = end + 1;
  }
  const Unit& common = find_unit(items.back().unit, text, kind);
  std::vector<double> values;
  for (const Written& item : items) {
    const Unit& unit = item.unit.empty() ? common : find_unit(item.unit, text, kind);
    values.push_back(unit.factor * item.number + unit.offset);
  }
  return values;
}

std::string_view unit_of(QuantityKind kind) { return units_of(kind).front().name; }

} // namespace vesper
