// Maps of a whole globe in longitude and latitude, and their means over small areas.
#pragma once

#include "vesper/base/vector.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace vesper {

/// An equirectangular map: rows of equal latitude from the north pole down, columns of equal longitude eastward, each
/// pixel as many degrees wide as high.
struct GlobeGrid {
  int width = 0;  ///< pixels, twice the height
  int height = 0; ///< pixels
  /// Longitude of the left edge, degrees, positive east.
  double west_edge_deg = 0;
  std::vector<float> values; ///< row by row; NaN where missing
  std::string file{};        ///< that it was read from, for messages
};

struct FillReport {
  std::size_t filled = 0; ///< pixels that were missing
  double area_share = 0;  ///< their share of the sphere's area, 0 to 1
};

/// Gives each missing pixel the mean of its neighbours, from the border of the known ones inward, across the poles and
/// around the globe. Nothing is filled where no pixel is known.
FillReport fill_missing(GlobeGrid& grid);

/// Means of a grid without missing pixels over small areas of the sphere, each in the same time whatever its size.
/// Takes 8 bytes a pixel.
class GlobeMeans {
public:
  explicit GlobeMeans(const GlobeGrid& grid);

  /// Mean by area over a square on the ground around the direction, its sides along the latitude and the longitude,
  /// rounded to whole pixels in each. One pixel joins its neighbours linearly; at a pole it becomes whole rows.
  /// \param direction unit vector: x to longitude 0, y to 90 degrees east, z to the north pole
  /// \param size_rad  angle across the area, small
  [[nodiscard]] double mean(const Vec3& direction, double size_rad) const;

private:
  [[nodiscard]] double sum(double column, double row) const;
  [[nodiscard]] double area(double row) const;

  int width_, height_;
  double west_edge_rad_;
  std::vector<double> sums_;  ///< of value times area, above and left of each corner of pixels
  std::vector<double> areas_; ///< of a column of pixels above each row's edge, columns of width 1
};

} // namespace vesper
