// Constants of the Sun, the Earth and the Moon that more than one file reckons with.
#pragma once

#include "vesper/astro/time.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// Days that light takes for one au; times a velocity in au a day, that velocity in units of c (IAU 2012 au).
inline constexpr double light_time_d_per_au = 499.004783836156412 / seconds_per_day;

inline constexpr double earth_equatorial_radius_km = 6378.137;         ///< WGS84
inline constexpr double earth_polar_ratio = 1.0 - 1.0 / 298.257223563; ///< polar over equatorial radius, WGS84
inline constexpr Length moon_mean_radius = 1737.4 * kilometre;         ///< of its surface, IAU 2015
/// Sine of 959.63", the Sun's semidiameter at 1 au (Auwers 1891, used by all almanacs), times the au.
inline constexpr Length sun_radius = 4.652400744462013e-3 * astronomical_unit;

// Conventions of eclipse predictions.

/// The Moon's mean limb over the Earth's equatorial radius (IAU 1982).
inline constexpr double moon_radius_ratio = 0.2725076;
/// The same to the bottom of the valleys at the limb, where the last sunlight of a total eclipse passes.
inline constexpr double moon_valley_radius_ratio = 0.272281;
/// The north pole of the ecliptic of J2000 along ICRS axes (obliquity 84381.406", IAU 2006), within a degree of that of
/// any year from -4712 to 9999: on which side of it a shadow passes tells the sign of gamma.
inline const Vec3 ecliptic_north_icrs{0.0, -0.397776991, 0.917482137};

// Conventions of rise and set in almanacs (Explanatory Supplement, 3rd ed., sec. 12.2.1).

inline constexpr Angle almanac_refraction = 34.0 * arcmin; ///< at the horizon
inline constexpr Angle almanac_sun_semidiameter = 16.0 * arcmin;
/// Airless altitude of the Sun's centre when its upper limb stands on the horizon.
inline constexpr Angle almanac_sunrise_altitude = -(almanac_refraction + almanac_sun_semidiameter);

/// Airless altitudes of the Sun's centre at which the twilights end.
inline constexpr Angle civil_twilight_end = -6.0 * deg;
inline constexpr Angle nautical_twilight_end = -12.0 * deg;
inline constexpr Angle astronomical_twilight_end = -18.0 * deg;

} // namespace vesper
