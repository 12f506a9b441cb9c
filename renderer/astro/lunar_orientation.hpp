// How the Moon is turned in space, in the axes of lunar maps.
//
// Mean-Earth (ME) axes: z is the mean axis of rotation, x points to the mean place of the Earth; selenographic
// longitude counts from x, positive towards Mare Crisium. The principal axes of inertia, in which libration is
// integrated, lie about 1' beside them.
#pragma once

#include "vesper/astro/ephemeris_table.hpp"
#include "vesper/astro/tier.hpp"
#include "vesper/astro/time.hpp"
#include "vesper/base/units.hpp"
#include "vesper/base/vector.hpp"

namespace vesper {

/// ME axes from ICRS by the angles of DE403 or DE405. The turn between principal and ME axes,
/// R_x(-0.1462") R_y(-79.0768") R_z(-63.8986"), is that of DE403 (Konopliv et al. 2001, Icarus 150, 1).
[[nodiscard]] Mat3 mean_earth_from_icrs(const LunarAngles& angles);

/// ME axes from ICRS by the series of the IAU working group on cartographic coordinates (Archinal et al. 2011, Celest.
/// Mech. 109, 101, table 2), pole and prime meridian with 13 periodic terms, which is within 0.005 degrees of DE405.
/// The next terms, free librations among them, bring it within 0.002 degrees from 1960 to 2060 (0.03 arcsec as seen
/// from the Earth). The neglected quadratic motion of the pole grows to 0.1 degrees 5000 years from J2000.
[[nodiscard]] Mat3 mean_earth_from_icrs(JulianDate<TDB> tdb);

/// ME axes from ICRS: DE405's where the embedded table reaches (0.0003 degrees), else and in the cheap tier the series.
[[nodiscard]] Mat3 moon_fixed_from_icrs(JulianDate<TDB> tdb, Tier tier = Tier::standard);

struct Selenographic {
  Angle longitude; ///< -180 to 180 degrees, east (Crisium) positive
  Angle latitude;
};
/// Where a vector of any length along ME axes points.
[[nodiscard]] Selenographic selenographic_of(const Vec3& v);
/// The unit vector along ME axes.
[[nodiscard]] Vec3 direction_of(const Selenographic& place);

} // namespace vesper
