// Directions on the sphere: their coordinates and the angles between them.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// The unit vector of a longitude, from x towards y, and a latitude, towards z.
[[nodiscard]] Vec3 unit_vector(double longitude_rad, double latitude_rad);

/// Angle of the point (x, y) from the x axis towards y, at least 0 and less than 360 degrees: a tiny negative angle
/// gives 0, not a whole turn.
[[nodiscard]] Angle whole_turn_atan2(double y, double x);

/// Latitude of a vector of any length, -90 to 90 degrees.
[[nodiscard]] Angle latitude_of(const Vec3& v);

/// The angle between two vectors of any length, 0 to 180 degrees, exact near both ends, where the arc cosine would lose
/// digits.
[[nodiscard]] Angle angle_between(const Vec3& a, const Vec3& b);

/// Position angle of `to` at `from`, unit vectors of the same equatorial axes: north through east, 0 to 360 degrees;
/// some finite angle where the two coincide or are opposite.
[[nodiscard]] Angle position_angle(const Vec3& from, const Vec3& to);

/// The axes of places on a disc around a direction of the horizon frame, along that frame's: columns, level, upward,
/// and the direction itself.
[[nodiscard]] Mat3 horizon_from_disc(const Vec3& direction);

} // namespace vesper
