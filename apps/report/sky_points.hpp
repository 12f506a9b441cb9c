// Where a sky is looked at.
#pragma once

#include "vesper/base/csv.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/plan/view.hpp"

#include <array>
#include <optional>
#include <vector>

namespace vesper {

/// Altitude and azimuth (north through east), as they were given.
struct SeenPlace {
  double altitude_deg = 0.0;
  double azimuth_deg = 0.0;

  [[nodiscard]] Vec3 direction() const; ///< horizon frame
};

/// A direction to look into.
struct SkyPoint {
  SeenPlace place;
  std::optional<SeenPlace> sun; ///< where the Sun then stands, if this point has a Sun of its own
  std::array<int, 2> pixel{};   ///< column and row, for a picture
};

/// The zenith alone.
[[nodiscard]] std::vector<SkyPoint> zenith_point();

/// The rows of a table with the columns altitude_deg (-90 to 90) and azimuth_deg (-360 to 360) and perhaps
/// sun_altitude_deg and, 180 without it, sun_azimuth_deg. Throws Error(input) naming line and column.
[[nodiscard]] std::vector<SkyPoint> points_of_table(const CsvTable& table);
[[nodiscard]] bool table_has_sun(const CsvTable& table);

/// The centres of a picture's pixels, row by row, those outside a fisheye's circle left out. Directions are what the
/// observer sees.
[[nodiscard]] std::vector<SkyPoint> points_of_view(const View& view);

} // namespace vesper
