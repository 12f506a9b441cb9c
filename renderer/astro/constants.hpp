// Conventions of eclipse predictions: sizes of the bodies, and which side is north.
#pragma once

#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

inline constexpr double earth_equatorial_radius_km = 6378.137; ///< WGS84
/// Sine of 959.63", the Sun's semidiameter at 1 au (Auwers 1891, used by all almanacs), times the au.
inline constexpr double eclipse_sun_radius_km = 4.652400744462013e-3 * astronomical_unit.to(kilometre);
/// The Moon's mean limb over the Earth's equatorial radius (IAU 1982).
inline constexpr double moon_radius_ratio = 0.2725076;
/// The same to the bottom of the valleys at the limb, where the last sunlight of a total eclipse passes.
inline constexpr double moon_valley_radius_ratio = 0.272281;
/// The north pole of the ecliptic of J2000 along ICRS axes (obliquity 84381.406", IAU 2006), within a degree of that of
/// any year from -4712 to 9999: on which side of it a shadow passes tells the sign of gamma.
inline const Vec3 ecliptic_north_icrs{0.0, -0.397776991, 0.917482137};

} // namespace vesper
