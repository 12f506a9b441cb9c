// Reference frames against published directions and ERFA.
#include "support/truth.hpp"

#include "vesper/astro/frames.hpp"
#include "vesper/astro/star_frame.hpp"
#include "vesper/astro/star_place.hpp"

#include <erfa.h>
#include <gtest/gtest.h>

namespace vesper {
namespace {

using test::direction;
using test::ErrorSum;
using test::separation;
using test::TruthRow;

constexpr std::array all_frames{CelestialFrame::icrs,           CelestialFrame::mean_of_date,
                                CelestialFrame::true_of_date,   CelestialFrame::ecliptic_of_date,
                                CelestialFrame::ecliptic_j2000, CelestialFrame::galactic,
                                CelestialFrame::horizon};

EarthState state_at(const char* time, double latitude_deg, double longitude_deg) {
  return earth_state(parse_instant(time), {latitude_deg * deg, longitude_deg * deg, 0.0 * metre});
}

TEST(Frames, TurnBackAndForthAnywhere) {
  for (const char* time : {"-3000-01-01", "0000-01-01", "2026-08-12", "9999-12-31"}) {
    for (const double latitude : {-90.0, 0.0, 51.0, 90.0}) {
      const EarthState earth = state_at(time, latitude, 180.0);
      for (const CelestialFrame from : all_frames) {
        for (const CelestialFrame to : all_frames) {
          const Mat3 round = frame_rotation(to, from, earth) * frame_rotation(from, to, earth);
          for (int i = 0; i < 3; ++i) {
            Vec3 axis(0.0);
            axis[i] = 1.0;
            // The frame bias enters the long-term precession to first order: it turns orthogonal within 1e-14.
            EXPECT_NEAR(glm::length(round[i] - axis), 0.0, 1e-13) << time;
          }
          EXPECT_NEAR(glm::determinant(frame_rotation(from, to, earth)), 1.0, 1e-13);
        }
      }
    }
  }
}

TEST(Frames, GalacticPoleAndCentreStandWherePublished) {
  // Hipparcos and Tycho Catalogues vol. 1, sect. 1.5.3: pole 192.85948, 27.12825; the node's longitude 32.93192.
  const EarthState earth = state_at("2026-08-12", 0.0, 0.0);
  const Mat3 icrs_from_galactic = frame_rotation(CelestialFrame::galactic, CelestialFrame::icrs, earth);
  EXPECT_LT(separation(icrs_from_galactic[2], direction(192.85948 * deg, 27.12825 * deg)).to(arcsec), 1e-3);
  const Vec3 node = direction((192.85948 + 90.0) * deg, 0.0 * deg);
  EXPECT_NEAR(equatorial_of(glm::transpose(icrs_from_galactic) * node).right_ascension.to(deg), 32.93192, 1e-6);
  // Sagittarius A* (Reid and Brunthaler 2004): 266.416837, -29.007811 at longitude 359.94425, latitude -0.04616.
  EXPECT_LT(separation(icrs_from_galactic * direction(359.94425 * deg, -0.04616 * deg),
                       direction(266.416837 * deg, -29.007811 * deg))
                .to(arcsec),
            0.05);
}

TEST(Frames, AgreeWithErfaDirectionByDirection) {
  ErrorSum mean;
  ErrorSum ecliptic;
  const double ra = 1.2345;
  const double dec = -0.6789;
  const Vec3 icrs = direction(ra * rad, dec * rad);
  for (const char* time : {"1900-01-01", "1972-01-01", "2000-01-01", "2026-08-12", "2100-01-01"}) {
    const EarthState earth = state_at(time, 33.0, -70.0);
    const JulianDate<TT>& tt = earth.instant.tt;
    double matrix[3][3];
    eraPmat06(tt.day, tt.fraction, matrix);
    double in[3] = {icrs.x, icrs.y, icrs.z};
    double out[3];
    eraRxp(matrix, in, out);
    mean.add(
        separation(frame_from_icrs(CelestialFrame::mean_of_date, earth) * icrs, {out[0], out[1], out[2]}).to(arcsec));
    double dpsi = 0.0;
    double deps = 0.0;
    eraNut06a(tt.day, tt.fraction, &dpsi, &deps);
    double longitude = 0.0;
    double latitude = 0.0;
    // The mean ecliptic's longitude plus nutation in longitude.
    eraEqec06(tt.day, tt.fraction, ra, dec, &longitude, &latitude);
    ecliptic.add(separation(frame_from_icrs(CelestialFrame::ecliptic_of_date, earth) * icrs,
                            direction((longitude + dpsi) * rad, latitude * rad))
                     .to(arcsec));
  }
  mean.hold("mean equator of date, 1900 to 2100, against ERFA", 0.001, "arcsec");
  ecliptic.hold("ecliptic of date, 1900 to 2100, against ERFA", 0.002, "arcsec");
}

TEST(Frames, GiveTheSunsEclipticPlace) {
  const CsvTable table = test::truth_table("sun_topo.csv");
  ErrorSum ecliptic;
  ErrorSum horizon;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const EarthState earth = earth_state(row.instant(), row.observer());
    const Mat3 ecliptic_from_equator =
        frame_rotation(CelestialFrame::true_of_date, CelestialFrame::ecliptic_of_date, earth);
    ecliptic.add(separation(ecliptic_from_equator * direction(row.degrees("ra_geo"), row.degrees("dec_geo")),
                            direction(row.degrees("ecl_lon"), row.degrees("ecl_lat")))
                     .to(arcsec));
    const Mat3 horizon_from_equator_of_date =
        frame_rotation(CelestialFrame::true_of_date, CelestialFrame::horizon, earth);
    const Horizontal place =
        horizontal_of(horizon_from_equator_of_date * direction(row.degrees("ra"), row.degrees("dec")));
    horizon.add(separation(direction(place.azimuth, place.altitude), direction(row.degrees("az"), row.degrees("alt")))
                    .to(arcsec));
  }
  // The table's angles are rounded to 1e-6 degree, 0.0036 arcsec.
  ecliptic.hold("equator to ecliptic of date", 0.01, "arcsec");
  horizon.hold("equator to horizon", 0.01, "arcsec");
}

} // namespace
} // namespace vesper
