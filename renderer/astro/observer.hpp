#pragma once

#include "vesper/base/units.hpp"

namespace vesper {

/// A place on the Earth, on the WGS84 ellipsoid.
struct Observer {
  Angle latitude;  ///< geodetic, -90 to 90 degrees, north positive
  Angle longitude; ///< -180 to 360 degrees, east positive
  Length height;   ///< above the ellipsoid
};

} // namespace vesper
