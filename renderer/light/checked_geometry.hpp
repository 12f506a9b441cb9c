// Phase angles and distances of lit bodies, held to their ranges.
#pragma once

#include "vesper/base/units.hpp"

namespace vesper {

/// In degrees. Throws Error(argument), which says whose, unless it is 0 to 180 degrees.
[[nodiscard]] double checked_phase_degrees(const char* whose, Angle phase_angle);

/// Throws Error(argument), which says what, unless the distance is positive and finite.
void hold_positive_distance(const char* what, Length distance);

} // namespace vesper
