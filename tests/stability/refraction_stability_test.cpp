// Refraction at the poles of the horizon frame, through the horizon and the nadir, with no air and too much of it.
#include "support/truth.hpp"

#include "vesper/astro/refraction.hpp"
#include "vesper/astro/refraction_trace.hpp"
#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace vesper {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Refraction refraction(RefractionModel model, double height_km, double pressure_hpa, double temperature_c) {
  return with_table({model, {height_km * kilometre, pressure_hpa, temperature_c, 555.0}, nullptr});
}

Vec3 at(double altitude_rad, double azimuth_rad = 1.0) {
  return {std::cos(altitude_rad) * std::sin(azimuth_rad), std::cos(altitude_rad) * std::cos(azimuth_rad),
          std::sin(altitude_rad)};
}

double altitude_of(const Vec3& v) { return std::atan2(v.z, std::hypot(v.x, v.y)); }

/// What every refraction of the sphere must do: move along the vertical only, keep the order of altitudes without
/// steps, leave zenith and nadir where they are, lead back.
void expect_sound(const Refraction& air, double back_arcsec) {
  for (const double pole : {-1.0, 1.0}) {
    EXPECT_EQ(apparent_direction({0.0, 0.0, pole}, air), Vec3(0.0, 0.0, pole));
    EXPECT_EQ(true_direction({0.0, 0.0, pole}, air), Vec3(0.0, 0.0, pole));
    // Next to the pole the azimuth stays too.
    const Vec3 near = apparent_direction(at(pole * (0.5 * std::numbers::pi - 1e-9)), air);
    EXPECT_NEAR(std::atan2(near.x, near.y), 1.0, 1e-6);
  }
  constexpr int steps = 36000;
  constexpr double step = std::numbers::pi / steps;
  double last_up = -0.5 * std::numbers::pi;
  double last_down = last_up;
  for (int i = 1; i <= steps; ++i) {
    const double altitude = -0.5 * std::numbers::pi + step * i;
    const Vec3 seen = apparent_direction(at(altitude), air);
    const Vec3 source = true_direction(at(altitude), air);
    EXPECT_NEAR(glm::length(seen), 1.0, 1e-12);
    EXPECT_NEAR(seen.x * std::cos(1.0), seen.y * std::sin(1.0), 1e-12);
    const double up = altitude_of(seen);
    const double down = altitude_of(source);
    ASSERT_GT(up, last_up) << altitude / degree;
    ASSERT_GT(down, last_down) << altitude / degree;
    // Upward the sky is squeezed, downward stretched, but by no step.
    ASSERT_LT(up - last_up, 1.2 * step) << altitude / degree;
    ASSERT_LT(down - last_down, 30.0 * step) << altitude / degree;
    ASSERT_GE(up, altitude - 1e-12);
    ASSERT_LT((test::separation(true_direction(seen, air), at(altitude))).to(arcsec), back_arcsec) << altitude / degree;
    ASSERT_LT((test::separation(apparent_direction(source, air), at(altitude))).to(arcsec), back_arcsec)
        << altitude / degree;
    last_up = up;
    last_down = down;
  }
}

TEST(RefractionStability, TablesOfOrdinaryAir) {
  for (const double height : {-0.4, 0.0, 0.001, 0.047, 2.4, 5.0, 9.0}) {
    SCOPED_TRACE(height);
    const RefractionConditions standard = standard_conditions(height * kilometre);
    for (const double warmer : {-40.0, 0.0, 25.0}) {
      expect_sound(refraction(RefractionModel::traced, height, standard.pressure_hpa, standard.temperature_c + warmer),
                   0.01);
    }
  }
}

TEST(RefractionStability, TablesAtTheEndsOfTheRange) {
  for (const double height : {-0.5, 0.0, 9.0, 12.0, 30.0, 100.0}) {
    for (const double temperature : {-90.0, 60.0}) {
      for (const double pressure : {0.0, 1.0e-6, 1100.0}) {
        SCOPED_TRACE(testing::Message() << height << " km, " << temperature << " C, " << pressure << " hPa");
        const Refraction air = refraction(RefractionModel::traced, height, pressure, temperature);
        for (const Vec4& texel : air.table->texels) {
          ASSERT_TRUE(std::isfinite(texel.x) && std::isfinite(texel.y) && std::isfinite(texel.z) &&
                      std::isfinite(texel.w));
          ASSERT_GE(texel.x, 0.0);
        }
        double last = -1.0;
        for (int i = -9000; i <= 9000; ++i) {
          const double up = apparent_altitude(i * 0.01 * deg, *air.table).to(rad);
          ASSERT_TRUE(std::isfinite(up));
          last = up;
        }
        EXPECT_NEAR(last, 0.5 * std::numbers::pi, 1e-12);
      }
    }
  }
}

TEST(RefractionStability, NoAirBendsNothing) {
  for (const RefractionModel model : {RefractionModel::traced, RefractionModel::published, RefractionModel::none}) {
    const Refraction air = refraction(model, 0.0, 0.0, 15.0);
    for (double altitude = -90.0; altitude <= 90.0; altitude += 1.5) {
      const Vec3 v = at(altitude * degree);
      EXPECT_LT(glm::length(apparent_direction(v, air) - v), 1e-15);
      EXPECT_LT(glm::length(true_direction(v, air) - v), 1e-15);
    }
  }
  // The horizon is then the geometric one: acos(R / (R + h)).
  const Refraction air = refraction(RefractionModel::traced, 9.0, 0.0, 15.0);
  EXPECT_NEAR(air.table->horizon.to(deg), -std::acos(6371.0 / 6380.0) / degree, 1e-9);
  EXPECT_NEAR(horizon_altitude({}, 9.0 * kilometre).to(deg), -std::acos(6371.0 / 6380.0) / degree, 1e-9);
}

TEST(RefractionStability, ThePublishedFormulaHasNoPole) {
  for (const double pressure : {500.0, 1010.0, 1100.0}) {
    expect_sound(refraction(RefractionModel::published, 0.0, pressure, 10.0), 0.01);
  }
  expect_sound(refraction(RefractionModel::published, 0.0, 1100.0, -90.0), 0.05);
}

TEST(RefractionStability, AscendingAndDescendingRaysMeet) {
  // From an aircraft: through the horizontal and down to the horizon, traced.
  const RefractionTracer tracer(standard_conditions(12.0 * kilometre));
  for (const double altitude : {0.0, -1.0, -2.0, -3.0}) {
    const double below = tracer.trace((altitude - 1e-7) * deg).refraction.to(arcsec);
    const double above = tracer.trace((altitude + 1e-7) * deg).refraction.to(arcsec);
    EXPECT_NEAR(below, above, 0.01) << altitude;
  }
  EXPECT_FALSE(tracer.trace(tracer.horizon()).hits_ground);
  EXPECT_TRUE(tracer.trace(tracer.horizon() - 1.0 * arcsec).hits_ground);
  EXPECT_TRUE(tracer.trace(-90.0 * deg).hits_ground);
  EXPECT_EQ(tracer.trace(90.0 * deg).refraction.to(rad), 0.0);
  EXPECT_NEAR(tracer.trace(tracer.horizon()).lowest.to(metre), 0.0, 1e-3);
  EXPECT_NEAR(tracer.trace(0.0 * deg).lowest.to(kilometre), 12.0, 1e-9);
}

TEST(RefractionStability, OutOfRangeIsSaid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const RefractionConditions& c :
       {RefractionConditions{0.0 * metre, -1.0, 15.0, 555.0}, RefractionConditions{0.0 * metre, 1101.0, 15.0, 555.0},
        RefractionConditions{0.0 * metre, 1000.0, -91.0, 555.0}, RefractionConditions{0.0 * metre, 1000.0, nan, 555.0},
        RefractionConditions{0.0 * metre, 1000.0, 15.0, 100.0},
        RefractionConditions{200.0 * kilometre, 0.0, 15.0, 555.0}}) {
    EXPECT_THROW(static_cast<void>(make_refraction_table(c)), Error);
    EXPECT_THROW(static_cast<void>(with_table({RefractionModel::published, c, nullptr})), Error);
  }
}

TEST(RefractionStability, AMissingTableIsSaid) {
  const Refraction refraction{RefractionModel::traced, {}, nullptr};
  EXPECT_THROW(static_cast<void>(apparent_direction({0.0, 0.0, 1.0}, refraction)), Error);
  EXPECT_THROW(static_cast<void>(horizon_altitude(refraction, 0.0 * metre)), Error);
}

} // namespace
} // namespace vesper
