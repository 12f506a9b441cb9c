// The light in the Earth's shadow at the ends of everything.
#include "vesper/astro/constants.hpp"
#include "vesper/atmosphere/earth_shadow_solver.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/sky_state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace vesper {
namespace {

constexpr double au_km = 149597870.7;

f64::EarthShadow shadow_of_z(double sun_au = 1.0) {
  return {Vec3(0.0, 0.0, 1.0), sun_au * au_km, sun_radius.to(kilometre), 1.01 * earth_equatorial_radius_km};
}

LunarEclipseTable table_at(double along_km, double danjon = 2.5, double sun_au = 1.0) {
  return lunar_eclipse_table(
      eclipse_spectra(default_earth_shadow_light(), along_km * kilometre, sun_au * astronomical_unit, danjon),
      solar_irradiance_1au());
}

f32::LunarEclipseFrame single(const f64::LunarEclipseFrame& frame) {
  const auto real = [](double value) { return static_cast<float>(value); };
  return {frame.kind,
          frame.columns,
          frame.rows,
          real(frame.first_km),
          real(frame.rows_per_km),
          real(frame.edge_km),
          real(frame.edge_per_km),
          real(frame.inside_km),
          real(frame.columns_per_km)};
}

/// Shares in both precisions, finite and within 0 to 1.
f64::vec4 checked_shares(const LunarEclipseTable& table, const Vec3& point, const f64::EarthShadow& shadow) {
  std::vector<f32::vec4> texels;
  for (const Vec4& texel : table.texels) {
    texels.emplace_back(texel);
  }
  const f64::vec4 shares = f64::lunar_eclipse_shares(point, shadow, table.frame, table.sampler());
  const f32::EarthShadow f32_shadow{glm::vec3(shadow.axis), static_cast<float>(shadow.sun_distance_km),
                                    static_cast<float>(shadow.sun_radius_km),
                                    static_cast<float>(shadow.edge_radius_km)};
  const f32::vec4 f32_shares = f32::lunar_eclipse_shares(glm::vec3(point), f32_shadow, single(table.frame),
                                                         {texels.data(), table.frame.columns, table.frame.rows});
  for (int i = 0; i < 4; ++i) {
    EXPECT_GT(shares[i], 0.0) << point.x << " " << point.z;
    EXPECT_LE(shares[i], 1.0) << point.x << " " << point.z;
    EXPECT_NEAR(f32_shares[i], shares[i], 3.0e-3 * shares[i]) << point.x << " " << point.z;
  }
  return shares;
}

TEST(EarthShadowStability, NothingJumpsFromTheAxisToFullLight) {
  for (const double sun_au : {0.983, 1.017}) {
    for (const double along : {356000.0, 384400.0, 407000.0}) {
      for (const double danjon : {0.0, 2.5, 4.0}) {
        const LunarEclipseTable table = table_at(along, danjon, sun_au);
        const f64::EarthShadow shadow = shadow_of_z(sun_au);
        double before = checked_shares(table, {0.0, 0.0, along}, shadow).y;
        EXPECT_LT(before, 1.0e-4);
        for (double off = 1.0; off < 9000.0; off += 1.0) {
          const double now = f64::lunar_eclipse_shares({off, 0.0, along}, shadow, table.frame, table.sampler()).y;
          ASSERT_GE(now, 0.999 * before) << off;
          ASSERT_LT(now, 1.05 * before + 1.0e-9) << off;
          before = now;
          if (static_cast<int>(off) % 50 == 0) {
            checked_shares(table, {0.0, -off, along}, shadow);
          }
        }
        EXPECT_EQ(before, 1.0);
      }
    }
  }
}

TEST(EarthShadowStability, OffTheMoonsOrbit) {
  const LunarEclipseTable table = table_at(384400.0);
  const f64::EarthShadow shadow = shadow_of_z();
  // In front of the Earth, beside it and at the centre of everything.
  EXPECT_EQ(checked_shares(table, {0.0, 0.0, -384400.0}, shadow), f64::vec4(1.0));
  EXPECT_EQ(checked_shares(table, {384400.0, 0.0, 0.0}, shadow), f64::vec4(1.0));
  EXPECT_EQ(checked_shares(table, {0.0, 0.0, 0.0}, shadow), f64::vec4(1.0));
  EXPECT_EQ(checked_shares(table, {3.0e5, 0.0, 3.0e5}, shadow), f64::vec4(1.0));
  // Close behind it, at the umbra's tip (1.4e6 km) and behind.
  for (const double along : {10.0, 6500.0, 1.0e5, 1.38e6, 1.4e6, 5.0e6, 1.4e8}) {
    for (const double off : {0.0, 1.0, 3000.0, 6400.0, 2.0e4}) {
      checked_shares(table, {off, 0.0, along}, shadow);
    }
  }
}

TEST(EarthShadowStability, TheSolverAtTheEnds) {
  const EarthShadowSolver solver(clear_medium(), {380.0, 550.0, 780.0}, {earth_shadow_loads[0], earth_shadow_loads[4]});
  for (const Vec2& place : {Vec2(0.0, 356000.0), Vec2(1.0e-9, 384400.0), Vec2(4600.0, 407000.0), Vec2(8200.0, 384400.0),
                            Vec2(9.0e4, 384400.0), Vec2(0.0, 1.0e5), Vec2(0.0, 1.5e6), Vec2(100.0, 1.38e6)}) {
    for (const double share : solver.shares(place, astronomical_unit)) {
      EXPECT_TRUE(std::isfinite(share));
      EXPECT_GT(share, 0.0);
      EXPECT_LT(share, 1.001);
    }
  }
  // On the axis nothing is singular.
  const std::vector<double> on = solver.shares({0.0, 384400.0}, astronomical_unit);
  const std::vector<double> beside = solver.shares({1.0, 384400.0}, astronomical_unit);
  for (std::size_t i = 0; i < on.size(); ++i) {
    EXPECT_NEAR(on[i], beside[i], 5.0e-3 * on[i]);
  }
}

TEST(EarthShadowStability, WithoutAirWavelengthsOrWithMuchOfIt) {
  ClearAir none;
  none.aerosol_optical_depth = 0.0;
  none.stratospheric_optical_depth = 0.0;
  none.ozone_dobson = 0.0;
  ClearAir thick;
  thick.aerosol_optical_depth = 10.0;
  thick.stratospheric_optical_depth = 1.0;
  for (const Medium& medium : {clear_medium(none), clear_medium(thick), published_medium()}) {
    const EarthShadowLight light = make_earth_shadow_light(medium);
    const EclipseSpectra spectra = eclipse_spectra(light, 384400.0 * kilometre, astronomical_unit, 2.0);
    for (const Vec4& texel : lunar_eclipse_table(spectra, solar_irradiance_1au()).texels) {
      for (int i = 0; i < 4; ++i) {
        EXPECT_TRUE(std::isfinite(texel[i]));
        EXPECT_GT(texel[i], 0.0);
        EXPECT_LE(texel[i], 1.0 + 1.0e-12);
      }
    }
  }
  Medium nothing = clear_medium();
  nothing.top_radius = nothing.ground_radius;
  EXPECT_THROW(static_cast<void>(make_earth_shadow_light(nothing)), Error);
}

TEST(EarthShadowStability, EclipsesThatGrazeAndExactOpposition) {
  const auto share = [](double off_deg, double moon_km) {
    const double angle = (off_deg * deg).to(rad);
    const LunarEclipseState state =
        lunar_eclipse_state({Vec3(au_km, 0.0, 0.0), moon_km * Vec3(-std::cos(angle), std::sin(angle), 0.0)});
    const Spectrum light = sunlight_on_moon(state);
    for (const double value : light.values()) {
      EXPECT_TRUE(value > 0.0 && value <= 1.0) << off_deg;
    }
    return light(550.0);
  };
  for (const double moon_km : {356400.0, 384400.0, 406700.0}) {
    double before = share(0.0, moon_km);
    EXPECT_LT(before, 1.0e-4);
    for (int i = 1; i <= 200; ++i) {
      const double now = share(0.01 * i, moon_km);
      EXPECT_GE(now, 0.999 * before) << i;
      EXPECT_LT(now - before, 0.05) << i;
      before = now;
    }
    EXPECT_EQ(before, 1.0);
  }
  // The Moon on the other side, and nowhere.
  const LunarEclipseState new_moon = lunar_eclipse_state({Vec3(au_km, 0.0, 0.0), Vec3(384400.0, 0.0, 0.0)});
  EXPECT_EQ(sunlight_on_moon(new_moon)(550.0), 1.0);
}

TEST(EarthShadowStability, LuminositiesOutOfRangeAreRefused) {
  for (const double danjon : {-0.1, 4.1, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(static_cast<void>(
                     eclipse_spectra(default_earth_shadow_light(), 384400.0 * kilometre, astronomical_unit, danjon)),
                 Error);
  }
  for (const double sun_au : {0.5, 0.99, 2.0}) {
    for (const double along_km : {1.0, 384400.0, 1.0e7}) {
      for (const double log :
           eclipse_spectra(default_earth_shadow_light(), along_km * kilometre, sun_au * astronomical_unit, 0.0)
               .log_shares) {
        EXPECT_TRUE(log <= 0.01 && log > -40.0);
      }
    }
  }
}

} // namespace
} // namespace vesper
