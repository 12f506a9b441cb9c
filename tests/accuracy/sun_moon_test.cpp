// Sun and Moon against JPL DE431, inside the embedded table's span and outside.
#include "support/truth.hpp"

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
  void hold(const std::string& body, double limit_arcsec, double limit_km) const {
    equatorial.hold(body + ", right ascension and declination", limit_arcsec, "arcsec");
    horizontal.hold(body + ", azimuth and altitude", limit_arcsec, "arcsec");
    distance_km.hold(body + ", distance", limit_km, "km");
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
  ErrorSum fraction, phase_arcsec, limb_degrees;

  void hold(const std::string& body, double limit_arcsec, double limit_km) const {
    place.hold(body, limit_arcsec, limit_km);
    phase_arcsec.hold(body + ", phase angle", 72.0, "arcsec"); // 0.02 degree
    limb_degrees.hold(body + ", position angle of the bright limb", 0.02, "degree");
    fraction.hold(body + ", illuminated fraction", 2e-4, "");
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
    // line.
    const double phase_deg = row.number("phase_angle");
    if (phase_deg > 2.0 && phase_deg < 178.0) {
      errors.limb_degrees.add(test::angle_difference(moon.bright_limb, row.degrees("pa_bright_limb")).to(deg));
    }
  }
  return errors;
}

TEST(Sun, MatchesTheReferenceEphemeris) {
  sun_errors(Where::inside).hold("Sun, 1960 to 2059", 0.1, 5.0);
  sun_errors(Where::outside).hold("Sun, 1900 to 1959 and 2060 to 2100", 1.0, 100.0);
}

TEST(Moon, MatchesTheReferenceEphemeris) {
  moon_errors(Where::inside).hold("Moon, 1960 to 2059", 0.1, 1.0);
  moon_errors(Where::outside).hold("Moon, 1900 to 1959 and 2060 to 2100", 5.0, 15.0);
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
  inside.hold("Moon from the stamp, azimuth and altitude, 1960 to 2059", 0.5, "arcsec");      // 0.03 s of Delta-T
  outside.hold("Moon from the stamp, azimuth and altitude, before and after", 6.0, "arcsec"); // 0.4 s
}

} // namespace
} // namespace vesper
