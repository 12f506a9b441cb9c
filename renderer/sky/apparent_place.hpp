// Where a body appears.
#pragma once

#include "vesper/astro/star_frame.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// Apparent topocentric place of a body: true equator and equinox of date, airless.
struct BodyPlace {
  Angle right_ascension;
  Angle declination;
  Angle azimuth;               ///< north through east
  Angle altitude;              ///< airless
  Length distance;             ///< from the observer now to the body when the light left it
  Vec3 direction_equatorial{}; ///< unit vector, true equator and equinox of date
  Vec3 direction_horizon{};    ///< unit vector, x = East, y = North, z = zenith
};

/// \param from_observer_au to the body when its light left it, along ICRS axes, before aberration
[[nodiscard]] BodyPlace apparent_place(const Vec3& from_observer_au, const StarFrame& frame);

/// Apparent direction alone: a unit vector, true equator and equinox of date.
[[nodiscard]] Vec3 apparent_equatorial(const Vec3& from_observer_au, const StarFrame& frame);

} // namespace vesper
