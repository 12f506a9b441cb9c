#include "vesper/light/spectral_type.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>

namespace vesper {
namespace {

/// A point of the relation between spectral type and B-V. `type` counts subtypes from O0 = 0, B0 = 10 ... M0 = 60.
struct Point {
  double type;
  double b_v;
};

constexpr std::string_view main_classes = "OBAFGKM";

constexpr Point dwarfs[] = {
    {5, -0.33},  {7, -0.32},   {9, -0.31},  {10, -0.30}, {11, -0.265}, {12, -0.24}, {13, -0.205}, {15, -0.17},
    {16, -0.15}, {17, -0.135}, {18, -0.11}, {19, -0.07}, {20, -0.02},  {21, 0.01},  {22, 0.05},   {23, 0.08},
    {25, 0.15},  {27, 0.20},   {28, 0.25},  {30, 0.30},  {32, 0.35},   {35, 0.44},  {38, 0.52},   {40, 0.58},
    {42, 0.63},  {45, 0.68},   {48, 0.74},  {50, 0.81},  {51, 0.86},   {52, 0.91},  {53, 0.96},   {54, 1.05},
    {55, 1.15},  {57, 1.33},   {60, 1.40},  {61, 1.46},  {62, 1.49},   {63, 1.51},  {64, 1.54},   {65, 1.64},
    {66, 1.73},  {67, 1.80},   {68, 1.93}};
constexpr Point giants[] = {{5, -0.32},  {7, -0.32},  {9, -0.31},  {10, -0.29}, {11, -0.26}, {12, -0.24}, {13, -0.20},
                            {15, -0.17}, {18, -0.11}, {19, -0.07}, {20, -0.03}, {21, 0.01},  {22, 0.05},  {23, 0.08},
                            {25, 0.15},  {27, 0.22},  {28, 0.25},  {30, 0.30},  {32, 0.35},  {35, 0.43},  {38, 0.54},
                            {40, 0.65},  {42, 0.77},  {45, 0.86},  {48, 0.94},  {50, 1.00},  {51, 1.07},  {52, 1.16},
                            {53, 1.27},  {54, 1.38},  {55, 1.50},  {57, 1.53},  {60, 1.56},  {61, 1.58},  {62, 1.60},
                            {63, 1.61},  {64, 1.62},  {65, 1.63},  {66, 1.52},  {67, 1.50}};
constexpr Point supergiants[] = {
    {5, -0.31},  {9, -0.28},  {10, -0.23}, {11, -0.19}, {12, -0.17}, {13, -0.13}, {15, -0.10}, {16, -0.08}, {17, -0.05},
    {18, -0.03}, {20, -0.01}, {22, 0.03},  {25, 0.09},  {28, 0.14},  {30, 0.17},  {32, 0.23},  {35, 0.32},  {38, 0.56},
    {40, 0.76},  {42, 0.87},  {45, 1.02},  {48, 1.15},  {50, 1.24},  {51, 1.32},  {52, 1.36},  {53, 1.46},  {54, 1.53},
    {55, 1.60},  {57, 1.63},  {60, 1.67},  {61, 1.69},  {62, 1.71},  {64, 1.76},  {65, 1.80}};

double interpolate(std::span<const Point> table, double type) {
  const auto after = std::find_if(table.begin(), table.end(), [&](const Point& p) { return p.type >= type; });
  if (after == table.begin()) {
    return table.front().b_v;
  }
  if (after == table.end()) {
    return table.back().b_v;
  }
  const Point& a = *std::prev(after);
  return a.b_v + (type - a.type) / (after->type - a.type) * (after->b_v - a.b_v);
}

/// B-V for luminosity classes from 1 (supergiant) to 5 (dwarf): II lies between I and III, IV between III and V.
double b_v_of(double type, double luminosity) {
  if (luminosity <= 3.0) {
    const double t = (3.0 - luminosity) / 2.0;
    return (1.0 - t) * interpolate(giants, type) + t * interpolate(supergiants, type);
  }
  const double t = (luminosity - 3.0) / 2.0;
  return (1.0 - t) * interpolate(giants, type) + t * interpolate(dwarfs, type);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool take(std::string_view& text, std::string_view prefix) {
  const bool found = text.substr(0, prefix.size()) == prefix;
  if (found) {
    text.remove_prefix(prefix.size());
  }
  return found;
}

/// "5", "2.5"; nothing if no digit follows.
std::optional<double> take_subtype(std::string_view& text) {
  if (text.empty() || !is_digit(text[0])) {
    return std::nullopt;
  }
  double value = text[0] - '0';
  text.remove_prefix(1);
  if (text.size() > 1 && text[0] == '.' && is_digit(text[1])) {
    value += 0.1 * (text[1] - '0');
    text.remove_prefix(2);
  }
  return value;
}

/// The subtype of the class that was just taken, the mean of a range such as "7/8" or "0-1"; 5 where there is none.
double take_subtype_range(std::string_view& text) {
  const std::optional<double> first = take_subtype(text);
  if (!first) {
    return 5.0;
  }
  if (text.size() > 1 && (text[0] == '-' || text[0] == '/') && is_digit(text[1])) {
    text.remove_prefix(1);
    // A range that runs over the end of a class ("G8-2") is no range we understand: keep its beginning.
    const double second = take_subtype(text).value_or(*first);
    return second > *first ? 0.5 * (*first + second) : *first;
  }
  return *first;
}

/// One Roman luminosity class at the beginning of `text`.
std::optional<double> take_luminosity(std::string_view& text) {
  static constexpr std::pair<std::string_view, double> classes[] = {{"III", 3.0}, {"II", 2.0}, {"IV", 4.0},
                                                                    {"I", 1.0},   {"VI", 5.0}, {"V", 5.0}};
  for (const auto& [name, value] : classes) {
    if (take(text, name)) {
      return value;
    }
  }
  return std::nullopt;
}

/// The first luminosity class before a second component; the mean of "II-III" or "IV/V".
std::optional<double> find_luminosity(std::string_view text) {
  text = text.substr(0, text.find('+', std::min<std::size_t>(1, text.size())));
  const std::size_t begin = text.find_first_of("IV");
  if (begin == std::string_view::npos) {
    return std::nullopt;
  }
  text.remove_prefix(begin);
  const std::optional<double> first = take_luminosity(text);
  const std::size_t join = text.find_first_not_of("ab");
  if (first && join != std::string_view::npos && (text[join] == '-' || text[join] == '/')) {
    text.remove_prefix(join + 1);
    if (const std::optional<double> second = take_luminosity(text)) {
      return 0.5 * (*first + *second);
    }
  }
  return first;
}

std::optional<double> luminosity_of_prefix(std::string_view& text) {
  static constexpr std::pair<std::string_view, double> prefixes[] = {
      {"sg", 4.0}, {"sd", 5.0}, {"g", 3.0}, {"d", 5.0}, {"c", 1.0}};
  for (const auto& [name, value] : prefixes) {
    if (take(text, name)) {
      return value;
    }
  }
  return std::nullopt;
}

/// Kinds of stars outside the sequence O to M; `subtype` 0 to 9.
std::optional<double> special_b_v(char kind, double subtype) {
  switch (kind) {
  case 'W': // Wolf-Rayet
    return -0.30;
  case 'D': // white dwarfs have no subtype worth using
    return 0.0;
  case 'R':
    return 0.90 + 0.10 * subtype;
  case 'S':
    return 1.85;
  case 'C':
    return 1.20 + 0.27 * subtype;
  case 'N':
    return 2.90;
  default:
    return std::nullopt;
  }
}

} // namespace

std::optional<double> b_v_of_spectral_type(std::string_view type) {
  while (take(type, " ")) {
  }
  const std::optional<double> prefix = luminosity_of_prefix(type);
  while (take(type, ":") || take(type, " ")) {
  }
  if (type.empty()) {
    return std::nullopt;
  }
  const char kind = type[0];
  type.remove_prefix(1);
  const std::size_t main_class = main_classes.find(kind);
  if (main_class == std::string_view::npos) {
    return special_b_v(kind, take_subtype(type).value_or(5.0));
  }
  const double code = 10.0 * static_cast<double>(main_class) + take_subtype_range(type);
  const double usual = code >= 45.0 ? 3.0 : 5.0;
  return b_v_of(code, find_luminosity(type).value_or(prefix.value_or(usual)));
}

} // namespace vesper
