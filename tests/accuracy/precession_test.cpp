// Precession over 15 000 years against an independent obliquity, and across the join of its two models.
#include "support/truth.hpp"

#include "vesper/astro/precession.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vesper {
namespace {

using test::ErrorSum;

constexpr JulianDate<TT> j2000{2451545.0, 0.0};

JulianDate<TT> tt_in_year(double year) { return j2000.plus_days((year - 2000.0) * 365.25); }

/// Laskar 1986 (A&A 157, 59), table 8: for 10 000 years around J2000. Its rate at J2000 is the IAU 1976 one, by 2.8" in
/// 10 000 years off today's, its terms are good to some arcsec at the ends.
Angle laskar_obliquity(double year) {
  constexpr double coefficients[] = {84381.448, -4680.93, -1.55, 1999.25, -51.38, -249.67,
                                     -39.05,    7.12,     27.87, 5.79,    2.45};
  const double u = (year - 2000.0) / 10000.0;
  double value = 0.0;
  for (int i = 10; i >= 0; --i) {
    value = value * u + coefficients[i];
  }
  return value * arcsec;
}

TEST(Precession, ObliquityAgreesWithLaskar) {
  ErrorSum history;
  ErrorSum all;
  for (double year = -4712.0; year <= 9999.0; year += 50.0) {
    const double error = (precession(tt_in_year(year)).mean_obliquity_rad * rad - laskar_obliquity(year)).to(arcsec);
    all.add(error);
    if (std::abs(year) <= 3000.0) {
      history.add(error);
    }
  }
  history.hold("mean obliquity, -3000 to 3000, against Laskar 1986", 6.0,
               "arcsec"); // where the two publications part by 5.4" at -3000
  all.hold("mean obliquity, -4712 to 9999, against Laskar 1986", 20.0, "arcsec"); // IAU 2006 alone: 90"
}

TEST(Precession, IsARotationThatTurnsByTheGeneralPrecession) {
  for (double year = -4712.0; year <= 9999.0; year += 97.0) {
    const Precession p = precession(tt_in_year(year));
    const Mat3 product = p.mean_equator_from_icrs * glm::transpose(p.mean_equator_from_icrs);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        EXPECT_NEAR(product[i][j], i == j ? 1.0 : 0.0, 1e-13) << year;
      }
    }
    // 50.3" a year along the ecliptic: the equinox of date makes that angle with the one of J2000, but for the
    // ecliptic's own motion.
    const double turned = std::acos(p.mean_equator_from_icrs[0][0]);
    const double expected = std::abs(std::remainder((50.2879 * arcsec).to(rad) * (year - 2000.0) +
                                                        (1.11e-4 * arcsec).to(rad) * (year - 2000.0) * (year - 2000.0),
                                                    2.0 * std::acos(-1.0)));
    EXPECT_NEAR(turned, expected, 0.02) << year;
  }
}

TEST(Precession, JoinsItsModelsWithoutAVisibleStep) {
  ErrorSum step;
  for (const double edge : {1600.0, 2400.0}) {
    const Precession before = precession(tt_in_year(edge - 1e-7));
    const Precession after = precession(tt_in_year(edge + 1e-7));
    for (int i = 0; i < 3; ++i) {
      step.add(test::separation(before.mean_equator_from_icrs[i], after.mean_equator_from_icrs[i]).to(arcsec));
    }
    step.add(((after.mean_obliquity_rad - before.mean_obliquity_rad) * rad).to(arcsec));
    step.add(((after.mean_equation_of_origins_rad - before.mean_equation_of_origins_rad) * rad).to(arcsec));
  }
  step.hold("step of precession at 1600 and 2400", 0.02, "arcsec");
}

TEST(Precession, GivesTheMeanSiderealTimeOfTheReference) {
  const CsvTable table = test::truth_table("sidereal.csv");
  ErrorSum errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const test::TruthRow row(table, i);
    const JulianDate<TT> tt{std::floor(row.number("jd_tt")), row.number("jd_tt") - std::floor(row.number("jd_tt"))};
    const Angle gmst = row.degrees("era_deg") - precession(tt).mean_equation_of_origins_rad * rad;
    errors.add(test::angle_difference(gmst, row.degrees("gmst_deg")).to(arcsec));
  }
  errors.hold("mean sidereal time given the Earth rotation angle", 0.001, "arcsec");
}

} // namespace
} // namespace vesper
