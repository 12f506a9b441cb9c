// The analytic series and the cheap tier against JPL DE431, whatever table stands before them.
#include "accuracy/truth.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/ephemeris_cheap.hpp"
#include "vesper/astro/ephemeris_series.hpp"
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

struct PlaceErrors {
  ErrorSum direction_arcsec, distance_km;
  void add(const Vec3& from_observer_au, const EarthState& earth, const TruthRow& row, Length distance) {
    const Vec3 truth = test::direction(row.degrees("ra"), row.degrees("dec"));
    direction_arcsec.add(test::separation(apparent_of_date(from_observer_au, earth), truth).to(arcsec));
    distance_km.add((glm::length(from_observer_au) * astronomical_unit - distance).to(kilometre));
  }
  void print(const std::string& body) const {
    direction_arcsec.print((body + ", direction").c_str(), "arcsec");
    distance_km.print((body + ", distance").c_str(), "km");
  }
};

bool in_table(const TruthRow& row) {
  const double jd = row.number("jd_tt");
  return jd > 2436934.5 && jd < 2473459.5; // 1960 to 2059
}

PlaceErrors moon_errors(const BodiesAt& bodies_at, bool outside_table_only) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  PlaceErrors errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    if (outside_table_only && in_table(row)) {
      continue;
    }
    const EarthState earth = earth_with(bodies_at, row);
    errors.add(moon_from_observer_au(earth), earth, row, row.number("dist_km") * kilometre);
  }
  return errors;
}

PlaceErrors sun_errors(const BodiesAt& bodies_at) {
  const CsvTable table = test::truth_table("sun_topo.csv");
  PlaceErrors errors;
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

std::map<std::string, PlaceErrors> planet_errors(const BodiesAt& bodies_at, const PlanetAt& planet_at) {
  const CsvTable table = test::truth_table("planets_topo.csv");
  std::map<std::string, PlaceErrors> errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const std::string name(table.cell(i, table.column("planet")));
    const double jd_tt = table.number(i, table.column("jd_tt"));
    const double jd_ut1 = table.number(i, table.column("jd_ut1"));
    const TruthRow row(table, i);
    EarthState earth =
        earth_state(instant_from({std::floor(jd_tt), jd_tt - std::floor(jd_tt)},
                                 {std::floor(jd_ut1), jd_ut1 - std::floor(jd_ut1)}),
                    row.observer());
    earth.bodies = bodies_at(earth.tdb);
    errors[name].add(planet_from_observer(planets_by_name.at(name), earth, planet_at), earth, row,
                     row.number("dist_au") * astronomical_unit);
  }
  return errors;
}

TEST(Series, MoonMatchesTheReferenceEphemeris) {
  const PlaceErrors outside = moon_errors(sun_earth_moon_series, true);
  outside.print("Moon by series, 1900-1959 and 2060-2100");
  EXPECT_GT(outside.direction_arcsec.count(), 60U);
  EXPECT_LT(outside.direction_arcsec.worst(), 1.0);
  EXPECT_LT(outside.distance_km.worst(), 3.0);
  const PlaceErrors all = moon_errors(sun_earth_moon_series, false);
  all.print("Moon by series, 1900-2100");
  EXPECT_EQ(all.direction_arcsec.count(), 200U);
  EXPECT_LT(all.direction_arcsec.worst(), 1.0);
  EXPECT_LT(all.distance_km.worst(), 3.0);
}

TEST(Series, SunMatchesTheReferenceEphemeris) {
  const PlaceErrors errors = sun_errors(sun_earth_moon_series);
  errors.print("Sun by series, 1900-2100");
  EXPECT_EQ(errors.direction_arcsec.count(), 200U);
  EXPECT_LT(errors.direction_arcsec.worst(), 0.2);
  EXPECT_LT(errors.distance_km.worst(), 100.0);
}

TEST(Series, PlanetsMatchTheReferenceEphemeris) {
  const auto errors = planet_errors(sun_earth_moon_series, planet_heliocentric_series);
  ASSERT_EQ(errors.size(), planets_by_name.size());
  for (const auto& [name, sum] : errors) {
    sum.print(name + " by series, 1900-2100");
    EXPECT_GE(sum.direction_arcsec.count(), 15U) << name;
    EXPECT_LT(sum.direction_arcsec.worst(), 10.0) << name;
  }
}

} // namespace
} // namespace vesper
