// Precession, nutation and sidereal time against ERFA's complete theory, which the embedded table abridges.
#include "support/truth.hpp"

#include "vesper/astro/earth_state.hpp"
#include "vesper/astro/ephemeris_table.hpp"
#include "vesper/astro/nutation_series.hpp"

#include <erfa.h>
#include <gtest/gtest.h>

namespace vesper {
namespace {

using test::ErrorSum;

Instant instant_of(double jd_tt) {
  const double day = std::floor(jd_tt);
  return instant_from({day, jd_tt - day}, {day, jd_tt - day - 60.0 / 86400.0});
}

/// Every 7.3 days from 1900 to 2100.
template <class Visit> void for_dates(Visit visit) {
  for (double jd = 2415020.5; jd < 2488069.5; jd += 7.3) {
    visit(instant_of(jd));
  }
}

TEST(Nutation, SeriesMatchesTheCompleteTheory) {
  ErrorSum near;
  ErrorSum far;
  for (double year = -4712.0; year < 9999.0; year += 0.37) {
    const JulianDate<TT> tt{2451545.0, (year - 2000.0) * 365.25};
    double longitude = 0.0;
    double obliquity = 0.0;
    eraNut06a(tt.day, tt.fraction, &longitude, &obliquity);
    const Nutation ours = nutation_series(tt);
    ErrorSum& sum = year > 1600.0 && year < 2400.0 ? near : far;
    sum.add((std::hypot(ours.longitude_rad - longitude, ours.obliquity_rad - obliquity) * rad).to(arcsec));
  }
  near.hold("nutation by series, 1600 to 2400, against eraNut06a", 0.0001, "arcsec");
  far.hold("nutation by series, -4712 to 9999, against eraNut06a", 0.0001, "arcsec");
}

TEST(EarthOrientation, EquatorOfDateMatchesErfa) {
  ErrorSum errors;
  for_dates([&](const Instant& t) {
    double rows[3][3];
    eraPnm06a(t.tt.day, t.tt.fraction, rows);
    const Mat3 ours = earth_state(t, {}).equator_of_date_from_icrs;
    double squares = 0.0;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        squares += std::pow(ours[column][row] - rows[row][column], 2);
      }
    }
    errors.add((std::sqrt(0.5 * squares) * rad).to(arcsec)); // the angle between the two rotations
  });
  errors.hold("equator and equinox of date, 1900 to 2100, against eraPnm06a", 0.0001, "arcsec");
}

TEST(EarthOrientation, SiderealTimeMatchesErfa) {
  ErrorSum errors;
  for_dates([&](const Instant& t) {
    const double erfa = eraGst06a(t.ut1.day, t.ut1.fraction, t.tt.day, t.tt.fraction);
    errors.add(test::angle_difference(greenwich_apparent_sidereal_time_rad(t) * rad, erfa * rad).to(arcsec));
  });
  errors.hold("apparent sidereal time, 1900 to 2100, against eraGst06a", 0.0002, "arcsec");
}

/// Cassini's laws and the visible face: where the Moon's axes must lie, whatever the ephemeris.
TEST(LunarAngles, KeepCassinisLawsAndTheNearSide) {
  const EphemerisTable& table = EphemerisTable::embedded();
  const double obliquity = eraObl06(2451545.0, 0.0);
  const Vec3 ecliptic_pole(0.0, -std::sin(obliquity), std::cos(obliquity));
  ErrorSum inclination;
  ErrorSum longitude;
  ErrorSum latitude;
  for (double day = 0.0; day < 36525.0; day += 1.7) {
    const JulianDate<TDB> tdb{2436934.5, day};
    const auto angles = table.lunar_angles(tdb);
    ASSERT_TRUE(angles.has_value());
    const double sp = std::sin(angles->phi_rad);
    const double cp = std::cos(angles->phi_rad);
    const double st = std::sin(angles->theta_rad);
    const double ct = std::cos(angles->theta_rad);
    const Vec3 pole(sp * st, -cp * st, ct);
    const Vec3 node(cp, sp, 0.0);
    const Vec3 meridian = std::cos(angles->psi_rad) * node + std::sin(angles->psi_rad) * glm::cross(pole, node);
    inclination.add(test::separation(pole, ecliptic_pole).to(arcmin) - 92.6); // 1.543 degrees
    const Vec3 to_earth = glm::normalize(-table.sun_earth_moon(tdb)->moon.position_au);
    longitude.add(
        (std::atan2(glm::dot(to_earth, glm::cross(pole, meridian)), glm::dot(to_earth, meridian)) * rad).to(deg));
    latitude.add((std::asin(glm::dot(to_earth, pole)) * rad).to(deg));
  }
  inclination.print("inclination of the Moon's equator to the ecliptic less 92.6'", "arcmin");
  longitude.print("libration in longitude", "deg");
  latitude.print("libration in latitude", "deg");
  // The periodic terms of the pole's declination add up to 3.8' (Archinal et al. 2018, table 2); the principal axes lie
  // 1.3' off the mean-Earth ones.
  EXPECT_LT(inclination.worst(), 5.5);
  EXPECT_LT(longitude.worst(), 8.2);
  EXPECT_GT(longitude.worst(), 7.5);
  EXPECT_LT(latitude.worst(), 7.0);
  EXPECT_GT(latitude.worst(), 6.5);
}

} // namespace
} // namespace vesper
