// The dark sky where its formulas could break: at the Sun and opposite to it, at poles, horizons and below, inside the
// airglow and above it, in single precision, and for options out of their range.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/base/error.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/plan/frame_plan.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/zodiacal_light.hpp"

#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace vesper {
namespace {

bool is_light(const Vec4& light) {
  return light.x >= 0.0 && light.y >= 0.0 && light.z >= 0.0 && light.w >= 0.0 && std::isfinite(light.x + light.y) &&
         std::isfinite(light.z + light.w);
}

TEST(DarkSkyStability, ZodiacalLightAtTheSunAndOpposite) {
  for (const Vec3& place : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, 1, 0),
                            Vec3(-1, -0.0, -0.0), test::direction(1.0e-9 * deg, -1.0e-9 * deg)}) {
    EXPECT_TRUE(is_light(zodiacal_luminance(place)));
    EXPECT_GT(zodiacal_luminance(place).y, 0.0);
  }
  // No step across the axes of symmetry.
  for (const auto& [a, b] :
       {std::pair(test::direction(179.9999 * deg, 0.0001 * deg), test::direction(-179.9999 * deg, -0.0001 * deg)),
        std::pair(test::direction(0.0001 * deg, 30.0 * deg), test::direction(-0.0001 * deg, 30.0 * deg)),
        std::pair(test::direction(12.0 * deg, 89.9999 * deg), test::direction(170.0 * deg, 89.9999 * deg)),
        std::pair(test::direction(40.0 * deg, 0.0001 * deg), test::direction(40.0 * deg, -0.0001 * deg))}) {
    EXPECT_NEAR(zodiacal_radiance_500nm(a) / zodiacal_radiance_500nm(b), 1.0, 1.0e-4);
  }
  // It falls from the Sun on to the darkest ring, everywhere along the ecliptic.
  double before = std::numeric_limits<double>::infinity();
  for (double elongation = 0.5; elongation < 135.0; elongation += 0.5) {
    const double here = zodiacal_radiance_500nm(test::direction(elongation * deg, 0.0 * deg));
    EXPECT_LT(here, before) << elongation;
    before = here;
  }
}

TEST(DarkSkyStability, ItsLawInSinglePrecision) {
  for (double longitude = 0.0; longitude <= 180.0; longitude += 3.0) {
    for (double latitude = -90.0; latitude <= 90.0; latitude += 3.0) {
      const Vec3 place = test::direction(longitude * deg, latitude * deg);
      if (longitude == 0.0 && latitude == 0.0) {
        continue; // the Sun, where a float's place is 0.01 degree wide
      }
      EXPECT_NEAR(static_cast<double>(f32::log2_dust_law(place)), f64::log2_dust_law(place), 1.0e-4);
    }
  }
}

TEST(DarkSkyStability, AirglowFromEverywhere) {
  for (const double height_km : {0.0, 1.0e-3, 11.0, 84.999, 85.0, 90.0, 95.0, 95.001, 400.0, 1.0e5}) {
    double most = 0.0;
    for (double sine = -1.0; sine <= 1.0; sine += 1.0 / 512.0) {
      const Vec2 paths = f64::airglow_paths(sine, height_km, 6371.0);
      const f32::vec2 single = f32::airglow_paths(static_cast<float>(sine), static_cast<float>(height_km), 6371.0F);
      EXPECT_TRUE(paths.x >= 0.0 && paths.y >= 0.0);
      most = std::max(most, paths.x + paths.y);
      EXPECT_NEAR(static_cast<double>(single.x + single.y), paths.x + paths.y, 0.03 * (1.0 + paths.x + paths.y))
          << height_km << " km, " << sine;
    }
    // The longest way through the shell, along its lower edge: 2 sqrt(2 * 6456 * 10) km of 10.
    EXPECT_LE(most, 73.0) << height_km;
    const bool above = height_km >= 95.0;
    EXPECT_EQ(f64::airglow_paths(1.0, height_km, 6371.0).y > 0.0, !above) << height_km;
    // Straight down, all that lies below is before the ground.
    const Vec2 down = f64::airglow_paths(-1.0, height_km, 6371.0);
    EXPECT_NEAR(down.x, std::clamp((height_km - 85.0) / 10.0, 0.0, 1.0), 1.0e-9);
    EXPECT_EQ(down.y, 0.0);
  }
}

TEST(DarkSkyStability, PlansAreLightAtEveryHeight) {
  const auto medium = std::make_shared<const Medium>(published_medium());
  const auto tables = std::make_shared<const SkyTables>(make_sky_tables(*medium, {8, 6, 10, 24, {}}));
  View view;
  FrameOptions options;
  options.air.medium = medium;
  options.air.sky_tables = tables;
  options.dark_sky.glow = {0.01 * candela_per_m2, 0.0 * deg, 1.0 * kilometre};
  for (const double latitude : {-90.0, 0.0, 90.0}) {
    for (const double height_km : {-0.4, 0.0, 11.0, 90.0, 101.0, 400.0, 1.0e5}) {
      for (const Tier tier : {Tier::cheap, Tier::standard}) {
        const SkyState sky =
            sky_state(parse_instant("2026-12-21T00:00:00Z"), {latitude * deg, 0.0 * deg, height_km * kilometre}, tier);
        const FramePlan plan = plan_frame(sky, view, {}, options);
        ASSERT_NE(plan.dark_sky, nullptr);
        for (const f32::vec4& texel : plan.dark_sky->air) {
          ASSERT_TRUE(is_light(Vec4(texel))) << latitude << " deg, " << height_km << " km";
        }
      }
    }
  }
}

TEST(DarkSkyStability, FarDatesHaveAnEclipticToo) {
  for (const char* stamp : {"-4000-06-01T00:00:00Z", "1000-01-01T00:00:00Z", "9000-03-01T00:00:00Z"}) {
    const SkyState sky = sky_state(parse_instant(stamp), {45.0 * deg, 0.0 * deg, 0.0 * metre});
    const DarkSky dark = dark_sky(sky);
    const Vec3 sun = dark.helioecliptic_from_horizon * sky.sun.direction_horizon;
    EXPECT_NEAR(sun.x, 1.0, 1.0e-6) << stamp;
    EXPECT_NEAR(sun.z, 0.0, 1.0e-4) << stamp;
    EXPECT_TRUE(is_light(dark.airglow)) << stamp;
  }
}

TEST(DarkSkyStability, RefusesWhatIsOutOfRange) {
  const SkyState sky = sky_state(parse_instant("2026-01-01T00:00:00Z"), {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](std::optional<double> flux, const CityGlow& glow) {
    EXPECT_THROW(static_cast<void>(dark_sky(sky, {flux, glow, nullptr})), Error);
  };
  for (const double flux : {0.0, -70.0, nan}) {
    refused(flux, {});
  }
  for (const double glow : {-1.0, nan}) {
    refused({}, {glow * candela_per_m2, {}, 30.0 * kilometre});
  }
  for (const double distance : {0.0, 301.0, nan}) {
    refused({}, {Luminance(), {}, distance * kilometre});
  }
  refused({}, {Luminance(), nan * deg, 30.0 * kilometre});
}

TEST(DarkSkyStability, GlowIsFiniteEverywhere) {
  for (const double height_km : {0.0, 0.5, 11.0, 49.9, 60.0, 400.0}) {
    for (const double distance_km : {1.0, 30.0, 300.0}) {
      const CityGlowPattern pattern(clear_medium(), height_km * kilometre, distance_km * kilometre);
      for (const double sine : {-1.0, -1.0e-9, 0.0, 1.0e-9, 0.01, 0.5, 1.0}) {
        for (const double azimuth : {0.0, 1.0e-6, 90.0, 180.0, 720.0}) {
          const double value = pattern.toward(sine, azimuth * deg);
          EXPECT_TRUE(std::isfinite(value) && value >= 0.0) << height_km << " km, " << distance_km << " km, " << sine;
        }
      }
      EXPECT_EQ(pattern.toward(-0.1, 0.0 * deg), 0.0);
    }
  }
}

} // namespace
} // namespace vesper
