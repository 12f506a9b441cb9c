// The analytic series and the cheap tier against JPL DE431, whatever table stands before them.
#include "support/truth.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/ephemeris_cheap.hpp"
#include "vesper/astro/ephemeris_series.hpp"
#include "vesper/astro/harmonic_sum.hpp"
#include "vesper/astro/star_place.hpp"

#include <erfa.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace vesper {
namespace {

using test::ErrorSum;
using test::TruthRow;

using BodiesAt = std::function<SunEarthMoon(JulianDate<TDB>)>;
using PlanetAt = std::function<StateVector(Planet, JulianDate<TDB>)>;

const std::map<std::string, Planet> planets_by_name = {
    {"mercury", Planet::mercury}, {"venus", Planet::venus},   {"mars", Planet::mars},      {"jupiter", Planet::jupiter},
    {"saturn", Planet::saturn},   {"uranus", Planet::uranus}, {"neptune", Planet::neptune}};

JulianDate<TDB> in_year(double year) { return JulianDate<TDB>{2451545.0, 0.0}.plus_days((year - 2000.0) * 365.25); }

EarthState earth_with(const BodiesAt& bodies_at, const TruthRow& row) {
  EarthState earth = earth_state(row.instant(), row.observer());
  earth.bodies = bodies_at(earth.tdb);
  return earth;
}

/// True equator and equinox of date, apparent.
Vec3 apparent_of_date(const Vec3& from_observer_au, const EarthState& earth) {
  const Vec3 apparent = f64::star_aberration(glm::normalize(from_observer_au), place_frame(star_frame(earth)));
  return earth.equator_of_date_from_icrs * apparent;
}

struct SeriesErrors {
  ErrorSum direction_arcsec, distance_km;
  void add(const Vec3& from_observer_au, const EarthState& earth, const TruthRow& row, Length distance) {
    const Vec3 truth = test::direction(row.degrees("ra"), row.degrees("dec"));
    direction_arcsec.add(test::separation(apparent_of_date(from_observer_au, earth), truth).to(arcsec));
    distance_km.add((glm::length(from_observer_au) * astronomical_unit - distance).to(kilometre));
  }
  void hold(const std::string& body, double limit_arcsec, double limit_km) const {
    direction_arcsec.hold(body + ", direction", limit_arcsec, "arcsec");
    distance_km.hold(body + ", distance", limit_km, "km");
  }
};

SeriesErrors moon_errors(const BodiesAt& bodies_at, bool outside_table_only) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  SeriesErrors errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    if (outside_table_only && row.in_table_years()) {
      continue;
    }
    const EarthState earth = earth_with(bodies_at, row);
    errors.add(moon_from_observer_au(earth), earth, row, row.number("dist_km") * kilometre);
  }
  return errors;
}

SeriesErrors sun_errors(const BodiesAt& bodies_at) {
  const CsvTable table = test::truth_table("sun_topo.csv");
  SeriesErrors errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const EarthState earth = earth_with(bodies_at, row);
    errors.add(sun_from_observer_au(earth), earth, row, row.number("dist_au") * astronomical_unit);
  }
  return errors;
}

/// As planet_from_observer_au, with a source of places of our choice.
Vec3 planet_from_observer(Planet planet, const EarthState& earth, const PlanetAt& planet_at) {
  constexpr double light_days_per_au = 499.004783836156412 / 86400.0;
  Vec3 from_observer{};
  for (int i = 0; i < 4; ++i) {
    const double delay = glm::length(from_observer) * light_days_per_au;
    from_observer = earth.bodies.sun.position_au - delay * earth.bodies.sun.velocity_au_d +
                    planet_at(planet, earth.tdb.plus_days(-delay)).position_au - earth.bodies.earth.position_au -
                    earth.earth_to_observer_au;
  }
  return from_observer;
}

std::map<std::string, SeriesErrors> planet_errors(const BodiesAt& bodies_at, const PlanetAt& planet_at) {
  const CsvTable table = test::truth_table("planets_topo.csv");
  std::map<std::string, SeriesErrors> errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const std::string name(table.cell(i, table.column("planet")));
    const double jd_tt = table.number(i, table.column("jd_tt"));
    const double jd_ut1 = table.number(i, table.column("jd_ut1"));
    const TruthRow row(table, i);
    EarthState earth = earth_state(
        instant_from({std::floor(jd_tt), jd_tt - std::floor(jd_tt)}, {std::floor(jd_ut1), jd_ut1 - std::floor(jd_ut1)}),
        row.observer());
    earth.bodies = bodies_at(earth.tdb);
    errors[name].add(planet_from_observer(planets_by_name.at(name), earth, planet_at), earth, row,
                     row.number("dist_au") * astronomical_unit);
  }
  return errors;
}

TEST(Series, MoonMatchesTheReferenceEphemeris) {
  const SeriesErrors outside = moon_errors(sun_earth_moon_series, true);
  outside.hold("Moon by series, 1900 to 1959 and 2060 to 2100", 1.0, 3.0);
  EXPECT_GT(outside.direction_arcsec.count(), 60U);
  const SeriesErrors all = moon_errors(sun_earth_moon_series, false);
  all.hold("Moon by series, 1900 to 2100", 1.0, 3.0);
  EXPECT_EQ(all.direction_arcsec.count(), 200U);
}

TEST(Series, SunMatchesTheReferenceEphemeris) {
  const SeriesErrors errors = sun_errors(sun_earth_moon_series);
  errors.hold("Sun by series, 1900 to 2100", 0.2, 100.0);
  EXPECT_EQ(errors.direction_arcsec.count(), 200U);
}

TEST(Series, PlanetsMatchTheReferenceEphemeris) {
  const auto errors = planet_errors(sun_earth_moon_series, planet_heliocentric_series);
  ASSERT_EQ(errors.size(), planets_by_name.size());
  for (const auto& [name, sum] : errors) {
    sum.direction_arcsec.hold(name + " by series, 1900 to 2100, direction", 10.0, "arcsec");
    EXPECT_GE(sum.direction_arcsec.count(), 15U) << name;
  }
}

TEST(Series, SunAgreesWithAnotherTheoryOverCenturies) {
  ErrorSum direction;
  ErrorSum sun_position_au;
  ErrorSum sun_velocity_au_d;
  for (double year = 1600.0; year < 2400.0; year += 1.37) {
    const JulianDate<TDB> tdb = in_year(year);
    double heliocentric[2][3];
    double barycentric[2][3];
    eraEpv00(tdb.day, tdb.fraction, heliocentric, barycentric);
    const auto vector = [](const double(&v)[3]) { return Vec3(v[0], v[1], v[2]); };
    const SunEarthMoon bodies = sun_earth_moon_series(tdb);
    direction.add(
        test::separation(bodies.earth.position_au - bodies.sun.position_au, vector(heliocentric[0])).to(arcsec));
    sun_position_au.add(glm::length(bodies.sun.position_au - (vector(barycentric[0]) - vector(heliocentric[0]))));
    sun_velocity_au_d.add(glm::length(bodies.sun.velocity_au_d - (vector(barycentric[1]) - vector(heliocentric[1]))));
  }
  direction.hold("Sun by series against eraEpv00, 1600-2400", 0.3, "arcsec");
  sun_position_au.hold("Sun's barycentric place against eraEpv00", 3e-5, "au");
  sun_velocity_au_d.hold("Sun's barycentric velocity against eraEpv00", 2e-7, "au/d"); // 0.0002" of aberration
}

TEST(Series, FastCosinesAgreeWithTheStandardLibrary) {
  ErrorSum errors;
  for (double angle = 1e-9; angle < 1e6; angle *= 1.00037) {
    const TermPair angles{angle, -angle};
    const CosSin fast = cos_sin(angles);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      errors.add(fast.cos[lane] - std::cos(angles[lane]));
      errors.add(fast.sin[lane] - std::sin(angles[lane]));
    }
  }
  errors.hold("cosine and sine", 2e-13, "");
}

TEST(Series, VelocitiesAreTheDerivativesOfPlaces) {
  constexpr double h = 0.01; // days
  ErrorSum relative;
  const auto add = [&relative](const StateVector& before, const StateVector& now, const StateVector& after) {
    const Vec3 difference = (after.position_au - before.position_au) / (2.0 * h);
    relative.add(glm::length(difference - now.velocity_au_d) / glm::length(now.velocity_au_d));
  };
  for (double year = -4700.0; year < 9999.0; year += 217.31) {
    const JulianDate<TDB> tdb = in_year(year);
    const auto before = sun_earth_moon_series(tdb.plus_days(-h));
    const auto now = sun_earth_moon_series(tdb);
    const auto after = sun_earth_moon_series(tdb.plus_days(h));
    add(before.moon, now.moon, after.moon);
    add(before.earth, now.earth, after.earth);
    for (const auto& [name, planet] : planets_by_name) {
      add(planet_heliocentric_series(planet, tdb.plus_days(-h)), planet_heliocentric_series(planet, tdb),
          planet_heliocentric_series(planet, tdb.plus_days(h)));
    }
  }
  relative.hold("velocity less difference quotient", 2e-6, "of the velocity");
}

TEST(Series, KeepSaneDistancesOverAllYears) {
  struct Range {
    double least_au, most_au;
  };
  // Perihelion and aphelion with the change of the eccentricities over 8000 years (Saturn: 0.028 to 0.079).
  const std::map<std::string, Range> ranges = {
      {"mercury", {0.305, 0.470}}, {"venus", {0.715, 0.732}}, {"mars", {1.370, 1.680}}, {"jupiter", {4.86, 5.55}},
      {"saturn", {8.75, 10.38}},   {"uranus", {18.2, 20.2}},  {"neptune", {29.6, 30.5}}};
  for (double year = -4712.0; year < 10000.0; year += 1.7913) {
    const JulianDate<TDB> tdb = in_year(year);
    const SunEarthMoon bodies = sun_earth_moon_series(tdb);
    const double sun = glm::length(bodies.earth.position_au - bodies.sun.position_au);
    ASSERT_TRUE(sun > 0.980 && sun < 1.020) << year << " " << sun;
    const double moon_km = (glm::length(bodies.moon.position_au) * astronomical_unit).to(kilometre);
    ASSERT_TRUE(moon_km > 356000.0 && moon_km < 407000.0) << year << " " << moon_km;
    const double speed_km_s = (glm::length(bodies.moon.velocity_au_d) * astronomical_unit).to(kilometre) / 86400.0;
    ASSERT_TRUE(speed_km_s > 0.95 && speed_km_s < 1.11) << year << " " << speed_km_s;
    for (const auto& [name, range] : ranges) {
      const double distance = glm::length(planet_heliocentric_series(planets_by_name.at(name), tdb).position_au);
      ASSERT_TRUE(distance > range.least_au && distance < range.most_au) << name << " " << year << " " << distance;
    }
  }
}

TEST(Series, InstantsMicrosecondsApartDifferByTheVelocity) {
  ErrorSum moon;
  ErrorSum earth;
  for (const double seconds : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    for (double year = 1900.0; year < 2100.0; year += 3.3) {
      const JulianDate<TDB> tdb = in_year(year);
      const double days = seconds / 86400.0;
      const SunEarthMoon now = sun_earth_moon_series(tdb);
      const SunEarthMoon next = sun_earth_moon_series(tdb.plus_days(days));
      const auto excess_mm = [days](const StateVector& a, const StateVector& b) {
        return (glm::length(b.position_au - a.position_au - days * a.velocity_au_d) * astronomical_unit).to(metre) *
               1e3;
      };
      moon.add(excess_mm(now.moon, next.moon));
      earth.add(excess_mm(now.earth, next.earth));
    }
  }
  moon.hold("Moon, steps of 1 microsecond to 10 ms less velocity", 5.0, "mm");
  earth.hold("Earth, steps of 1 microsecond to 10 ms less velocity", 50.0,
             "mm"); // a longitude of 628 rad is rounded to 1e-13 rad: 17 mm at 1 au
}

TEST(CheapTier, HoldsItsStatedErrors) {
  const SeriesErrors moon = moon_errors(sun_earth_moon_cheap, false);
  const SeriesErrors sun = sun_errors(sun_earth_moon_cheap);
  moon.hold("Moon, cheap tier, 1900 to 2100", 360.0, 800.0); // its parallax has terms down to 9e-6 of 0.0166
  EXPECT_LT(moon.direction_arcsec.rms(), 130.0);
  sun.direction_arcsec.hold("Sun, cheap tier, 1900 to 2100, direction", 35.0, "arcsec");
  EXPECT_LT(sun.direction_arcsec.rms(), 15.0);
  for (const auto& [name, errors] : planet_errors(sun_earth_moon_cheap, planet_heliocentric_cheap)) {
    errors.direction_arcsec.hold(name + ", cheap tier, 1900 to 2100, direction", 200.0, "arcsec");
  }
}

TEST(CheapTier, HasTheVelocitiesOfItsPlaces) {
  for (double year = 1900.0; year < 2100.0; year += 7.77) {
    const JulianDate<TDB> tdb = in_year(year);
    const SunEarthMoon cheap = sun_earth_moon_cheap(tdb);
    const SunEarthMoon series = sun_earth_moon_series(tdb);
    // Light time moves the Moon by 0.7": its velocity may be wrong by a percent.
    EXPECT_LT(glm::length(cheap.moon.velocity_au_d - series.moon.velocity_au_d), 0.02 * 6e-4);
    // Aberration is 20.5": the Earth's velocity holds it to 0.03".
    EXPECT_LT(glm::length(cheap.earth.velocity_au_d - (series.earth.velocity_au_d - series.sun.velocity_au_d)),
              1.5e-3 * 0.0172);
  }
}

TEST(CheapTier, KeepsSaneDistancesOverAllYears) {
  for (double year = -4712.0; year < 10000.0; year += 3.7913) {
    const JulianDate<TDB> tdb = in_year(year);
    const SunEarthMoon bodies = sun_earth_moon_cheap(tdb);
    const double sun = glm::length(bodies.earth.position_au);
    ASSERT_TRUE(sun > 0.975 && sun < 1.025) << year << " " << sun;
    const double moon_km = (glm::length(bodies.moon.position_au) * astronomical_unit).to(kilometre);
    ASSERT_TRUE(moon_km > 355000.0 && moon_km < 408000.0) << year << " " << moon_km;
    for (const auto& [name, planet] : planets_by_name) {
      const double cheap = glm::length(planet_heliocentric_cheap(planet, tdb).position_au);
      const double series = glm::length(planet_heliocentric_series(planet, tdb).position_au);
      ASSERT_NEAR(cheap / series, 1.0, 0.1) << name << " " << year;
    }
  }
}

TEST(CheapTier, IsWhatTheInterfaceGives) {
  const JulianDate<TDB> tdb{2451545.0, 0.0};
  EXPECT_EQ(sun_earth_moon(tdb, Tier::cheap).moon.position_au, sun_earth_moon_cheap(tdb).moon.position_au);
  EXPECT_EQ(planet_heliocentric(Planet::mars, tdb, Tier::cheap).position_au,
            planet_heliocentric_cheap(Planet::mars, tdb).position_au);
}

} // namespace
} // namespace vesper
