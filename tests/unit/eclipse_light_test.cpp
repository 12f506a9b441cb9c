// What eclipses leave of the light of Sun and Moon.
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/base/error.hpp"
#include "vesper/light/response_functions.hpp"
#include "vesper/light/sunlight.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/sky_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesper {
namespace {

TEST(EclipseLight, OfAUniformDiscIsTheAreaSeen) {
  for (const double other : {0.2, 0.95, 1.0, 1.04, 3.7}) {
    for (double separation = 0.0; separation < 5.0; separation += 0.037) {
      EXPECT_NEAR(sunlight_seen(1.0, other, separation, {0.0, 0.2})[0], 1.0 - f64::disc_covered(1.0, other, separation),
                  2.0e-6)
          << other << " at " << separation;
    }
  }
}

TEST(EclipseLight, IsThatOfTheRingOfAnAnnularEclipse) {
  // Of a darkened disc the part outside a central circle of radius r has (1 - r^2)^(1 + a/2) of the light.
  for (const double r : {0.3, 0.9, 0.97}) {
    const LimbPowers powers{0.0, 0.2};
    const LimbSeries seen = sunlight_seen(1.0, r, 0.0, powers);
    for (std::size_t k = 0; k < limb_terms; ++k) {
      EXPECT_NEAR(seen.at(k), std::pow(1.0 - r * r, 1.0 + 0.5 * powers[k]), 1.0e-6);
    }
  }
}

TEST(EclipseLight, ASmallDiscHidesThePlaceItStandsBefore) {
  // (1 + a/2) mu^a of the mean brightness at distance sqrt(1 - mu^2) from the centre.
  constexpr double small = 1.0e-2;
  const LimbPowers powers{0.4, 0.05};
  for (const double place : {0.0, 0.3, 0.6, 0.9}) {
    const LimbSeries seen = sunlight_seen(1.0, small, place, powers);
    for (std::size_t k = 0; k < limb_terms; ++k) {
      const double a = powers[k];
      const double hidden = (1.0 + 0.5 * a) * std::pow(1.0 - place * place, 0.5 * a) * small * small;
      EXPECT_NEAR(1.0 - seen.at(k), hidden, 1.0e-3 * hidden) << a << " at " << place;
    }
  }
}

TEST(EclipseLight, IsContinuousThroughContactsAndNeverRises) {
  const LimbPowers powers{0.503, 0.0};
  for (const double other : {0.94, 1.0, 1.05, 3.7}) {
    double before = sunlight_seen(1.0, other, 0.0, powers)[0];
    constexpr double step = 1.0e-3;
    for (double separation = step; separation < 1.1 + other; separation += step) {
      const double now = sunlight_seen(1.0, other, separation, powers)[0];
      EXPECT_GE(now, before - 2.0e-6);
      EXPECT_LT(now - before, 2.0 * step);
      before = now;
    }
    EXPECT_EQ(before, 1.0);
  }
  EXPECT_EQ(sunlight_seen(1.0, 1.05, 0.0499, powers)[0], 0.0);
}

double lux_of(const Observer& observer, const std::string& time, const std::string& name) {
  for (const SkyLight& light : lights_of(sky_state(parse_instant(time), observer))) {
    if (light.name == name) {
      return integrate_xyzs(light.irradiance).y;
    }
  }
  return 0.0;
}

TEST(EclipseLight, TheSunOverBurgosOnTheTwelfthOfAugust2026) {
  const Observer burgos{42.34 * deg, -3.70 * deg, 860.0 * metre};
  const double before = lux_of(burgos, "2026-08-12T17:20:00Z", "sun");
  const double corona = lux_of(burgos, "2026-08-12T18:29:30Z", "sun");
  EXPECT_GT(corona, 0.05) << "totality: a third of the full Moon or so";
  EXPECT_LT(corona, 0.2);
  EXPECT_NEAR(before, 133.3e3 / (1.0134 * 1.0134), 500.0);
  // Half an hour before it much of the disc is covered, less of its light than of its area is not.
  const SkyState partial = sky_state(parse_instant("2026-08-12T18:00:00Z"), burgos);
  const double share = lux_of(burgos, "2026-08-12T18:00:00Z", "sun") / before;
  EXPECT_NEAR(share, 1.0 - partial.solar_eclipse.obscuration, 0.08);
  EXPECT_NE(share, 1.0 - partial.solar_eclipse.obscuration);
  // The limb is redder than the disc: so is what a thin crescent gives.
  const SkyState late = sky_state(parse_instant("2026-08-12T18:26:00Z"), burgos);
  const Spectrum crescent = sunlight_past_moon(late.solar_eclipse);
  EXPECT_GT(crescent(650.0), 1.1 * crescent(450.0));
}

TEST(EclipseLight, TheMoonOnTheThirdOfMarch2026) {
  const Observer honolulu{21.31 * deg, -157.86 * deg, 0.0 * metre};
  const double full = lux_of(honolulu, "2026-03-03T08:20:00Z", "moon"); // P1 is at 8:44
  EXPECT_GT(full, 0.2);
  const double in_penumbra = lux_of(honolulu, "2026-03-03T09:40:00Z", "moon");
  EXPECT_LT(in_penumbra, 0.95 * full);
  EXPECT_GT(in_penumbra, 0.3 * full);
  const double total = lux_of(honolulu, "2026-03-03T11:34:00Z", "moon");
  EXPECT_GT(full / total, 1.0e4);
  EXPECT_LT(full / total, 1.0e5) << "no eruption has clouded the air";
  const SkyState sky = sky_state(parse_instant("2026-03-03T11:34:00Z"), honolulu);
  const Spectrum copper = sunlight_on_moon(sky.lunar_eclipse);
  EXPECT_GT(copper(650.0), 2.0 * copper(450.0));
  // Through all contacts nothing jumps.
  double last = full;
  for (int minute = 25; minute < 180; ++minute) {
    const SkyState now = sky_state(parse_instant("JD" + std::to_string(2461102.847222 + minute / 1440.0)), honolulu);
    const double share = sunlight_on_moon(now.lunar_eclipse)(550.0);
    if (minute > 25) {
      EXPECT_LT(std::abs(share - last), 0.03) << minute;
    }
    last = share;
  }
}

TEST(EclipseLight, TheCheapTiersCirclesAreThoseOfTheContacts) {
  const SkyState sky = sky_state(parse_instant("2026-03-03T11:34:00Z"), {});
  const f64::EarthShadow shadow = earth_shadow(sky.lunar_eclipse);
  const double along = glm::dot(sky.lunar_eclipse.moon_km, sky.lunar_eclipse.axis);
  const Vec2 radii = f64::earth_shadow_radii_km(along, shadow);
  EXPECT_EQ(f64::lunar_eclipse_phase({0.0, along}, shadow), 0.0);
  EXPECT_DOUBLE_EQ(f64::lunar_eclipse_phase({radii.x, along}, shadow), 0.5);
  EXPECT_EQ(f64::lunar_eclipse_phase({radii.y, along}, shadow), 1.0);
  EXPECT_EQ(f64::lunar_eclipse_colors(1.0), f64::vec4(1.0));
  EXPECT_EQ(f64::lunar_eclipse_phase({2.0 * radii.y, along}, shadow), 1.0);
  // As seen from the Earth they are the radii of the state, with which contacts are found: within 5 s of the Moon's
  // way.
  constexpr Angle way_in_5_s = 5.0 * 0.5 * arcsec;
  EXPECT_NEAR(std::atan(radii.x / along), sky.lunar_eclipse.umbra_radius.to(rad), way_in_5_s.to(rad));
  EXPECT_NEAR(std::atan(radii.y / along), sky.lunar_eclipse.penumbra_radius.to(rad), way_in_5_s.to(rad));
  // It dims the Moon as a whole about as much as the default does.
  const double cheap = dimming_v_mag(sunlight_on_moon(sky.lunar_eclipse, {}, Tier::cheap));
  EXPECT_NEAR(cheap, dimming_v_mag(sunlight_on_moon(sky.lunar_eclipse)), 0.5);
}

TEST(EclipseLight, ItsTableIsThatOfTheTier) {
  const Spectrum& light = solar_irradiance_1au();
  const SkyState total = sky_state(parse_instant("2026-03-03T11:34:00Z"), {});
  const SkyState none = sky_state(parse_instant("2026-03-10T11:34:00Z"), {});
  EXPECT_EQ(lunar_eclipse_table(none.lunar_eclipse, light).frame.kind, f64::lunar_eclipse_none);
  EXPECT_EQ(lunar_eclipse_table(total.lunar_eclipse, light, {}, Tier::cheap).frame.kind, f64::lunar_eclipse_published);
  const LunarEclipseTable table = lunar_eclipse_table(total.lunar_eclipse, light);
  EXPECT_EQ(table.frame.kind, f64::lunar_eclipse_table);
  EXPECT_EQ(table.texels.size(), static_cast<std::size_t>(table.frame.columns * table.frame.rows));
  EXPECT_THROW(static_cast<void>(lunar_eclipse_table(total.lunar_eclipse, light, {4.5, nullptr})), Error);
  EXPECT_THROW(static_cast<void>(sunlight_on_moon(total.lunar_eclipse, {std::nan(""), nullptr})), Error);
  // Its mean over the disc is the light that the sky is lit with.
  const double whole = dimming_v_mag(sunlight_on_moon(total.lunar_eclipse));
  EXPECT_NEAR(seen_danjon(whole), 0.8 * (15.0 - whole), 1.0e-12);
  EXPECT_EQ(seen_danjon(30.0), 0.0);
  EXPECT_EQ(seen_danjon(1.0), 4.0);
}

TEST(EclipseLight, AMediumOfOnesOwnMakesAnEclipseOfItsOwn) {
  ClearAir thick;
  thick.aerosol_optical_depth = 0.5;
  thick.stratospheric_optical_depth = 0.1;
  const auto map = std::make_shared<const EarthShadowLight>(make_earth_shadow_light(clear_medium(thick)));
  const LunarEclipseState eclipse = sky_state(parse_instant("2026-03-03T11:34:00Z"), {}).lunar_eclipse;
  EXPECT_GT(dimming_v_mag(sunlight_on_moon(eclipse, {2.5, map})), 1.0 + dimming_v_mag(sunlight_on_moon(eclipse)));
}

} // namespace
} // namespace vesper
