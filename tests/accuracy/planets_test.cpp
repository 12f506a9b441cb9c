// Planets against JPL DE431 and magnitudes after Mallama and Hilton 2018.
#include "support/truth.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/planet_appearance.hpp"
#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

#include <array>

namespace vesper {
namespace {

using test::ErrorSum;
using test::TruthRow;

constexpr std::array<const char*, planet_count> names{"mercury", "venus",  "mars",   "jupiter",
                                                      "saturn",  "uranus", "neptune"};

JulianDate<TT> split(double jd) { return {std::floor(jd), jd - std::floor(jd)}; }

Instant instant_of(const TruthRow& row) {
  const JulianDate<TT> ut1 = split(row.number("jd_ut1"));
  return instant_from(split(row.number("jd_tt")), {ut1.day, ut1.fraction});
}

template <class Check> void for_rows_of(Planet planet, const Check& check) {
  const CsvTable table = test::truth_table("planets_topo.csv");
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    if (row.text("planet") == names.at(static_cast<std::size_t>(planet))) {
      check(row);
    }
  }
}

class Planets : public testing::TestWithParam<int> {
protected:
  Planet planet = static_cast<Planet>(GetParam());
};

TEST_P(Planets, AppearanceMatchesTheReference) {
  ErrorSum magnitude;
  ErrorSum phase;
  ErrorSum fraction;
  ErrorSum diameter;
  for_rows_of(planet, [&](const TruthRow& row) {
    EarthState earth = earth_state(instant_of(row), row.observer());
    earth.earth_to_observer_au = Vec3(0.0); // these columns are geocentric
    const Vec3 planet_au = planet_from_observer_au(planet, earth);
    const PlanetAppearance appearance =
        planet_appearance(planet, planet_au, planet_au - sun_from_observer_au(earth), earth.tdb);
    magnitude.add(appearance.magnitude - row.number("magnitude"));
    phase.add((appearance.phase_angle - row.degrees("phase_angle")).to(deg));
    fraction.add(appearance.illuminated_fraction - row.number("illum"));
    diameter.add(100.0 * (appearance.diameter.to(arcsec) / row.number("diameter_arcsec") - 1.0));
  });
  const std::string name = names.at(static_cast<std::size_t>(planet));
  magnitude.hold(name + ", magnitude", planet == Planet::saturn ? 0.1 : 0.05, "mag");
  phase.hold(name + ", phase angle", 0.02, "degree");
  fraction.hold(name + ", illuminated fraction", 1e-4, "");
  diameter.hold(name + ", diameter", 1.0, "%");
  ASSERT_EQ(magnitude.count(), 20U);
}

TEST_P(Planets, PlacesMatchTheReference) {
  ErrorSum equatorial;
  ErrorSum horizontal;
  ErrorSum distance;
  for_rows_of(planet, [&](const TruthRow& row) {
    const SkyState sky = sky_state(instant_of(row), row.observer());
    const BodyPlace& place = sky.planets.at(static_cast<std::size_t>(planet)).place;
    equatorial.add(test::separation(place.direction_equatorial, test::direction(row.degrees("ra"), row.degrees("dec")))
                       .to(arcsec));
    horizontal.add(test::separation(test::direction(place.azimuth, place.altitude),
                                    test::direction(row.degrees("az"), row.degrees("alt")))
                       .to(arcsec));
    distance.add(place.distance.to(astronomical_unit) / row.number("dist_au") - 1.0);
  });
  const std::string name = names.at(static_cast<std::size_t>(planet));
  ASSERT_EQ(equatorial.count(), 20U);
  equatorial.hold(name + ", right ascension and declination", 10.0, "arcsec");
  horizontal.hold(name + ", azimuth and altitude", 10.0, "arcsec");
  distance.hold(name + ", distance", 1e-5, "of itself");
}

/// The place that light left, by computing the planet anew for the retarded time until it settles.
Vec3 settled_place_au(Planet planet, const EarthState& earth) {
  constexpr double light_days_per_au = 499.004783836156412 / 86400.0;
  const Vec3 sun_au = earth.bodies.sun.position_au - earth.bodies.earth.position_au - earth.earth_to_observer_au;
  Vec3 place{};
  for (int i = 0; i < 6; ++i) {
    const double light_days = glm::length(place) * light_days_per_au;
    place = sun_au - light_days * earth.bodies.sun.velocity_au_d +
            planet_heliocentric(planet, earth.tdb.plus_days(-light_days), earth.tier).position_au;
  }
  return place;
}

TEST_P(Planets, OnePlaceGivesThatOfTheRetardedTime) {
  ErrorSum errors;
  for (int i = 0; i < 1000; ++i) {
    const EarthState earth =
        earth_state(instant_from({2437000.5 + 36.4 * i, 0.0}, {2437000.5 + 36.4 * i, 0.0}), Observer());
    errors.add(test::separation(planet_from_observer_au(planet, earth), settled_place_au(planet, earth)).to(arcsec));
  }
  // As good as the source's velocity: 0.0005 arcsec where that is the derivative of its place.
  errors.hold(std::string(names.at(static_cast<std::size_t>(planet))) + ", one step of light time against many", 0.02,
              "arcsec");
}

TEST(PlanetAppearance, EquatorialDiametersAreTheAlmanacs) {
  // Astronomical Almanac, section E: equatorial semidiameters at 1 au, arcsec.
  constexpr std::array<double, planet_count> semidiameter{3.36, 8.34, 4.68, 98.57, 83.10, 35.24, 34.14};
  for (int i = 0; i < planet_count; ++i) {
    const PlanetAppearance appearance =
        planet_appearance(static_cast<Planet>(i), Vec3(1.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0), {2451545.0, 0.0});
    EXPECT_NEAR(0.5 * appearance.equatorial_diameter.to(arcsec), semidiameter.at(static_cast<std::size_t>(i)), 0.01);
    EXPECT_GE(appearance.equatorial_diameter, appearance.diameter);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Planets, testing::Range(0, planet_count),
                         [](const auto& which) { return names.at(static_cast<std::size_t>(which.param)); });

} // namespace
} // namespace vesper
