#include "vesper/sky/zodiacal_light.hpp"

#include "vesper/base/csv.hpp"
#include "vesper/base/embedded.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/units.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/light/response_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>

namespace vesper {

extern const EmbeddedTable embedded_sky_tables;

namespace {

constexpr std::size_t longitudes = 19;
constexpr std::size_t latitudes = 11;
constexpr std::array<double, latitudes> latitude_deg{0, 5, 10, 15, 20, 25, 30, 45, 60, 75, 90};
constexpr double untabulated = std::numeric_limits<double>::quiet_NaN();

Vec3 helioecliptic(double longitude_deg, double latitude) {
  const double lambda = (longitude_deg * deg).to(rad);
  const double beta = (latitude * deg).to(rad);
  return {std::cos(beta) * std::cos(lambda), std::cos(beta) * std::sin(lambda), std::sin(beta)};
}

using RatioRow = std::array<double, latitudes>;

/// Logarithms of the table over the law.
struct Ratios {
  std::array<double, longitudes> longitude_deg{};
  std::array<RatioRow, longitudes> log{};
};

constexpr double finest_step_deg = 5.0; ///< of the table near the Sun, in both directions

/// The table's ratio between its places near the Sun, or nothing where one of them is missing.
std::optional<double> tabulated(const Ratios& ratios, double longitude, double latitude) {
  const auto i = static_cast<std::size_t>(longitude / finest_step_deg);
  const auto j = static_cast<std::size_t>(latitude / finest_step_deg);
  const double x = longitude / finest_step_deg - static_cast<double>(i);
  const double y = latitude / finest_step_deg - static_cast<double>(j);
  double sum = 0.0;
  for (const auto& [di, dj, weight] : {std::tuple(0U, 0U, (1.0 - x) * (1.0 - y)), std::tuple(1U, 0U, x * (1.0 - y)),
                                       std::tuple(0U, 1U, (1.0 - x) * y), std::tuple(1U, 1U, x * y)}) {
    sum += weight > 0.0 ? weight * ratios.log.at(i + di).at(j + dj) : 0.0;
  }
  return std::isnan(sum) ? std::nullopt : std::optional(sum);
}

/// Gives each untabulated place the ratio that the table begins with farther out in the same direction from the Sun,
/// and the Sun the mean of those about it: light falls there as the law does.
void fill_near_sun(Ratios& ratios) {
  Ratios filled = ratios;
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (i + j == 0 || !std::isnan(ratios.log.at(i).at(j))) {
        continue;
      }
      std::optional<double> beyond;
      for (double factor = 1.0; !beyond; factor += 0.01) {
        beyond = tabulated(ratios, factor * ratios.longitude_deg.at(i), factor * latitude_deg.at(j));
      }
      filled.log.at(i).at(j) = *beyond;
      sum += *beyond;
      ++count;
    }
  }
  filled.log.front().front() = sum / count;
  ratios = filled;
}

Ratios make_ratios() {
  const EmbeddedFile* file = embedded_sky_tables.find("zodiacal_leinert_1998.csv");
  if (file == nullptr) {
    throw Error(ErrorKind::file, "is not embedded", {"zodiacal_leinert_1998.csv", "", "Build the library again"});
  }
  const auto bytes = std::as_bytes(file->data);
  const CsvTable table({bytes.begin(), bytes.end()}, "zodiacal_leinert_1998.csv");
  Ratios ratios;
  for (std::size_t i = 0; i < longitudes; ++i) {
    ratios.longitude_deg.at(i) = table.number(i, 0);
    for (std::size_t j = 0; j < latitudes; ++j) {
      const Vec3 place = helioecliptic(ratios.longitude_deg.at(i), latitude_deg.at(j));
      ratios.log.at(i).at(j) = table.cell(i, j + 1).empty()
                                   ? untabulated
                                   : std::log(table.number(i, j + 1)) - std::numbers::ln2 * f64::log2_dust_law(place);
    }
  }
  fill_near_sun(ratios);
  return ratios;
}

/// Hermite's cubic through values at ascending places, with the slopes of parabolas through three of them; level at
/// both ends, where the sky is symmetric.
double cubic(std::span<const double> places, std::span<const double> values, double x) {
  const auto slope = [&](std::size_t k) {
    if (k == 0 || k + 1 == places.size()) {
      return 0.0;
    }
    const double before = places[k] - places[k - 1];
    const double after = places[k + 1] - places[k];
    return ((values[k] - values[k - 1]) / before * after + (values[k + 1] - values[k]) / after * before) /
           (before + after);
  };
  const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - places.begin());
  const double step = places[k] - places[k - 1];
  const double f = std::clamp((x - places[k - 1]) / step, 0.0, 1.0);
  const double g = 1.0 - f;
  return g * g * ((1.0 + 2.0 * f) * values[k - 1] + f * step * slope(k - 1)) +
         f * f * ((1.0 + 2.0 * g) * values[k] - g * step * slope(k));
}

double log_ratio(double longitude, double latitude) {
  static const Ratios ratios = make_ratios();
  std::array<double, longitudes> along{};
  for (std::size_t i = 0; i < longitudes; ++i) {
    along.at(i) = cubic(latitude_deg, ratios.log.at(i), latitude);
  }
  return cubic(ratios.longitude_deg, along, longitude);
}

double log_ratio(const Vec3& direction) {
  const double longitude = std::atan2(std::abs(direction.y), direction.x);
  const double latitude = std::atan2(std::abs(direction.z), std::hypot(direction.x, direction.y));
  return log_ratio((longitude * rad).to(deg), (latitude * rad).to(deg));
}

/// Of 1e-8 W/(m2 sr um) at 500 nm.
Vec4 zodiacal_color(const Vec3& direction) {
  const auto color = [](double far) { return vector_of(integrate_xyzs(zodiacal_spectrum(far))); };
  static const Vec4 at_30 = color(0.0);
  static const Vec4 at_90 = color(1.0);
  const double elongation_deg = (f64::sun_elongation(direction) * rad).to(deg);
  return glm::mix(at_30, at_90, std::clamp((elongation_deg - 30.0) / 60.0, 0.0, 1.0));
}

} // namespace

double zodiacal_radiance_500nm(const Vec3& direction) {
  return std::exp2(f64::log2_dust_law(direction)) * std::exp(log_ratio(direction));
}

Vec4 zodiacal_luminance(const Vec3& direction) {
  return zodiacal_radiance_500nm(direction) * zodiacal_color(direction);
}

const ZodiacalMap& zodiacal_map() {
  static const ZodiacalMap map = [] {
    ZodiacalMap made;
    for (int row = 0; row < ZodiacalMap::rows; ++row) {
      for (int column = 0; column < ZodiacalMap::columns; ++column) {
        made.texels.push_back(
            zodiacal_luminance(f64::zodiacal_direction({static_cast<double>(column) / (ZodiacalMap::columns - 1),
                                                        static_cast<double>(row) / (ZodiacalMap::rows - 1)})));
      }
    }
    return made;
  }();
  return map;
}

} // namespace vesper
