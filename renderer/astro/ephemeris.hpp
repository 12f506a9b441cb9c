// Places and velocities of the bodies of the solar system, geometric, along ICRS axes.
#pragma once

#include "vesper/astro/tier.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/vector.hpp"

#include <string_view>

namespace vesper {

/// Position in au and velocity in au a day along ICRS axes.
struct StateVector {
  Vec3 position_au{};
  Vec3 velocity_au_d{};
};

struct SunEarthMoon {
  StateVector sun;   ///< barycentric
  StateVector earth; ///< barycentric
  StateVector moon;  ///< from the centre of the Earth
};

enum class Planet { mercury, venus, mars, jupiter, saturn, uranus, neptune };
inline constexpr int planet_count = 7;
/// "mercury" to "neptune".
[[nodiscard]] std::string_view name_of(Planet planet);

/// Sun, Earth and Moon at one instant: by the table (ephemeris_table.hpp) from December 1959 to January 2060, except in
/// the cheap tier; else by series (ephemeris_series.hpp).
[[nodiscard]] SunEarthMoon sun_earth_moon(JulianDate<TDB> tdb, Tier tier = Tier::standard);

/// A planet (its system's barycentre for those with large moons) from the Sun, by table or series like sun_earth_moon.
[[nodiscard]] StateVector planet_heliocentric(Planet planet, JulianDate<TDB> tdb, Tier tier = Tier::standard);

} // namespace vesper
