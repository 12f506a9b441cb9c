// Sun and Moon against JPL DE431, inside the embedded table's span and outside.
#include "accuracy/truth.hpp"

#include "vesper/astro/ephemeris_table.hpp"
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

enum class Where { inside, outside };

Where where(const Instant& instant) {
  return EphemerisTable::embedded().covers(tdb_from_tt(instant.tt)) ? Where::inside : Where::outside;
}

PlaceErrors sun_errors(Where wanted) {
  const CsvTable table = test::truth_table("sun_topo.csv");
  PlaceErrors errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const Instant instant = row.instant();
    if (where(instant) == wanted) {
      errors.add(sky_state(instant, row.observer()).sun, row, row.number("dist_au") * astronomical_unit);
    }
  }
  return errors;
}

struct MoonErrors {
  PlaceErrors place;
  ErrorSum fraction, phase_arcsec, limb_arcsec;

  void print(const char* body) const {
    place.print(body);
    fraction.print("  illuminated fraction", "");
    phase_arcsec.print("  phase angle", "arcsec");
    limb_arcsec.print("  bright limb times sine of phase", "arcsec");
  }
};

MoonErrors moon_errors(Where wanted) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  MoonErrors errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const Instant instant = row.instant();
    if (where(instant) != wanted) {
      continue;
    }
    const MoonState moon = sky_state(instant, row.observer()).moon;
    errors.place.add(moon.place, row, row.number("dist_km") * kilometre);
    errors.fraction.add(moon.illuminated_fraction - row.number("illum"));
    errors.phase_arcsec.add((moon.phase_angle - row.degrees("phase_angle")).to(arcsec));
    // Near new and full Moon the limb's angle turns as fast as the Moon's error is large against its distance from the
    // line: the error is weighed by that distance.
    const double weight = std::sin(moon.phase_angle.to(rad));
    errors.limb_arcsec.add(weight * test::angle_difference(moon.bright_limb, row.degrees("pa_bright_limb")).to(arcsec));
  }
  return errors;
}

TEST(Sun, MatchesTheReferenceEphemerisInsideTheTable) {
  const PlaceErrors errors = sun_errors(Where::inside);
  errors.print("Sun, 1960 to 2059");
  ASSERT_GT(errors.equatorial.count(), 80U);
  EXPECT_LT(errors.equatorial.worst(), 0.1);
  EXPECT_LT(errors.horizontal.worst(), 0.1);
  EXPECT_LT(errors.distance_km.worst(), 5.0);
}

TEST(Sun, MatchesTheReferenceEphemerisOutsideTheTable) {
  const PlaceErrors errors = sun_errors(Where::outside);
  errors.print("Sun, before 1960 and after 2059");
  ASSERT_GT(errors.equatorial.count(), 80U);
  EXPECT_LT(errors.equatorial.worst(), 0.05);
  EXPECT_LT(errors.horizontal.worst(), 0.05);
  EXPECT_LT(errors.distance_km.worst(), 20.0);
}

TEST(Moon, MatchesTheReferenceEphemerisInsideTheTable) {
  const MoonErrors errors = moon_errors(Where::inside);
  errors.print("Moon, 1960 to 2059");
  ASSERT_GT(errors.place.equatorial.count(), 80U);
  EXPECT_LT(errors.place.equatorial.worst(), 0.1);
  EXPECT_LT(errors.place.horizontal.worst(), 0.1);
  EXPECT_LT(errors.place.distance_km.worst(), 1.0);
  EXPECT_LT(errors.fraction.worst(), 1e-6);
  EXPECT_LT(errors.phase_arcsec.worst(), 0.1);
  EXPECT_LT(errors.limb_arcsec.worst(), 0.1);
}

TEST(Moon, MatchesTheReferenceEphemerisOutsideTheTable) {
  const MoonErrors errors = moon_errors(Where::outside);
  errors.print("Moon, before 1960 and after 2059");
  ASSERT_GT(errors.place.equatorial.count(), 80U);
  EXPECT_LT(errors.place.equatorial.worst(), 15.0);
  EXPECT_LT(errors.place.equatorial.rms(), 6.0);
  EXPECT_LT(errors.place.horizontal.worst(), 15.0);
  EXPECT_LT(errors.place.distance_km.worst(), 40.0);
  EXPECT_LT(errors.fraction.worst(), 1e-4);
  EXPECT_LT(errors.phase_arcsec.worst(), 20.0);
  EXPECT_LT(errors.limb_arcsec.worst(), 20.0);
}

TEST(Moon, HoldsFromTheStampToo) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  ErrorSum inside;
  ErrorSum outside;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const Instant stamp = row.stamp();
    const BodyPlace place = sky_state(stamp, row.observer()).moon.place;
    (where(stamp) == Where::inside ? inside : outside)
        .add(test::separation(test::direction(place.azimuth, place.altitude),
                              test::direction(row.degrees("az"), row.degrees("alt")))
                 .to(arcsec));
  }
  inside.print("Moon from the stamp, azimuth and altitude, 1960 to 2059", "arcsec");
  outside.print("Moon from the stamp, azimuth and altitude, before and after", "arcsec");
  EXPECT_LT(inside.worst(), 0.5); // 0.03 s of Delta-T, which is a prediction after 2026
  EXPECT_LT(outside.worst(), 15.0);
}

} // namespace
} // namespace vesper
