// Eclipses of the Sun against figures from JPL DE431 and the Five Millennium Canon.
#include "support/truth.hpp"

#include "vesper/astro/local_solar_eclipse.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace vesper {
namespace {

using test::ErrorSum;
using test::seconds_between;
using test::TruthRow;

SolarEclipseType type_of(char letter) {
  return letter == 'T'   ? SolarEclipseType::total
         : letter == 'A' ? SolarEclipseType::annular
         : letter == 'H' ? SolarEclipseType::hybrid
                         : SolarEclipseType::partial;
}

TEST(SolarEclipse, MatchesTheReference) {
  const CsvTable table = test::truth_table("eclipses_solar.csv");
  ErrorSum gamma, greatest, distance_km;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    SCOPED_TRACE(row.text("canon_date"));
    const SolarEclipse eclipse = solar_eclipse_near(row.instant());
    const std::string canon_type = row.text("canon_type");
    EXPECT_EQ(name_of(eclipse.type), name_of(type_of(canon_type.front())));
    // '+' and '-' mark umbrae whose axis misses the Earth.
    EXPECT_EQ(eclipse.central, canon_type.front() != 'P' && canon_type.find_first_of("+-") == std::string::npos);
    if (!row.in_table_years()) {
      continue;
    }
    gamma.add(eclipse.gamma - row.number("gamma"));
    greatest.add(seconds_between(eclipse.greatest, row.instant()));
    if (eclipse.central) {
      // The canon's longitudes belong to its own Delta-T: the Earth has turned on by the difference. Where the axis
      // misses, the canon gives geocentric latitudes.
      const double turned_deg = (row.number("canon_deltat") - row.number("delta_t")) * 360.0 * 1.0027379 / 86400.0;
      const Vec3 canon = test::direction((row.number("canon_lon") - turned_deg) * deg, row.degrees("canon_lat"));
      const Vec3 found = test::direction(eclipse.place.longitude, eclipse.place.latitude);
      distance_km.add(6371.0 * test::separation(canon, found).to(rad));
    }
  }
  gamma.hold("gamma", 0.0001, "Earth radii");
  greatest.hold("greatest eclipse", 2.0, "s");
  distance_km.hold("place of greatest eclipse, against figures rounded to 0.1 degree", 12.0,
                   "km"); // the diagonal of 0.05 degree by 0.05 degree and 0.5 s
  EXPECT_GE(gamma.count(), 100U);
}

TEST(SolarEclipse, LocalCircumstancesMatchTheReference) {
  const CsvTable table = test::truth_table("eclipses_solar_local.csv");
  ErrorSum outer, inner, inner_valleys, altitude, azimuth, magnitude, obscuration, ratio, angle;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    SCOPED_TRACE(row.text("place"));
    // Stamps are UTC, before 1972 UT1; the row's own Delta-T turns the Earth.
    const auto stamp = [&](const char* column) {
      const Instant t = parse_instant(row.text(column));
      const double turn = row.number("delta_t") / 86400.0;
      return t.note.empty() ? instant_from(t.tt, {t.tt.day, t.tt.fraction - turn})
                            : instant_from({t.ut1.day, t.ut1.fraction + turn}, t.ut1);
    };
    const Instant maximum = stamp("max");
    const SolarEclipse whole = solar_eclipse_near(maximum);
    const LocalSolarEclipse local = local_solar_eclipse(whole.greatest, row.observer());
    const LocalSolarEclipse valleys = local_solar_eclipse(whole.greatest, row.observer(), moon_valley_radius_ratio);
    EXPECT_EQ(name_of(local.type), row.text("type"));
    EXPECT_TRUE(local.sun_up);
    outer.add(seconds_between(local.maximum.instant, maximum));
    const auto compare = [&](const LocalSolarEclipse& eclipse, SolarContact contact, const char* column,
                             ErrorSum& errors) {
      const auto& found = eclipse.contact(contact);
      ASSERT_EQ(found.has_value(), !row.text(column).empty()) << column;
      if (found) {
        errors.add(seconds_between(found->instant, stamp(column)));
      }
    };
    compare(local, SolarContact::c1, "C1", outer);
    compare(local, SolarContact::c2, "C2_k2725076", inner);
    compare(local, SolarContact::c3, "C3_k2725076", inner);
    compare(local, SolarContact::c4, "C4", outer);
    compare(valleys, SolarContact::c2, "C2_k272281", inner_valleys);
    compare(valleys, SolarContact::c3, "C3_k272281", inner_valleys);
    altitude.add((local.maximum.sun_altitude - row.degrees("max_sun_alt")).to(deg));
    azimuth.add(test::angle_difference(local.maximum.sun_azimuth, row.degrees("max_sun_az")).to(deg));
    altitude.add((local.contact(SolarContact::c1)->sun_altitude - row.degrees("C1_sun_alt")).to(deg));
    altitude.add((local.contact(SolarContact::c4)->sun_altitude - row.degrees("C4_sun_alt")).to(deg));
    magnitude.add(local.state.magnitude - row.number("magnitude"));
    obscuration.add(local.state.obscuration - row.number("obscuration"));
    ratio.add(local.ratio - row.number("ratio"));
    angle.add(test::angle_difference(local.position_angle, row.degrees("pa_moon_from_sun")).to(deg));
  }
  outer.hold("C1, maximum, C4", 2.0, "s");
  inner.hold("C2, C3", 4.0, "s");
  inner_valleys.hold("C2, C3 with k = 0.272281", 4.0, "s");
  altitude.hold("Sun's altitude", 0.005, "degrees");
  azimuth.hold("Sun's azimuth", 0.02, "degrees");
  magnitude.hold("magnitude", 0.0002, "");
  obscuration.hold("obscuration", 0.0002, "");
  ratio.hold("ratio of diameters", 0.00002, "");
  angle.hold("position angle", 0.5, "degrees");
  EXPECT_EQ(ratio.count(), table.row_count());
}

TEST(SolarEclipse, TheSearchFindsEachOnce) {
  const CsvTable table = test::truth_table("eclipses_solar.csv");
  const auto start = std::chrono::steady_clock::now();
  const std::vector<SolarEclipse> found = solar_eclipses(parse_instant("1950-01-01"), parse_instant("2051-01-01"));
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  std::printf("%zu solar eclipses from 1950 to 2050 in %.1f ms\n", found.size(), ms);
  // The canon numbers all eclipses; the table holds every second one, the first and the last among them.
  const auto number = [&](std::size_t i) { return static_cast<std::size_t>(TruthRow(table, i).number("canon_no")); };
  ASSERT_EQ(found.size(), number(table.row_count() - 1) - number(0) + 1);
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    EXPECT_LT(std::abs(seconds_between(found.at(number(i) - number(0)).greatest, row.instant())), 60.0)
        << row.text("canon_date");
  }
}

} // namespace
} // namespace vesper
