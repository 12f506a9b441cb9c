#include "vesper/light/checked_geometry.hpp"

#include "vesper/base/error.hpp"

#include <cmath>
#include <string>

namespace vesper {

double checked_phase_degrees(const char* whose, Angle phase_angle) {
  const double degrees = phase_angle.to(deg);
  if (!(degrees >= 0.0 && degrees <= 180.0)) {
    throw Error(ErrorKind::argument, std::string(whose) + " phase angle of " + std::to_string(degrees) + " degrees",
                {"", "", "Give 0 to 180"});
  }
  return degrees;
}

void hold_positive_distance(const char* what, Length distance) {
  if (!(distance > 0.0 * metre) || !std::isfinite(distance.to(metre))) {
    throw Error(ErrorKind::argument, std::string(what) + " of " + std::to_string(distance.to(kilometre)) + " km",
                {"", "", "Give a positive distance"});
  }
}

} // namespace vesper
