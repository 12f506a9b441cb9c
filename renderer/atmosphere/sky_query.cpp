#include "vesper/atmosphere/sky_query.hpp"

#include "vesper/base/error.hpp"

#include <cmath>
#include <string>

namespace vesper {

void validate(const SkyQuery& query) {
  const double height_km = query.height.to(kilometre);
  if (!(height_km >= 0.0) || !std::isfinite(height_km)) {
    throw Error(ErrorKind::argument, "an observer " + std::to_string(height_km) + " km above the ground",
                {"", "", "Give a finite height of 0 or more"});
  }
  constexpr double tolerance = 1.0e-9;
  for (const Vec3& direction : {query.light_direction, query.view_direction}) {
    if (!(std::abs(glm::length(direction) - 1.0) <= tolerance)) {
      throw Error(ErrorKind::argument, "a direction of length " + std::to_string(glm::length(direction)),
                  {"", "", "Give vectors of unit length"});
    }
  }
  const double radius_deg = query.light_angular_radius.to(deg);
  if (!(radius_deg >= 0.0 && radius_deg <= 1.0)) {
    throw Error(ErrorKind::argument, "a light of " + std::to_string(radius_deg) + " degrees radius",
                {"", "", "Give 0 to 1 degree"});
  }
}

} // namespace vesper
