// Where a view from anywhere enters the air, in the angles that tables of the sky are kept by.
#pragma once

#include "vesper/atmosphere/sky_query.hpp"

#include <optional>

namespace vesper {

/// A view from a place inside the air: the observer's, or where the view of one outside enters.
struct AirView {
  double height_km;
  double altitude_rad;       ///< of the view above the horizontal there
  double light_altitude_rad; ///< of the light above the same
  double cos_azimuth;        ///< of the view's azimuth from the light's
  double cos_angle;          ///< of the angle between view and light
  bool meets_ground;
  double ground_light_rad; ///< altitude of the light where the view meets the ground
  double distance_km;      ///< of that place from the observer, 0 inside the air
};

/// None for a view that passes the air by. Throws Error(argument) for a query out of its range.
[[nodiscard]] std::optional<AirView> view_in_air(const SkyQuery& query, double ground_km, double top_km);

} // namespace vesper
