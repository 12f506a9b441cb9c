// The dark sky's own light against published figures, van Rhijn's function, and the one scene whose answer is known
// exactly: light that is the same from everywhere stays so behind air that absorbs nothing, over a white ground.
#include "vesper/assets/cube_texels.hpp"
#include "vesper/assets/sky_map.hpp"
#include "vesper/astro/frames.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/spread_light.hpp"
#include "vesper/base/csv.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/light/photometry.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/dark_sky.hpp"
#include "vesper/sky/milky_way.hpp"
#include "vesper/sky/zodiacal_light.hpp"

#include "support/known_tables.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace vesper {
namespace {

/// V of light with a spectrum's ratio of lux to V.
double v_of(double luminance_cd_m2, const Spectrum& spectrum) {
  const double ratio = lux_per_v_flux(spectrum) / lux_per_v_flux(planck_spectrum(star_temperature_k(0.0)));
  return v_per_arcsec2(luminance_cd_m2 * candela_per_m2, ratio);
}

/// Zodiacal light as the GPU reads it: linear between the map's texels.
Vec4 from_map(const Vec3& direction) {
  const ZodiacalMap& map = zodiacal_map();
  const Vec2 place = f64::zodiacal_place(direction) * Vec2(ZodiacalMap::columns - 1, ZodiacalMap::rows - 1);
  const auto i = std::min(static_cast<std::size_t>(place.x), std::size_t{ZodiacalMap::columns - 2});
  const auto j = std::min(static_cast<std::size_t>(place.y), std::size_t{ZodiacalMap::rows - 2});
  const auto row = [&](std::size_t k) {
    const std::size_t first = k * ZodiacalMap::columns + i;
    return glm::mix(map.texels[first], map.texels[first + 1], place.x - static_cast<double>(i));
  };
  return glm::mix(row(j), row(j + 1), place.y - static_cast<double>(j));
}

TEST(ZodiacalLight, IsThePublishedTable) {
  const std::string path = std::string(VESPER_TEST_DATA) + "/../../data/zodiacal_leinert_1998.csv";
  const CsvTable table(read_file(path), path);
  constexpr std::array latitudes{0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 45.0, 60.0, 75.0, 90.0};
  test::ErrorSum at_places;
  test::ErrorSum between;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    for (std::size_t j = 0; j < latitudes.size(); ++j) {
      const auto known = [&](std::size_t row, std::size_t column) { return !table.cell(row, column + 1).empty(); };
      const auto value = [&](std::size_t row, std::size_t column) { return table.number(row, column + 1); };
      if (!known(i, j)) {
        continue;
      }
      const double longitude = table.number(i, 0);
      const Vec3 place = test::direction(longitude * deg, latitudes.at(j) * deg);
      at_places.add(100.0 * (zodiacal_radiance_500nm(place) / value(i, j) - 1.0));
      if (i + 1 < table.row_count() && j + 1 < latitudes.size() && known(i + 1, j) && known(i, j + 1)) {
        // Between four values, whose geometric mean any smooth sky is near to.
        const double mean = std::pow(value(i, j) * value(i + 1, j) * value(i, j + 1) * value(i + 1, j + 1), 0.25);
        const Vec3 middle = test::direction(0.5 * (longitude + table.number(i + 1, 0)) * deg,
                                            0.5 * (latitudes.at(j) + latitudes.at(j + 1)) * deg);
        between.add(100.0 * (zodiacal_radiance_500nm(middle) / mean - 1.0));
      }
    }
  }
  at_places.hold("zodiacal light at the table's places", 0.01, "%");
  between.hold("zodiacal light halfway between them, from the table's means there", 10.0, "%");
}

TEST(ZodiacalLight, TheMapKeepsIt) {
  test::ErrorSum near;
  test::ErrorSum far;
  for (double longitude = 0.25; longitude < 180.0; longitude += 1.7) {
    for (double latitude = -89.9; latitude < 90.0; latitude += 1.3) {
      const Vec3 place = test::direction(longitude * deg, latitude * deg);
      const Vec4 wanted = zodiacal_luminance(place);
      for (int channel = 0; channel < 4; ++channel) {
        const bool is_near = f64::sun_elongation(place) < (15.0 * deg).to(rad);
        (is_near ? near : far).add(100.0 * (from_map(place)[channel] / wanted[channel] - 1.0));
      }
    }
  }
  near.hold("zodiacal light from the map within 15 degrees of the Sun", 1.0, "%");
  far.hold("zodiacal light from the map elsewhere", 0.3, "%");
}

TEST(ZodiacalLight, ShinesAsAnchorsSay) {
  test::ErrorSum errors;
  for (const auto& [elongation, v] :
       {std::pair(45.0, 20.6), std::pair(60.0, 21.3), std::pair(90.0, 22.1), std::pair(180.0, 22.2)}) {
    const double y = zodiacal_luminance(test::direction(elongation * deg, 0.0 * deg)).y;
    errors.add(v_of(y, zodiacal_spectrum(elongation < 90.0 ? 0.5 : 1.0)) - v);
  }
  errors.hold("zodiacal light in the ecliptic against rounded figures in V", 0.2, "mag/arcsec2");
}

TEST(ZodiacalLight, LeadsOnToTheCorona) {
  // Koutchmy and Lamy 1985: the dust's corona falls with r^-2.25 in the ecliptic and r^-2.47 over the poles.
  const auto slope = [](const Vec3& near, const Vec3& far, double ratio) {
    return std::log(zodiacal_radiance_500nm(near) / zodiacal_radiance_500nm(far)) / std::log(ratio);
  };
  test::ErrorSum errors;
  for (const double elongation : {1.0, 2.0, 4.0, 8.0}) {
    errors.add(
        slope(test::direction(elongation * deg, 0.0 * deg), test::direction(2.0 * elongation * deg, 0.0 * deg), 2.0) -
        2.25);
    errors.add(
        slope(test::direction(0.0 * deg, elongation * deg), test::direction(0.0 * deg, 2.0 * elongation * deg), 2.0) -
        2.47);
  }
  errors.hold("slope of the zodiacal light from 1 to 16 degrees from the Sun", 0.3, "");
}

TEST(Airglow, IsAsBrightAsMeasured) {
  const Vec4 unit = xyzs_of_s10(airglow_spectrum());
  const double minimum = v_of(airglow_s10(80.0) * unit.y, airglow_spectrum());
  const double maximum = v_of(airglow_s10(200.0) * unit.y, airglow_spectrum());
  std::printf("airglow: V %.3f at 80 sfu, %.3f at 200; its lines alone make V %.3f\n", minimum, maximum,
              v_of(integrate_xyzs(airglow_spectrum()).y, airglow_spectrum()));
  EXPECT_GT(minimum, 22.0);
  EXPECT_LT(minimum, 22.4);
  test::ErrorSum ratio;
  ratio.add(std::pow(10.0, 0.4 * (minimum - maximum)) - 2.0);
  ratio.hold("airglow at solar maximum over that at minimum, from twice", 0.2, "");
  test::ErrorSum lines;
  lines.add(v_of(integrate_xyzs(airglow_spectrum()).y, airglow_spectrum()) - minimum);
  lines.hold("level of the published lines and continuum from the level measured in V", 0.1, "mag");
}

TEST(Airglow, FollowsVanRhijn) {
  test::ErrorSum errors;
  for (double zenith_deg = 0.0; zenith_deg <= 90.0; zenith_deg += 2.0) {
    const double sine = std::sin((zenith_deg * deg).to(rad));
    const double ratio = 6371.0 / (6371.0 + 90.0) * sine;
    const Vec2 paths = f64::airglow_paths(std::cos((zenith_deg * deg).to(rad)), 0.0, 6371.0);
    EXPECT_EQ(paths.x, 0.0);
    errors.add(100.0 * (paths.y * std::sqrt(1.0 - ratio * ratio) - 1.0));
  }
  errors.hold("airglow from zenith to horizon, from van Rhijn's thin shell at 90 km", 0.2, "%");
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
      errors.add(100.0 * (sum - 1.0));
    }
  }
  errors.hold("light of a white world", 3.0, "%");
}

TEST(SpreadLight, LosesLessThanStarsDo) {
  // Noll et al. 2012 (A&A 543, A92, sec. 4.1) fit to single scattering over Paranal, to 60 degrees from the zenith: of
  // its optical depth the airglow keeps 1.669 log10 X - 0.146 by molecules, X van Rhijn's, and 1.732 log10 X - 0.318 by
  // aerosol. Ours scatter any number of times and over a ground that is not black.
  const Medium medium = clear_medium({0.05, 0.005, 1.3, 258.0, 0.1});
  const Length height = 2.64 * kilometre;
  const auto tables = std::make_shared<const SkyTables>(make_sky_tables(medium, {20, 16, 28, 40}));
  std::vector<Angle> views;
  for (const double zenith_deg : {0.0, 30.0, 45.0, 60.0, 70.0}) {
    views.push_back((90.0 - zenith_deg) * deg);
  }
  const SpreadLightViews scattered(tables, height, views);
  const RefractedColumns columns(medium, height, std::nullopt);
  DarkSky dark;
  dark.airglow = Vec4(1.0);
  const SpreadLight light =
      spread_light(scattered.lowest(), [&](const Vec3& at) { return airglow_above(dark, at.z).y; });
  test::ErrorSum errors;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double sine = std::sin(views[i].to(rad));
    const double above = airglow_above(dark, sine).y;
    const std::vector<double> km = columns.columns_km(sine);
    double molecules = 0.0;
    double aerosol = 0.0;
    double ozone = 0.0;
    for (std::size_t k = 0; k < km.size(); ++k) {
      const MediumComponent& part = medium.components[k];
      const double depth = part.extinction_per_km(550.0) * km[k];
      const bool scatters = part.scattering_per_km(550.0) > 0.0;
      (scatters ? (part.phase.kind == PhaseKind::rayleigh ? molecules : aerosol) : ozone) += depth;
    }
    const double published = std::exp(
        -((1.669 * std::log10(above) - 0.146) * molecules + (1.732 * std::log10(above) - 0.318) * aerosol + ozone));
    const double ours = std::exp(-(molecules + aerosol + ozone)) + scattered.luminance(i, 0.0 * deg, light).y / above;
    errors.add(100.0 * (ours / published - 1.0));
  }
  errors.hold("airglow through the air to 70 degrees from the zenith, from published fits", 5.0, "%");
}

/// A dark sky whose axes are those of the ICRS.
DarkSky milky_way_alone() { return {}; }

Vec3 icrs_of_galactic(double longitude_deg, double latitude_deg) {
  return glm::transpose(galactic_from_icrs()) * test::direction(longitude_deg * deg, latitude_deg * deg);
}

TEST(FaintStarlight, IsAsBrightAsPublished) {
  const DarkSky dark = milky_way_alone();
  const auto v = [&](double longitude_deg, double latitude_deg) {
    return v_of(faint_starlight(dark, icrs_of_galactic(longitude_deg, latitude_deg), starlight_field).y,
                faint_starlight_spectrum());
  };
  const double north = v(0.0, 90.0);
  const double south = v(0.0, -90.0);
  const double anticentre = v(180.0, 0.0);
  const double sagittarius = v(2.0, -3.5);
  std::printf("V mag/arcsec2 over 5 degrees: poles %.2f and %.2f, anticentre %.2f, Sagittarius %.2f\n", north, south,
              anticentre, sagittarius);
  EXPECT_GT(anticentre, 22.2);
  EXPECT_LT(anticentre, 23.0);
  EXPECT_GT(sagittarius, 20.0);
  EXPECT_LT(sagittarius, 20.8);
  test::ErrorSum poles;
  for (const double pole : {north, south}) {
    poles.add(pole - s10_v_per_arcsec2 + 2.5 * std::log10(30.0));
  }
  poles.hold("faint starlight at the galactic poles, from 30 S10", 0.1, "mag/arcsec2");
  // The mean of the whole sky with naked-eye stars is 105 (Allen 1973); these give some 25 of it.
  const double mean = sky_illuminance(default_sky_map())[1] / (4.0 * std::numbers::pi);
  test::ErrorSum all;
  all.add(mean / xyzs_of_s10(faint_starlight_spectrum()).y - 80.0);
  all.hold("mean of the sky's faint starlight, from 80", 20.0, "S10");
}

TEST(FaintStarlight, LightsTheAirAndTheGroundAsAllOfItsTexelsDo) {
  const CubePyramid& map = *default_milky_way();
  const CubePyramid::Level& fine = map.levels()[1];
  test::ErrorSum errors;
  for (const Vec3& zenith : {Vec3(0, 0, 1), Vec3(0, 0, -1), icrs_of_galactic(0.0, 0.0), icrs_of_galactic(90.0, 0.0),
                             icrs_of_galactic(180.0, 10.0), icrs_of_galactic(300.0, -40.0)}) {
    DarkSky dark;
    const Vec3 east = glm::normalize(glm::cross(Vec3(0.1, 0.7, 0.3), zenith));
    dark.icrs_from_horizon = Mat3(east, glm::cross(zenith, east), zenith);
    const SpreadLight light =
        spread_light(0.0 * deg, [&](const Vec3& at) { return faint_starlight(dark, at, spread_light_width).y; });
    double found = 0.0;
    for (const SpreadLight::Ring& ring : light.rings) {
      found += std::sin(ring.altitude.to(rad)) * ring.even;
    }
    double wanted = 0.0;
    for (std::size_t i = 0; i < cube_texel_count(fine.face_size); ++i) {
      const CubeTexel texel = cube_texel(fine.face_size, i);
      wanted += static_cast<double>(fine.texels[4 * i + 1]) * texel.solid_angle_sr *
                std::max(glm::dot(texel.direction, zenith), 0.0);
    }
    errors.add(100.0 * (found / wanted - 1.0));
  }
  errors.hold("faint starlight on the ground without air, by rings, from that of all texels", 3.0, "%");
}

TEST(DarkSky, TheZenithOfANaturalNight) {
  const Medium medium = clear_medium();
  const auto tables = std::make_shared<const SkyTables>(test::known_tables(medium));
  const SpreadLightViews scattered(tables, 0.0 * metre, {90.0 * deg});
  const DarkSkyAir air(medium, 0.0 * metre, std::nullopt);
  DarkSkyOptions minimum;
  minimum.solar_flux_sfu = 75.0;
  // Spring nights at new Moon: the Milky Way lies around the horizon.
  for (const char* stamp : {"2019-04-05T00:30:00Z", "2019-05-04T23:00:00Z", "2020-03-24T01:00:00Z"}) {
    const SkyState sky = sky_state(parse_instant(stamp), {35.0 * deg, 0.0 * deg, 0.0 * metre});
    ASSERT_LT(sky.moon.place.altitude.to(deg), -10.0);
    ASSERT_LT(sky.sun.altitude.to(deg), -18.0);
    const DarkSky dark = dark_sky(sky, minimum);
    const Vec3 zenith(0.0, 0.0, 1.0);
    const auto seen = [&](double direct, const std::function<double(const Vec3&)>& source) {
      return direct + scattered.luminance(0, 0.0 * deg, spread_light(scattered.lowest(), source)).y;
    };
    const double airglow = seen(air.airglow(dark, 1.0).y, [&](const Vec3& at) { return airglow_above(dark, at.z).y; });
    const double zodiacal = seen(air.zodiacal_share(1.0).y * zodiacal_light(dark, zenith).y,
                                 [&](const Vec3& at) { return zodiacal_light(dark, at).y; });
    const double stars = seen(air.starlight_share(1.0).y * faint_starlight(dark, zenith, starlight_field).y,
                              [&](const Vec3& at) { return faint_starlight(dark, at, spread_light_width).y; });
    const double all = airglow + zodiacal + stars;
    const double v = v_per_arcsec2(all * candela_per_m2);
    std::printf("%s: %.3g cd/m2, %.2f mag/arcsec2; airglow %.0f %%, zodiacal %.0f %%, stars %.0f %%\n", stamp, all, v,
                100.0 * airglow / all, 100.0 * zodiacal / all, 100.0 * stars / all);
    EXPECT_GT(v, 21.6) << stamp;
    EXPECT_LT(v, 22.0) << stamp;
    EXPECT_NEAR(airglow / all, 0.5, 0.12) << stamp;
  }
}

TEST(CityGlow, IsWhatThinAirScattersOfTheCitysLight) {
  // Air so thin that it dims nothing: the integral of density, phase function and Garstang's upward light over the
  // square of the distance from the city, by a plain rule.
  Medium medium = published_medium();
  medium.components.erase(medium.components.begin() + 1, medium.components.end());
  medium.components[0].scattering_per_km = constant_law(1.0e-7);
  medium.components[0].absorption_per_km = constant_law(0.0);
  const CityGlowPattern pattern(medium, 0.0 * metre, 30.0 * kilometre);
  const auto plain = [&](double altitude_deg, double azimuth_deg) {
    const Vec3 view = test::direction(azimuth_deg * deg, altitude_deg * deg);
    double sum = 0.0;
    for (double way = 0.01; way < 150.0; way += 0.02) {
      const Vec3 from_city = way * view - Vec3(30.0, 0.0, 0.0);
      const double height = way * view.z + way * way * (1.0 - view.z * view.z) / (2.0 * 6360.0);
      const double distance = std::hypot(from_city.x, from_city.y, height);
      const double from_zenith = std::acos(height / distance);
      const double upward = 2.0 * 0.15 * 0.85 * std::cos(from_zenith) + 0.554 * 0.15 * std::pow(from_zenith, 4.0);
      const double cosine = -(from_city.x * view.x + from_city.y * view.y + height * view.z) / distance;
      sum += height < 50.0 ? std::exp(-height / 8.0) * (1.0 + cosine * cosine) * upward / (distance * distance) : 0.0;
    }
    return sum;
  };
  test::ErrorSum errors;
  for (const double altitude : {75.0, 45.0, 25.0, 12.0}) {
    for (const double azimuth : {0.0, 60.0, 120.0, 180.0}) {
      const double wanted = plain(altitude, azimuth) / plain(90.0, 0.0);
      errors.add(100.0 * (pattern.toward(std::sin((altitude * deg).to(rad)), azimuth * deg) / wanted - 1.0));
    }
  }
  // A city is no point: 2 km of radius take some of the peak above it.
  errors.hold("sky glow over the zenith's in thin air, from a plain rule", 8.0, "%");
}

} // namespace
} // namespace vesper
