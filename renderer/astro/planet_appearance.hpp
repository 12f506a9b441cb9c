// How a planet looks from where it is seen: phase, size, magnitude.
#pragma once

#include "vesper/astro/ephemeris.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

#include <limits>

namespace vesper {

/// Share, 0 to 1, of a sphere's disc that the Sun lights.
/// \param phase_angle Sun-sphere-observer, 0 to 180 degrees
[[nodiscard]] double illuminated_fraction(Angle phase_angle);

struct PlanetAppearance {
  Angle phase_angle;                 ///< Sun-planet-observer, 0 to 180 degrees
  double illuminated_fraction = 0.0; ///< of the disc, 0 to 1
  Angle diameter;                    ///< of a sphere with the globe's volume
  Angle equatorial_diameter;
  double magnitude = std::numeric_limits<double>::infinity(); ///< V above the atmosphere, Saturn with its rings
};

/// \param from_observer_au, from_sun_au vectors to the planet when its light left it, along ICRS axes
/// \param tdb for the planets' poles and the slow brightening of Neptune
///
/// Radii and poles after Archinal et al. 2018 (Celest. Mech. 130, 22). Magnitudes after Mallama and Hilton 2018
/// (Astronomy and Computing 25, 10), eq. 2 to 17, with the planets' mean faces: the terms for the face that Mars turns
/// to us and for its seasons, which add up to 0.1 magnitudes either way, are left out. Observed up to phase angles of
/// 170 degrees for Mercury and 179 for Venus; the outer planets' formulas are held at their last value beyond the
/// angles at which the Earth sees them (Mars 50, Jupiter 12, Saturn 6.5, Uranus 3.1 degrees).
[[nodiscard]] PlanetAppearance planet_appearance(Planet planet, const Vec3& from_observer_au, const Vec3& from_sun_au,
                                                 JulianDate<TDB> tdb);

} // namespace vesper
