// The dark sky's own light against published figures, van Rhijn's function, and the one scene whose answer is known
// exactly: light that is the same from everywhere stays so behind air that absorbs nothing, over a white ground.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/zodiacal_light.hpp"

#include "support/known_tables.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace vesper {
namespace {

using std::numbers::pi;

/// V of light with a spectrum's ratio of lux to V.
double v_of(double luminance_cd_m2, const Spectrum& spectrum) {
  const double ratio = lux_per_v_flux(spectrum) / lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  return v_per_arcsec2(luminance_cd_m2 * candela_per_m2, ratio);
}

TEST(ZodiacalLight, IsTheTableAtItsPlaces) {
  const std::string path = std::string(VESPER_TEST_DATA) + "/../../data/zodiacal_leinert_1998.csv";
  const CsvTable table(read_file(path), path);
  constexpr std::array latitudes{0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 45.0, 60.0, 75.0, 90.0};
  test::ErrorSum errors;
  test::ErrorSum of_map;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    for (std::size_t j = 0; j < latitudes.size(); ++j) {
      if (!table.cell(i, j + 1).empty()) {
        const Vec3 place = test::direction(table.number(i, 0) * deg, latitudes.at(j) * deg);
        errors.add(100.0 * (zodiacal_radiance_500nm(place) / table.number(i, j + 1) - 1.0));
      }
    }
  }
  errors.hold("zodiacal light at the places of the table", 0.01, "%");
}

TEST(ZodiacalLight, ShinesAsMeasuredInV) {
  for (const auto& [elongation, v] : {std::pair(45.0, 20.6), std::pair(60.0, 21.3), std::pair(90.0, 22.1), std::pair(180.0, 22.2)}) {
    const double y = zodiacal_luminance(test::direction(elongation * deg, 0.0 * deg)).y;
    std::printf("%g: %.4g cd/m2, V %.3f (expected %.1f)\n", elongation, y, v_of(y, zodiacal_spectrum(elongation > 80 ? 1.0 : 0.5)), v);
  }
  for (double e : {1.0, 2.0, 4.0, 8.0, 12.0, 15.0, 18.0}) {
    std::printf("ecl %g: %.4g  pole-ward %.4g\n", e, zodiacal_radiance_500nm(test::direction(e * deg, 0.0 * deg)), zodiacal_radiance_500nm(test::direction(0.0 * deg, e*deg)));
  }
}

TEST(SpreadLight, IsTheSameFromEverywhereInAWhiteWorld) {
  Medium medium = published_medium();
  medium.ground_albedo = constant_law(1.0);
  std::erase_if(medium.components, [](const MediumComponent& part) { return !(part.scattering_per_km(550.0) > 0.0); });
  for (MediumComponent& part : medium.components) {
    part.absorption_per_km = constant_law(0.0);
  }
  const auto tables = std::make_shared<const SkyTables>(make_sky_tables(medium, {20, 16, 28, 40}));
  const LightThroughAir air(medium, solar_irradiance_1au());
  test::ErrorSum errors;
  for (const double height_km : {0.0, 3.0, 11.0}) {
    const RefractedColumns columns(medium, height_km * kilometre, std::nullopt);
    std::vector<Angle> views;
    for (const double altitude : {90.0, 60.0, 30.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.2}) {
      views.push_back(altitude * deg);
    }
    const SpreadLightViews scattered(tables, height_km * kilometre, views);
    const SpreadLight uniform = spread_light(scattered.lowest(), [](const Vec3&) { return 1.0; });
    for (std::size_t i = 0; i < views.size(); ++i) {
      const double direct = air.share(columns.columns_km(std::sin(views[i].to(rad)))).y;
      const double sum = direct + scattered.luminance(i, 0.0 * deg, uniform).y;
      std::printf("%g km, %g deg: %.4f = %.4f + scattered\n", height_km, views[i].to(deg), sum, direct);
      errors.add(100.0 * (sum - 1.0));
    }
  }
  errors.hold("light of a white world", 3.0, "%");
}

TEST(DarkSky, Numbers) {
  const double air80 = airglow_s10(80.0) * xyzs_of_s10(airglow_spectrum()).y;
  std::printf("airglow natural Y %.4g V %.3f; at 80: %.4g V %.3f\n", integrate_xyzs(airglow_spectrum()).y, v_of(integrate_xyzs(airglow_spectrum()).y, airglow_spectrum()), air80, v_of(air80, airglow_spectrum()));
  const Medium medium = clear_medium();
  const auto tables = std::make_shared<const SkyTables>(test::known_tables(medium));
  const SkyState state = sky_state(parse_instant("2019-12-27T00:00:00Z"), {40.0 * deg, 0.0 * deg, 0.0 * metre});
  std::printf("sun alt %g moon alt %g\n", state.sun.altitude.to(deg), state.moon.place.altitude.to(deg));
  const DarkSky dark = dark_sky(state);
  const DarkSkyAir air(medium, 0.0 * metre, std::nullopt);
  std::vector<Angle> views;
  for (double a : {90.0, 60.0, 45.0, 30.0, 20.0, 10.0, 5.0, 2.0, 0.5, -1.0, -30.0}) views.push_back(a * deg);
  const SpreadLightViews scatter(tables, 0.0 * metre, views);
  const SpreadLight uniform = spread_light(scatter.lowest(), [](const Vec3&) { return 1.0; });
  const SpreadLight glow = spread_light(scatter.lowest(), [&](const Vec3& d) { return airglow_above(dark, d.z).y; });
  const SpreadLight zodi = spread_light(scatter.lowest(), [&](const Vec3& d) { return zodiacal_light(dark, d).y; });
  const SpreadLight star = spread_light(scatter.lowest(), [&](const Vec3& d) { return faint_starlight(dark, d).y; });
  CityGlowPattern city(medium, 0.0 * metre, 30.0 * kilometre);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Vec3 d = test::direction(0.0 * deg, views[i]);
    const double s = std::sin(views[i].to(rad));
    std::printf("alt %5.1f airglow %.3g + %.3g zodi %.3g + %.3g star %.3g + %.3g; uniform scattered %.3f; city 0 %.3f 90 %.3f 180 %.3f mean %.3f\n", views[i].to(deg), air.airglow(dark, s).y,
                scatter.luminance(i, 90.0 * deg, glow).y, air.zodiacal(dark, d).y, scatter.luminance(i, 90.0 * deg, zodi).y, air.starlight(dark, d).y,
                scatter.luminance(i, 90.0 * deg, star).y, scatter.luminance(i, 0.0 * deg, uniform).y,
                city.toward(s, 0.0 * deg), city.toward(s, 90.0 * deg), city.toward(s, 180.0 * deg), city.around(s));
  }
}

} // namespace
} // namespace vesper
