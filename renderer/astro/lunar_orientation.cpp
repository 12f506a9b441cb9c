#include "vesper/astro/lunar_orientation.hpp"

#include "vesper/astro/rotation.hpp"
#include "vesper/astro/spherical.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace vesper {
namespace {

/// An argument of the series and what it adds, degrees: E = start + rate * days since J2000.0.
struct Term {
  double start, rate_day;
  double pole_ra_sin, pole_dec_cos, meridian_sin;
};
constexpr std::array<Term, 13> terms{{
    {125.045, -0.0529921, -3.8787, 1.5419, 3.5610},
    {250.089, -0.1059842, -0.1204, 0.0239, 0.1208},
    {260.008, 13.0120009, 0.0700, -0.0278, -0.0642},
    {176.625, 13.3407154, -0.0172, 0.0068, 0.0158},
    {357.529, 0.9856003, 0.0, 0.0, 0.0252},
    {311.589, 26.4057084, 0.0072, -0.0029, -0.0066},
    {134.963, 13.0649930, 0.0, 0.0009, -0.0047},
    {276.617, 0.3287146, 0.0, 0.0, -0.0046},
    {34.226, 1.7484877, 0.0, 0.0, 0.0028},
    {15.134, -0.1589763, -0.0052, 0.0008, 0.0052},
    {119.743, 0.0036096, 0.0, 0.0, 0.0040},
    {239.961, 0.1643573, 0.0, 0.0, 0.0019},
    {25.053, 12.9590088, 0.0043, -0.0009, -0.0044},
}};

/// A small turn of the ME axes that the series leaves out: arcsec about x with the cosine, about y and z with the sine
/// of start + rate * days since J2000.0.
struct Turn {
  double start, rate_day;
  double x_cos, y_sin, z_sin;
};
/// Those above 0.4 arcsec in DE405, 1960 to 2060, by least squares (data/fit_lunar_turns.py). Arguments are sums of
/// Delaunay's, but for the free wobble (74.6 years) and the free libration in longitude (2.89 years), whose periods are
/// those of Rambaux and Williams 2011 (Celest. Mech. 109, 85).
constexpr std::array<Turn, 15> turns{{
    {-19.1, 0.0132073, 8.17, 3.29, 0.0},      // wobble
    {53.9, 0.3408672, 0.0, 0.0, 2.55},        // free libration
    {142.4283, 11.1521480, 3.18, -2.88, 0.0}, // 2D - F
    {352.5352, 1.9128449, 1.66, -2.73, 0.0},  // l + F - 2D
    {228.2355, 26.2943432, -0.53, 1.81, 0.0}, // l + F
    {93.2721, 13.2293502, 1.25, 0.0, 0.0},    // F
    {180.4, 13.0649930, 1.02, -1.02, 0.0},    // l
    {250.0891, -0.1059075, -0.60, 0.67, 0.0}, // 2 node
    {340.0891, -0.1059075, 0.0, 0.0, -0.64},  // 2 node + 90
    {189.6, -0.0529538, 0.0, 0.0, 0.84},      // node
    {100.7370, 11.3165053, 0.0, 0.0, 4.10},   // 2D - l
    {197.1132, 0.8742438, 0.0, 0.0, 3.45},    // l - D
    {310.8438, 2.0772022, 0.0, 0.0, -1.69},   // 2F - 2D
    {235.7004, 24.3814982, 0.0, 0.0, 0.48},   // 2D
    {269.9268, 26.1299859, 0.0, 0.0, 0.45},   // 2l
}};

Mat3 small_turns(double days) {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  for (const Turn& turn : turns) {
    const double argument = ((turn.start + turn.rate_day * days) * deg).to(rad);
    const double sine = std::sin(argument);
    x += turn.x_cos * std::cos(argument);
    y += turn.y_sin * sine;
    z += turn.z_sin * sine;
  }
  return turn_x((x * arcsec).to(rad)) * turn_y((y * arcsec).to(rad)) * turn_z((z * arcsec).to(rad));
}

} // namespace

Mat3 mean_earth_from_icrs(const LunarAngles& angles) {
  static const Mat3 mean_earth_from_principal =
      turn_x((0.1462 * arcsec).to(rad)) * turn_y((79.0768 * arcsec).to(rad)) * turn_z((63.8986 * arcsec).to(rad));
  return mean_earth_from_principal * turn_z(-angles.psi_rad) * turn_x(-angles.theta_rad) * turn_z(-angles.phi_rad);
}

Mat3 mean_earth_from_icrs(JulianDate<TDB> tdb) {
  const double days = tdb.days_since(j2000<TDB>);
  const double centuries = centuries_since_j2000(tdb);
  double pole_ra = 269.9949 + 0.0031 * centuries;
  double pole_dec = 66.5392 + 0.0130 * centuries;
  double meridian = 38.3213 + 13.17635815 * days - 1.4e-12 * days * days;
  for (const Term& term : terms) {
    const double argument = ((term.start + term.rate_day * days) * deg).to(rad);
    const double sine = std::sin(argument);
    pole_ra += term.pole_ra_sin * sine;
    pole_dec += term.pole_dec_cos * std::cos(argument);
    meridian += term.meridian_sin * sine;
  }
  return small_turns(days) * turn_z((-meridian * deg).to(rad)) * turn_x(((pole_dec - 90.0) * deg).to(rad)) *
         turn_z(((-90.0 - pole_ra) * deg).to(rad));
}

Mat3 moon_fixed_from_icrs(JulianDate<TDB> tdb, Tier tier) {
  if (tier != Tier::cheap) {
    if (const std::optional<LunarAngles> angles = EphemerisTable::embedded().lunar_angles(tdb)) {
      return mean_earth_from_icrs(*angles);
    }
  }
  return mean_earth_from_icrs(tdb);
}

Selenographic selenographic_of(const Vec3& v) { return {std::atan2(v.y, v.x) * rad, latitude_of(v)}; }

Vec3 direction_of(const Selenographic& place) { return unit_vector(place.longitude.to(rad), place.latitude.to(rad)); }

} // namespace vesper
