// Sun and Moon against JPL DE431.
#include "accuracy/truth.hpp"

#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

namespace vesper {
namespace {

using test::ErrorSum;
using test::TruthRow;

struct PlaceErrors {
  ErrorSum equatorial, horizontal, distance_km;

  void add(const BodyPlace& place, const TruthRow& row, Length distance) {
    equatorial.add(test::separation(test::direction(place.right_ascension, place.declination),
                                    test::direction(row.degrees("ra"), row.degrees("dec")))
                       .to(arcsec));
    horizontal.add(test::separation(test::direction(place.azimuth, place.altitude),
                                    test::direction(row.degrees("az"), row.degrees("alt")))
                       .to(arcsec));
    distance_km.add((place.distance - distance).to(kilometre));
  }
  void print(const char* body) const {
    std::printf("%s\n", body);
    equatorial.print("  RA and Dec", "arcsec");
    horizontal.print("  azimuth and altitude", "arcsec");
    distance_km.print("  distance", "km");
  }
};

TEST(Sun, MatchesTheReferenceEphemeris) {
  const CsvTable table = test::truth_table("sun_topo.csv");
  PlaceErrors errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    errors.add(sky_state(row.instant(), row.observer()).sun, row, row.number("dist_au") * astronomical_unit);
  }
  errors.print("Sun by eraEpv00");
  ASSERT_EQ(errors.equatorial.count(), 200U);
  EXPECT_LT(errors.equatorial.worst(), 0.05);
  EXPECT_LT(errors.horizontal.worst(), 0.05);
  EXPECT_LT(errors.distance_km.worst(), 20.0);
}

TEST(Moon, MatchesTheReferenceEphemeris) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  PlaceErrors errors;
  ErrorSum fraction;
  ErrorSum phase;
  ErrorSum limb;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const MoonState moon = sky_state(row.instant(), row.observer()).moon;
    errors.add(moon.place, row, row.number("dist_km") * kilometre);
    fraction.add(moon.illuminated_fraction - row.number("illum"));
    phase.add((moon.phase_angle - row.degrees("phase_angle")).to(arcsec));
    // Near new and full Moon the limb's angle turns as fast as the Moon's error is large against its distance from the
    // line: the error is weighed by that distance.
    const double weight = std::sin(moon.phase_angle.to(rad));
    limb.add(weight * test::angle_difference(moon.bright_limb, row.degrees("pa_bright_limb")).to(arcsec));
  }
  errors.print("Moon by eraMoon98");
  fraction.print("  illuminated fraction", "");
  phase.print("  phase angle", "arcsec");
  limb.print("  bright limb times sine of phase", "arcsec");
  ASSERT_EQ(errors.equatorial.count(), 200U);
  EXPECT_LT(errors.equatorial.worst(), 15.0);
  EXPECT_LT(errors.equatorial.rms(), 6.0);
  EXPECT_LT(errors.horizontal.worst(), 15.0);
  EXPECT_LT(errors.distance_km.worst(), 40.0);
  EXPECT_LT(fraction.worst(), 1e-4);
  EXPECT_LT(phase.worst(), 20.0);
  EXPECT_LT(limb.worst(), 20.0);
}

TEST(SunAndMoon, HoldFromTheStampToo) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  ErrorSum errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const BodyPlace place = sky_state(row.stamp(), row.observer()).moon.place;
    errors.add(test::separation(test::direction(place.azimuth, place.altitude),
                                test::direction(row.degrees("az"), row.degrees("alt")))
                   .to(arcsec));
  }
  errors.print("Moon from the stamp, azimuth and altitude", "arcsec");
  EXPECT_LT(errors.worst(), 15.0);
}

} // namespace
} // namespace vesper
