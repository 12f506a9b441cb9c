// The Moon's orientation against JPL: librations, axis and terminator of DE421 tables, Euler angles of DE405.
#include "support/truth.hpp"

#include "vesper/astro/body_place.hpp"
#include "vesper/astro/lunar_orientation.hpp"
#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

namespace vesper {
namespace {

using test::ErrorSum;
using test::TruthRow;

double difference_deg(Angle a, Angle b) { return test::angle_difference(a, b).to(deg); }

struct LibrationErrors {
  ErrorSum longitude, latitude;

  void add(const Selenographic& ours, Angle true_longitude, Angle true_latitude) {
    longitude.add(difference_deg(ours.longitude, true_longitude));
    latitude.add(difference_deg(ours.latitude, true_latitude));
  }
  void hold(const std::string& what, double limit_deg) const {
    longitude.hold(what + ", longitude", limit_deg, "degree");
    latitude.hold(what + ", latitude", limit_deg, "degree");
  }
};

TEST(LunarOrientation, LibrationsAndAxisMatchTheReference) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  LibrationErrors topocentric;
  LibrationErrors geocentric;
  LibrationErrors subsolar;
  ErrorSum axis;
  ErrorSum colongitude;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    if (row.text("lib_src") != "DE421") {
      continue;
    }
    const MoonState moon = sky_state(row.instant(), row.observer()).moon;
    topocentric.add(moon.libration, row.degrees("lib_lon_topo"), row.degrees("lib_lat_topo"));
    geocentric.add(moon.geocentric_libration, row.degrees("lib_lon_geo"), row.degrees("lib_lat_geo"));
    subsolar.add(moon.subsolar, row.degrees("subsolar_lon"), row.degrees("subsolar_lat"));
    axis.add(difference_deg(moon.axis, row.degrees("pa_axis")));
    colongitude.add(difference_deg(moon.colongitude, 90.0 * deg - row.degrees("subsolar_lon")));
  }
  topocentric.hold("topocentric libration", 0.01);
  geocentric.hold("geocentric libration", 0.01);
  subsolar.hold("subsolar point", 0.01);
  colongitude.hold("colongitude", 0.01, "degree");
  axis.hold("position angle of the axis", 0.01, "degree");
  ASSERT_GT(axis.count(), 140U);
}

TEST(LunarOrientation, HoldsWhereTheReferenceIsCoarser) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  LibrationErrors errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    if (row.text("lib_src") == "Meeus53") {
      errors.add(sky_state(row.instant(), row.observer()).moon.libration, row.degrees("lib_lon_topo"),
                 row.degrees("lib_lat_topo"));
    }
  }
  errors.hold("topocentric libration after 2051, where the reference is good to 0.03 degree", 0.04);
}

TEST(LunarOrientation, AnglesAtTheMoonMatchTheReference) {
  const CsvTable table = test::truth_table("moon_topo.csv");
  ErrorSum parallactic;
  ErrorSum limb;
  ErrorSum phase;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const MoonState moon = sky_state(row.instant(), row.observer()).moon;
    phase.add((moon.phase_angle - row.degrees("phase_angle")).to(deg));
    // At the zenith the parallactic angle turns as fast as the Moon's error is large against its zenith distance.
    parallactic.add(std::cos(moon.place.altitude.to(rad)) *
                    difference_deg(moon.parallactic, row.degrees("parallactic")));
    if (row.number("phase_angle") > 2.0 && row.number("phase_angle") < 178.0) {
      limb.add(difference_deg(moon.bright_limb, row.degrees("pa_bright_limb")));
    }
  }
  parallactic.hold("parallactic angle times cosine of altitude", 0.01, "degree");
  limb.hold("bright limb, phase over 2 degrees", 0.02, "degree");
  phase.hold("phase angle", 0.02, "degree");
}

LunarAngles angles_of(const TruthRow& row) {
  return {row.degrees("phi_deg").to(rad), row.degrees("theta_deg").to(rad), row.degrees("psi_deg").to(rad)};
}

TEST(LunarOrientation, PrincipalAxesTurnIntoMeanEarthAxes) {
  const CsvTable angles = test::truth_table("lunar_angles_de405.csv");
  const CsvTable table = test::truth_table("moon_topo.csv");
  LibrationErrors errors;
  for (std::size_t i = 0; i < angles.row_count(); ++i) {
    const TruthRow angle(angles, i);
    const TruthRow row(table, static_cast<std::size_t>(angle.number("row")));
    // Earth and Moon move together: in their own frame light leaves the Moon where it then stood from the Earth.
    const EarthState earth = earth_state(row.instant(), row.observer());
    const StateVector& moon = earth.bodies.moon;
    const double since_days = angle.number("jd_tdb") - earth.tdb.value();
    const Vec3 to_observer = earth.earth_to_observer_au - (moon.position_au + since_days * moon.velocity_au_d);
    errors.add(selenographic_of(mean_earth_from_icrs(angles_of(angle)) * to_observer), row.degrees("lib_lon_topo"),
               row.degrees("lib_lat_topo"));
  }
  errors.hold("topocentric libration by the angles of DE405", 0.005);
  ASSERT_GT(errors.longitude.count(), 80U);
}

TEST(LunarOrientation, SeriesMatchesTheIntegratedAngles) {
  const CsvTable table = test::truth_table("lunar_angles_de405.csv");
  ErrorSum errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const TruthRow row(table, i);
    const double jd = row.number("jd_tdb");
    const JulianDate<TDB> tdb{std::floor(jd), jd - std::floor(jd)};
    const Mat3 turn = mean_earth_from_icrs(tdb) * glm::transpose(mean_earth_from_icrs(angles_of(row)));
    const Vec3 axis(turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]);
    errors.add((std::asin(0.5 * glm::length(axis)) * rad).to(deg));
  }
  errors.hold("series against the angles of DE405", 0.002, "degree");
  ASSERT_GT(errors.count(), 80U);
}

} // namespace
} // namespace vesper
