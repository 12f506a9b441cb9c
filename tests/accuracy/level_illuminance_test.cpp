// Illuminance of a level surface from the sky's tables against the reference transport, measured light, and what the
// tables hold by other ways.
#include "vesper/atmosphere/level_illuminance.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/reference_transport.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/light/response_matrix.hpp"
#include "vesper/light/spectral_weights.hpp"
#include "vesper/light/sunlight.hpp"

#include "support/known_tables.hpp"
#include "support/measured_light.hpp"
#include "support/thorough.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

struct Case {
  std::string name;
  Medium medium;
  SkyTables tables;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> both = [] {
    std::vector<Case> made;
    made.push_back({"clear", clear_medium(), test::known_tables(clear_medium())});
    made.push_back({"published", published_medium(), test::known_tables(published_medium())});
    return made;
  }();
  return both;
}

Vec3 light_at(double altitude_deg) { return test::direction(0.0 * deg, altitude_deg * deg); }

TEST(LevelIlluminance, IsTheIntegralOfTheLuminance) {
  // A plain rule on a grid so fine that it needs no cleverness: the zenith's hemisphere in equal steps.
  const SkyTables& tables = cases()[0].tables;
  test::ErrorSum errors;
  for (const double height_km : {0.0, 12.0}) {
    for (const double light_deg : {89.0, 42.0, 5.0, -4.0}) {
      constexpr int altitudes = 250;
      constexpr int azimuths = 250;
      double sum = 0.0;
      for (int i = 0; i < altitudes; ++i) {
        // Half of the steps below the light's altitude, crowded around it.
        const double light = std::clamp(light_deg, 0.0, 90.0) * pi / 180.0;
        const double x = 2.0 * (i + 0.5) / altitudes - 1.0;
        const double altitude = x < 0.0 ? light - light * x * x : light + (pi / 2.0 - light) * x * x;
        const double step = (x < 0.0 ? -light : pi / 2.0 - light) * 2.0 * x * 2.0 / altitudes;
        for (int k = 0; k < azimuths; ++k) {
          const double y = (k + 0.5) / azimuths;
          const Vec3 view = test::direction(pi * y * y * rad, altitude * rad);
          const Xyzs seen = sky_luminance(tables, {height_km * kilometre, light_at(light_deg), 0.2666 * deg, view});
          sum += seen.y * std::sin(altitude) * std::cos(altitude) * step * 2.0 * (2.0 * pi * y / azimuths);
        }
      }
      errors.add(100.0 * (diffuse_illuminance(tables, height_km * kilometre, light_deg * deg).y / sum - 1.0));
    }
  }
  errors.hold("illuminance by scattered light against a fine grid of the tables' luminance", 0.1, "%");
}

TEST(LevelIlluminance, AtSeaLevelIsThatOfTheGround) {
  for (const Case& c : cases()) {
    test::ErrorSum errors;
    for (double light_deg = -18.0; light_deg <= 90.0; light_deg += 1.5) {
      const auto altitude = static_cast<float>(light_deg * pi / 180.0);
      const f32::vec4 ground = glm::exp2(f32::sky_ground_log2(line_sampler(c.tables.ground), altitude, c.tables.frame));
      const double by_sky = diffuse_illuminance(c.tables, 0.0 * metre, light_deg * deg).y;
      errors.add(100.0 * (by_sky / static_cast<double>(ground.y) - 1.0));
    }
    errors.hold(c.name + ": illuminance by the sky's luminance against that of the ground", 2.0, "%");
  }
}

TEST(LevelIlluminance, AgainstTheReference) {
  const std::vector all_lights_deg{75.0, 40.0, 15.0, 5.0, 1.0, 0.0, -2.0, -4.0, -6.0, -8.0, -10.0, -12.0};
  const std::vector few_lights_deg{40.0, 5.0, 0.0, -3.0, -6.0, -9.0, -12.0};
  const std::map<double, double> limits_percent{{0.0, 2.0}, {-6.0, 5.0}, {-12.0, 15.0}};
  for (const Case& c : cases()) {
    const ReferenceTransport transport(c.medium, c.medium.wavelengths_nm);
    const Spectrum& sun = solar_irradiance_1au();
    const Spectrum moon = moon_irradiance(0.0 * deg, moon_mean_distance, astronomical_unit);
    const SpectralFunctional sun_y = spectral_weights(sun, transport.wavelengths_nm()).y;
    const SpectralFunctional moon_y = spectral_weights(moon, transport.wavelengths_nm()).y;
    const double sun_lux = integrate_xyzs(sun).y;
    const double moon_lux = integrate_xyzs(moon).y;
    const Mat4 moon_from_sun = response_matrix(sun, moon);
    std::map<double, test::ErrorSum> sun_errors;
    std::map<double, test::ErrorSum> moon_errors;
    const bool full = test::thorough();
    for (const double height_km : full ? std::vector{0.0, 3.0, 20.0} : std::vector{c.name == "clear" ? 0.0 : 3.0}) {
      for (const double light_deg : full ? all_lights_deg : few_lights_deg) {
        const SkyQuery query{height_km * kilometre, light_at(light_deg), 0.2666 * deg, {0.0, 0.0, 1.0}};
        PathBudget budget;
        budget.relative_error = light_deg > -6.0 ? 0.003 : 0.01;
        const TransportResult diffuse = transport.diffuse_irradiance(query, {sun_y, moon_y}, budget);
        const std::vector<double> direct = transport.direct_irradiance(query);
        std::array<double, 2> reference{diffuse.functionals[0].mean, diffuse.functionals[1].mean};
        for (std::size_t l = 0; l < direct.size(); ++l) {
          reference[0] += sun_y[l] * direct[l];
          reference[1] += moon_y[l] * direct[l];
        }
        const Vec4 of_sunlight =
            vector_of(direct_illuminance(c.tables, query.height, light_deg * deg, query.light_angular_radius)) +
            vector_of(diffuse_illuminance(c.tables, query.height, light_deg * deg));
        const double sun_error = 100.0 * (sun_lux * of_sunlight.y / reference[0] - 1.0);
        const double moon_error = 100.0 * (moon_lux * (moon_from_sun * of_sunlight).y / reference[1] - 1.0);
        std::printf("%s, %.0f km, light at %5.1f: %10.4g lx, %+.2f %%; by the Moon %+.2f %%\n", c.name.c_str(),
                    height_km, light_deg, reference[0], sun_error, moon_error);
        const double group = light_deg >= 0.0 ? 0.0 : light_deg >= -6.0 ? -6.0 : -12.0;
        sun_errors[group].add(sun_error);
        moon_errors[group].add(moon_error);
      }
    }
    for (const auto& [lowest, limit] : limits_percent) {
      const std::string down = ", light down to " + std::to_string(static_cast<int>(lowest)) + " degrees";
      sun_errors[lowest].hold(c.name + ": illuminance by the Sun against the reference" + down, limit, "%");
      moon_errors[lowest].hold(c.name + ": illuminance by the full Moon against the reference" + down, limit, "%");
    }
  }
}

// Another day's air than ours: the limits are those of the reference transport's own test.
TEST(LevelIlluminance, AgainstTheCircularsFit) {
  const SkyTables& tables = cases()[0].tables;
  const CsvTable table = test::atmosphere_table("illuminance_clear_sky.csv");
  test::ErrorSum day;
  test::ErrorSum civil;
  test::ErrorSum nautical;
  test::ErrorSum moon;
  const Spectrum& sunlight = solar_irradiance_1au();
  const Spectrum moonlight = test::full_moon_without_surge();
  const Mat4 moon_from_sun = integrate_xyzs(moonlight).y * response_matrix(sunlight, moonlight);
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const test::TruthRow row(table, i);
    const double altitude = row.number("apparent_altitude_deg");
    const Angle airless = test::airless_altitude_deg(altitude) * deg;
    const Vec4 of_sunlight = vector_of(direct_illuminance(tables, 0.0 * metre, airless, mean_light_radius)) +
                             vector_of(diffuse_illuminance(tables, 0.0 * metre, airless));
    (altitude >= 0.0    ? day
     : altitude >= -8.0 ? civil
                        : nautical)
        .add(std::log10(integrate_xyzs(sunlight).y * of_sunlight.y / row.number("sun_lux")));
    if (altitude > 5.0) {
      moon.add(std::log10((moon_from_sun * of_sunlight).y / row.number("full_moon_lux")));
    }
  }
  day.hold("illuminance by the tables against the Circular's fit, Sun above 0 degrees", std::log10(1.4), "dex");
  civil.hold("illuminance by the tables against the Circular's fit, 0 to -8 degrees", std::log10(2.5), "dex");
  nautical.hold("illuminance by the tables against the Circular's fit, -8 to -12 degrees", std::log10(4.5), "dex");
  moon.hold("illuminance by the tables and the full Moon against the Circular's fit", std::log10(1.4), "dex");
}

} // namespace
} // namespace vesper
