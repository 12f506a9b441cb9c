// Maps of a made-up Moon: grids from functions of direction, and elevation grids with their labels as files hold them.
#pragma once

#include "vesper/base/files.hpp"
#include "vesper/base/vector.hpp"
#include "vesper/catalog_tools/globe_grid.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

namespace vesper::test {

/// The direction of a pixel's centre.
inline Vec3 pixel_direction(const GlobeGrid& grid, int column, int row) {
  const double step = std::numbers::pi / grid.height;
  const double longitude = grid.west_edge_deg * std::numbers::pi / 180.0 + (column + 0.5) * step;
  const double latitude = 0.5 * std::numbers::pi - (row + 0.5) * step;
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

/// A grid of a function of direction.
template <class Function> GlobeGrid globe_grid(int height, double west_edge_deg, const Function& value) {
  GlobeGrid grid{2 * height, height, west_edge_deg, {}};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      grid.values.push_back(static_cast<float>(value(pixel_direction(grid, column, row))));
    }
  }
  return grid;
}

/// The label of a grid of 16-bit samples in half metres above 1737.4 km, from longitude 0.
inline std::string elevation_label(const std::string& image, int lines,
                                   const std::string& sample_type = "LSB_INTEGER") {
  return fmt::format("PDS_VERSION_ID = \"PDS3\"\r\n"
                     "/* of a Moon that is made up */\r\n"
                     "OBJECT = UNCOMPRESSED_FILE\r\n"
                     "  ^IMAGE = \"{}\"\r\n"
                     "  OBJECT = IMAGE\r\n"
                     "    DESCRIPTION = \"Heights,\r\n      MINIMUM = 7 is no statement here\"\r\n"
                     "    LINES = {}\r\n"
                     "    LINE_SAMPLES = {}\r\n"
                     "    SAMPLE_TYPE = {}\r\n"
                     "    SAMPLE_BITS = 16\r\n"
                     "    UNIT = METER\r\n"
                     "    SCALING_FACTOR = 0.5\r\n"
                     "    OFFSET = 1737400.\r\n"
                     "    MISSING_CONSTANT = -32768\r\n"
                     "  END_OBJECT = IMAGE\r\n"
                     "END_OBJECT = UNCOMPRESSED_FILE\r\n"
                     "OBJECT = IMAGE_MAP_PROJECTION\r\n"
                     "  MAP_PROJECTION_TYPE = \"SIMPLE CYLINDRICAL\"\r\n"
                     "  MAP_RESOLUTION = {} <pix/deg>\r\n"
                     "  A_AXIS_RADIUS = 1737.4 <km>\r\n"
                     "  POSITIVE_LONGITUDE_DIRECTION = \"EAST\"\r\n"
                     "  MAXIMUM_LATITUDE = 90 <deg>\r\n"
                     "  MINIMUM_LATITUDE = -90 <deg>\r\n"
                     "  WESTERNMOST_LONGITUDE = 0 <deg>\r\n"
                     "  EASTERNMOST_LONGITUDE = 360 <deg>\r\n"
                     "END_OBJECT = IMAGE_MAP_PROJECTION\r\n"
                     "END\r\n",
                     image, lines, 2 * lines, sample_type, lines / 180.0);
}

/// Samples of half a metre; NaN becomes MISSING_CONSTANT.
inline std::string elevation_samples(const GlobeGrid& grid, bool big_endian = false) {
  std::string bytes;
  for (const float height : grid.values) {
    const auto value =
        std::isnan(height) ? std::int16_t{-32768} : static_cast<std::int16_t>(std::lround(2.0F * height));
    const auto bits = std::bit_cast<std::uint16_t>(value);
    const char low = static_cast<char>(bits & 0xFFU);
    const char high = static_cast<char>(bits >> 8U);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

/// `text` with the first `from` replaced; `from` must be there.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to); // npos throws
}

} // namespace vesper::test
