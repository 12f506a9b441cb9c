// Sidereal time and Delta-T against outside figures.
#include "support/truth.hpp"

#include "vesper/astro/delta_t.hpp"
#include "vesper/astro/earth_state.hpp"

#include <erfa.h>
#include <gtest/gtest.h>

namespace vesper {
namespace {

using test::ErrorSum;
using test::TruthRow;

TEST(SiderealTime, MatchesTheReference) {
  const CsvTable table = test::truth_table("sidereal.csv");
  ErrorSum apparent;
  ErrorSum local;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    // The turn follows UT1 alone, which the table gives to 4e-5 s.
    const double jd_ut1 = row.number("jd_ut1");
    const double day = std::floor(jd_ut1);
    const Instant t = instant_from({day, jd_ut1 - day + row.number("delta_t") / 86400.0}, {day, jd_ut1 - day});
    apparent.add(
        test::angle_difference(greenwich_apparent_sidereal_time_rad(t) * rad, row.degrees("gast_deg")).to(arcsec));
    const EarthState earth = earth_state(t, {0.0 * deg, 90.0 * deg, 0.0 * metre});
    local.add(
        test::angle_difference(earth.local_sidereal_time_rad * rad, row.degrees("gast_deg") + 90.0 * deg).to(arcsec));
  }
  ASSERT_EQ(apparent.count(), 60U);
  apparent.hold("apparent sidereal time", 0.001, "arcsec");
  local.hold("local apparent sidereal time of an EarthState", 0.001, "arcsec");
}

TEST(DeltaT, MatchesTheReference) {
  const CsvTable table = test::truth_table("deltat.csv");
  ErrorSum observed;
  ErrorSum historic;
  ErrorSum in_bands;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    // The table's value for 2026.5 is a prediction; the observation is 0.037 s above it.
    const bool prediction = row.number("year") > 2026.0;
    const double error = delta_t_s({row.number("jd_tt"), 0.0}) - row.number("delta_t_s");
    if (row.number("year") >= 1973.5 && !prediction) {
      observed.add(error);
    } else if (!prediction) {
      historic.add(error);
      in_bands.add(error / delta_t_uncertainty_s({row.number("jd_tt"), 0.0}));
    }
  }
  observed.hold("Delta-T, 1973.5 to 2026.0, against IERS", 0.1, "s");
  historic.hold("Delta-T, -500 to 1973, against the splines of Morrison et al. 2021", 0.05, "s");
  in_bands.hold("Delta-T, -500 to 1973, in units of its published error", 1.0, "");
  EXPECT_NEAR(delta_t_s({2461223.43, 0.0}), 69.1322, 0.05);
}

TEST(DeltaT, UncertaintyGrowsAwayFromTheObservations) {
  const auto at_year = [](double year) { return delta_t_uncertainty_s({1721045.0 + year * 365.25, 0.0}); };
  EXPECT_LT(at_year(2020.0), 0.05);
  EXPECT_NEAR(at_year(1700.0), 3.8, 0.1);
  EXPECT_NEAR(at_year(2050.0), 6.0, 0.6);
  EXPECT_GT(at_year(2030.0), at_year(2028.0));
  EXPECT_NEAR(at_year(-500.0), 150.0, 1.0);
  EXPECT_GT(at_year(-4000.0), 1080.0);
  EXPECT_GT(at_year(9999.0), 100.0);
}

TEST(BarycentricTime, MatchesTheCompleteSeries) {
  ErrorSum errors;
  for (double jd = 2415020.5; jd < 2488070.0; jd += 91.3) {
    const double tdb_minus_tt = (tdb_from_tt({jd, 0.25}).days_since({jd, 0.25})) * 86400.0;
    errors.add((tdb_minus_tt - eraDtdb(jd, 0.25, 0.0, 0.0, 0.0, 0.0)) * 1e6);
  }
  errors.hold("TDB - TT, 1900 to 2100, against Fairhead and Bretagnon 1990", 30.0, "microseconds");
}

TEST(DeltaT, IsContinuousAndPlausibleOutside) {
  // Steps of a tenth of a year across all borders: the rate stays below 0.05 s a step there.
  for (const double jd : {2441714.5, 2461314.5}) {
    EXPECT_NEAR(delta_t_s({jd - 0.01, 0.0}), delta_t_s({jd + 0.01, 0.0}), 1e-3) << jd;
  }
  const double year_minus_720 = 1721045.0 - 720 * 365.25;
  EXPECT_NEAR(delta_t_s({year_minus_720 - 0.01, 0.0}), delta_t_s({year_minus_720 + 0.01, 0.0}), 0.01);
  EXPECT_NEAR(delta_t_s({2469807.5, 0.0}), 71.0, 1.5); // 2050
  EXPECT_GT(delta_t_s({0.0, 0.0}), 20371.0);
  EXPECT_GT(delta_t_s({5373484.5, 0.0}), 100000.0);
}

} // namespace
} // namespace vesper
