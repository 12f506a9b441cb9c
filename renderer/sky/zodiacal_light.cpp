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
#include <span>

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

/// Gives each untabulated place the mean of its neighbours, of which the table continues itself beyond the axes of
/// symmetry: no structure that nobody has measured.
void fill_near_sun(Ratios& ratios) {
  struct Place {
    int i, j;
  };
  const auto at = [&](int i, int j) -> double& {
    return ratios.log.at(static_cast<std::size_t>(std::abs(i))).at(static_cast<std::size_t>(std::abs(j)));
  };
  std::vector<Place> unknown;
  for (int i = 0; i < static_cast<int>(longitudes); ++i) {
    for (int j = 0; j < static_cast<int>(latitudes); ++j) {
      if (std::isnan(at(i, j))) {
        unknown.push_back({i, j});
        at(i, j) = 0.0;
      }
    }
  }
  constexpr int sweeps = 200; // far more than a handful of places need
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const auto& [i, j] : unknown) {
      at(i, j) = 0.25 * (at(i - 1, j) + at(i + 1, j) + at(i, j - 1) + at(i, j + 1));
    }
  }
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
      ratios.log.at(i).at(j) =
          table.cell(i, j + 1).empty() ? untabulated : std::log(table.number(i, j + 1) / f64::dust_law(place));
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
  const Vec2 place = f64::zodiacal_place(direction);
  return log_ratio(180.0 * place.x, 90.0 * place.y);
}

/// Of 1e-8 W/(m2 sr um) at 500 nm.
Vec4 zodiacal_color(const Vec3& direction) {
  const auto color = [](double far) {
    const Xyzs light = integrate_xyzs(zodiacal_spectrum(far));
    return Vec4(light.x, light.y, light.z, light.s);
  };
  static const Vec4 at_30 = color(0.0);
  static const Vec4 at_90 = color(1.0);
  const double elongation_deg = (f64::sun_elongation(direction) * rad).to(deg);
  return glm::mix(at_30, at_90, std::clamp((elongation_deg - 30.0) / 60.0, 0.0, 1.0));
}

ZodiacalMap make_zodiacal_map() {
  ZodiacalMap map;
  for (int row = 0; row < ZodiacalMap::rows; ++row) {
    for (int column = 0; column < ZodiacalMap::columns; ++column) {
      const Vec3 place = helioecliptic(column, row);
      map.texels.push_back(glm::log2(zodiacal_color(place)) +
                           Vec4(log_ratio(static_cast<double>(column), static_cast<double>(row)) / std::numbers::ln2));
    }
  }
  return map;
}

} // namespace

double zodiacal_radiance_500nm(const Vec3& direction) {
  return f64::dust_law(direction) * std::exp(log_ratio(direction));
}

Vec4 zodiacal_luminance(const Vec3& direction) {
  return zodiacal_radiance_500nm(direction) * zodiacal_color(direction);
}

const ZodiacalMap& zodiacal_map() {
  static const ZodiacalMap map = make_zodiacal_map();
  return map;
}

} // namespace vesper
