// Places at poles, zenith, far dates, zero parameters and in single precision.
#include "support/truth.hpp"

#include "vesper/astro/star_place.hpp"
#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vesper {
namespace {

using test::ErrorSum;

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void expect_sound(const BodyPlace& place) {
  EXPECT_TRUE(finite(place.direction_horizon));
  EXPECT_NEAR(glm::length(place.direction_horizon), 1.0, 1e-12);
  EXPECT_TRUE(place.azimuth.to(deg) >= 0.0 && place.azimuth.to(deg) < 360.0);
  EXPECT_TRUE(place.right_ascension.to(deg) >= 0.0 && place.right_ascension.to(deg) < 360.0);
  EXPECT_LE(std::abs(place.altitude.to(deg)), 90.0);
  EXPECT_GT(place.distance.to(kilometre), 300000.0);
}

TEST(AstroStability, HoldsAtPolesAndFarDates) {
  for (const char* time : {"-4712-01-01", "-0500-03-01", "0000-01-01", "1582-10-15", "1972-01-01",
                           "2026-12-31T23:59:59Z", "2027-01-01", "9999-12-31"}) {
    for (const double latitude : {-90.0, -89.999999999, 0.0, 90.0}) {
      for (const double longitude : {-180.0, 0.0, 360.0}) {
        for (const double height : {-500.0, 100000.0}) {
          const Observer observer{latitude * deg, longitude * deg, height * metre};
          const SkyState sky = sky_state(parse_instant(time), observer);
          SCOPED_TRACE(std::string(time) + " " + std::to_string(latitude) + " " + std::to_string(longitude));
          expect_sound(sky.sun);
          expect_sound(sky.moon.place);
          EXPECT_TRUE(sky.moon.illuminated_fraction >= 0.0 && sky.moon.illuminated_fraction <= 1.0);
          const double bright_limb = sky.moon.bright_limb.to(deg);
          EXPECT_TRUE(bright_limb >= 0.0 && bright_limb <= 360.0);
          // Rotations stay rotations.
          const Mat3 product = sky.stars.horizon_from_icrs * glm::transpose(sky.stars.horizon_from_icrs);
          EXPECT_NEAR(glm::length(product[0] - Vec3(1.0, 0.0, 0.0)) + glm::length(product[1] - Vec3(0.0, 1.0, 0.0)),
                      0.0, 1e-12);
        }
      }
    }
  }
}

TEST(AstroStability, OrientationIsContinuousWhereTheLongTermPrecessionBegins) {
  ErrorSum step;
  for (const double edge : {-400.0, 400.0}) {
    const JulianDate<TT> tt{2451545.0, edge * 365.25};
    const auto state = [&tt](double days) {
      return earth_state(instant_from(tt.plus_days(days), {tt.day, tt.fraction + days}),
                         {50.0 * deg, 10.0 * deg, 0.0 * metre});
    };
    // 0.17 ms apart: the Earth turns by 0.003 arcsec.
    constexpr double days = 1e-9;
    const EarthState before = state(-days);
    const EarthState after = state(days);
    for (int i = 0; i < 3; ++i) {
      step.add(test::separation(before.equator_of_date_from_icrs[i], after.equator_of_date_from_icrs[i]).to(arcsec));
    }
    step.add(
        test::angle_difference(after.local_sidereal_time_rad * rad, before.local_sidereal_time_rad * rad).to(arcsec));
  }
  step.print("step of the Earth's orientation at 1600 and 2400", "arcsec");
  EXPECT_LT(step.worst(), 0.03);
}

TEST(AstroStability, AltitudeOfTheCelestialPoleIsTheLatitude) {
  for (const double latitude : {-90.0, -51.0, 0.0, 66.5, 90.0}) {
    const StarFrame frame = star_frame(parse_instant("2026-08-12"), {latitude * deg, 33.0 * deg, 0.0 * metre});
    const Vec3 pole = frame.horizon_from_icrs * (glm::transpose(frame.equator_of_date_from_icrs) * Vec3(0.0, 0.0, 1.0));
    EXPECT_NEAR(horizontal_of(pole).altitude.to(arcsec), (latitude * deg).to(arcsec), 1e-6);
  }
}

TEST(AstroStability, AnglesOfSpecialDirections) {
  EXPECT_EQ(horizontal_of({0.0, 0.0, 1.0}).altitude.to(deg), 90.0);
  EXPECT_EQ(horizontal_of({0.0, 0.0, 1.0}).azimuth.to(deg), 0.0);
  EXPECT_NEAR(horizontal_of({-1e-320, 1.0, 0.0}).azimuth.to(deg), 0.0, 1e-12);
  EXPECT_LT(horizontal_of({-1e-17, 1.0, 0.0}).azimuth.to(deg), 360.0);
  // Near the zenith an arc sine would lose this milliarcsecond.
  const double tiny = (1.0 * milliarcsec).to(rad);
  EXPECT_NEAR((90.0 * deg - horizontal_of({tiny, 0.0, 1.0}).altitude).to(milliarcsec), 1.0, 1e-4);
}

TEST(AstroStability, AZeroParallaxIsTheLimitOfASmallOne) {
  const StarFrame frame = star_frame(parse_instant("2026-08-12"), {50.0 * deg, 0.0 * deg, 0.0 * metre});
  const f64::StarPlaceFrame place = place_frame(frame);
  const CatalogueStar far =
      catalogue_star(10.0 * deg, 89.9999 * deg, 100.0 * milliarcsec, -50.0 * milliarcsec, 0.0 * arcsec, 300.0);
  CatalogueStar near = far;
  near.parallax_rad = (1e-6 * arcsec).to(rad);
  EXPECT_LT(test::separation(star_place_icrs(far, place), star_place_icrs(near, place)).to(milliarcsec), 0.01);
}

TEST(AstroStability, StarsBehindAndInFrontOfTheSunStayFinite) {
  const StarFrame frame = star_frame(parse_instant("2026-08-12"), {50.0 * deg, 0.0 * deg, 0.0 * metre});
  for (const double sign : {-1.0, 1.0}) {
    const CatalogueStar star{sign * frame.sun_to_observer, Vec3(0.0), 0.0, 0.0};
    const Vec3 place = star_place_icrs(star, place_frame(frame));
    EXPECT_TRUE(finite(place));
    EXPECT_LT(test::separation(place, star.position).to(arcsec), 25.0);
  }
}

TEST(AstroStability, FloatPlacesStayNearDoubles) {
  const StarFrame frame = star_frame(parse_instant("2026-08-12T22:00:00Z"), {50.0 * deg, 10.0 * deg, 0.0 * metre});
  const f64::StarPlaceFrame exact = place_frame(frame, 1991.25);
  f32::StarPlaceFrame single;
  single.years = static_cast<float>(exact.years);
  single.observer_au = f32::PVec3(exact.observer_au);
  single.velocity_c = f32::PVec3(exact.velocity_c);
  single.lorentz_inverse = static_cast<float>(exact.lorentz_inverse);
  single.sun_to_observer = f32::PVec3(exact.sun_to_observer);
  single.solar_potential = static_cast<float>(exact.solar_potential);
  const CsvTable table = test::truth_table("stars_topo.csv");
  ErrorSum errors;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const test::TruthRow row(table, i);
    const CatalogueStar star = catalogue_star(
        row.degrees("ra_j1991_25"), row.degrees("dec_j1991_25"), row.number("pmra_cosdec_mas") * milliarcsec,
        row.number("pmdec_mas") * milliarcsec, row.number("plx_mas") * milliarcsec, 0.0);
    const Vec3 in_double = star_place_icrs(star, exact);
    const f32::PVec3 in_float =
        f32::star_place(f32::PVec3(star.position), f32::PVec3(star.proper_motion_rad_year),
                        static_cast<float>(star.parallax_rad), static_cast<float>(star.radial_velocity_km_s), single);
    errors.add(test::separation(in_double, Vec3(in_float)).to(arcsec));
  }
  errors.print("star places in single precision", "arcsec");
  EXPECT_LT(errors.worst(), 0.06); // why the vertex stage computes places in double precision
  EXPECT_GT(errors.worst(), 0.001);
}

TEST(AstroStability, GarbageTimesThrowAndNeverCrash) {
  std::mt19937 random(1);
  const std::string letters = "0123456789-:TZ. JD+now";
  std::size_t accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = "2026-08-12T22:00:00Z";
    for (int changes = 0; changes < 3; ++changes) {
      text[random() % text.size()] = letters[random() % letters.size()];
    }
    try {
      const Instant t = parse_instant(text.substr(0, random() % (text.size() + 1)));
      EXPECT_TRUE(std::isfinite(t.tt.value())) << text;
      ++accepted;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(accepted, 0U);
}

} // namespace
} // namespace vesper
