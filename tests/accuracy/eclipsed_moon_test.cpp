// The eclipsed Moon against reference contacts and measured magnitudes.
#include "support/truth.hpp"
#include "support/umbra_edge.hpp"

#include "vesper/astro/constants.hpp"
#include "vesper/light/moonlight.hpp"
#include "vesper/sky/eclipse_light.hpp"
#include "vesper/sky/moon_illumination.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace vesper {
namespace {

using test::ErrorSum;
using test::TruthRow;

LunarEclipseState state_at(const Instant& instant) { return lunar_eclipse_state(apparent_sun_moon(instant.tt)); }

/// Where the umbra ends to the eye, at the Moon: the steepest fall of log Y.
double edge_km(const LunarEclipseState& state, const LunarEclipseTable& table) {
  const f64::EarthShadow shadow = earth_shadow(state);
  const double along = glm::dot(state.moon_km, state.axis);
  const Vec3 aside = glm::normalize(glm::cross(state.axis, Vec3(0.0, 0.0, 1.0)));
  const auto log_y = [&](double off) {
    return std::log10(
        f64::lunar_eclipse_shares(along * state.axis + off * aside, shadow, table.frame, table.sampler()).y);
  };
  const double airless = f64::earth_shadow_radii_km(along, f64::shadow_with_edge(shadow, f64::earth_radius_km)).x;
  return test::umbra_edge_km(airless, log_y);
}
double off_axis_km(const LunarEclipseState& state) {
  return glm::length(state.moon_km - glm::dot(state.moon_km, state.axis) * state.axis);
}

/// The distance from the axis of the limb's point that is nearest to it (farthest for the inner contacts).
double limb_km(const LunarEclipseState& state, bool inner) {
  const double radius = moon_radius_ratio * earth_equatorial_radius_km;
  return off_axis_km(state) + (inner ? radius : -radius);
}

struct ShadowContact {
  const char* name;
  bool inner;
};
constexpr std::array<ShadowContact, 4> umbral_contacts{{{"U1", false}, {"U2", true}, {"U3", true}, {"U4", false}}};
constexpr std::array<ShadowContact, 2> penumbral_contacts{{{"P1", false}, {"P4", false}}};

/// Seconds by which a circle about the axis meets the limb after (before: negative) a reference contact.
template <class RadiusKm> double late_s(const Instant& contact, bool inner, const RadiusKm& radius_km) {
  const double gap = limb_km(state_at(contact), inner) - radius_km(state_at(contact));
  const double speed =
      (limb_km(state_at(later(contact, 30.0)), inner) - limb_km(state_at(later(contact, -30.0)), inner)) / 60.0;
  return -gap / speed;
}

TEST(EclipsedMoon, TheUmbrasEdgeMeetsTheLimbAtTheContacts) {
  const CsvTable rows = test::truth_table("eclipses_lunar.csv");
  const Spectrum moonlight = moon_irradiance(1.0 * deg, moon_mean_distance, astronomical_unit);
  for (const double danjon : {0.0, 1.0, 2.5, 4.0}) {
    ErrorSum error;
    for (std::size_t i = 0; i < rows.row_count(); ++i) {
      const TruthRow row(rows, i);
      if (!row.in_table_years()) {
        continue;
      }
      const double magnitude = row.number("umb_mag_danjon");
      for (const ShadowContact& contact : umbral_contacts) {
        if (row.text(contact.name).empty() || std::abs(magnitude - (contact.inner ? 1.0 : 0.0)) <= 0.1) {
          continue;
        }
        error.add(late_s(row.instant_in(contact.name), contact.inner, [&](const LunarEclipseState& state) {
          return edge_km(state, lunar_eclipse_table(state, moonlight, {danjon, nullptr}));
        }));
      }
    }
    error.hold("edge of the umbra at the Moon's limb against U1 to U4, L = " + std::to_string(danjon).substr(0, 3),
               60.0, "s");
    EXPECT_GE(error.count(), 100U);
  }
}

TEST(EclipsedMoon, TheCheapTiersCirclesMeetTheLimbAtTheContacts) {
  const CsvTable rows = test::truth_table("eclipses_lunar.csv");
  ErrorSum umbra;
  ErrorSum penumbra;
  for (std::size_t i = 0; i < rows.row_count(); ++i) {
    const TruthRow row(rows, i);
    if (!row.in_table_years()) {
      continue;
    }
    const auto add = [&](ErrorSum& error, const ShadowContact& contact, const char* magnitude, double phase) {
      if (row.text(contact.name).empty() || std::abs(row.number(magnitude) - (contact.inner ? 1.0 : 0.0)) <= 0.1) {
        return;
      }
      error.add(late_s(row.instant_in(contact.name), contact.inner, [&](const LunarEclipseState& state) {
        // Where the colour map has a phase: by halving.
        const double along = glm::dot(state.moon_km, state.axis);
        double inside = 0.0;
        double outside = 2.0e4;
        while (outside - inside > 1.0e-6) {
          const double middle = 0.5 * (inside + outside);
          (f64::lunar_eclipse_phase({middle, along}, earth_shadow(state)) < phase ? inside : outside) = middle;
        }
        return inside;
      }));
    };
    for (const ShadowContact& contact : umbral_contacts) {
      add(umbra, contact, "umb_mag_danjon", 0.5);
    }
    for (const ShadowContact& contact : penumbral_contacts) {
      add(penumbra, contact, "pen_mag_danjon", 1.0 - 1.0e-12);
    }
  }
  umbra.hold("circle of the cheap tier's umbra at the Moon's limb against U1 to U4", 5.0, "s");
  penumbra.hold("circle of its penumbra against P1 and P4", 5.0, "s");
  EXPECT_GE(umbra.count(), 100U);
  EXPECT_GE(penumbra.count(), 100U);
}

/// Magnitudes in V that the Moon loses.
double dimming_mag(const Instant& greatest, double danjon) {
  return dimming_v_mag(sunlight_on_moon(state_at(greatest), {danjon, nullptr}));
}

TEST(EclipsedMoon, FallsByFourToSixPowersOfTen) {
  const CsvTable rows = test::truth_table("eclipses_lunar.csv");
  std::map<double, std::array<double, 4>> dimming; // least, most, sum, count
  for (std::size_t i = 0; i < rows.row_count(); ++i) {
    const TruthRow row(rows, i);
    if (row.number("umb_mag_danjon") < 1.1) {
      continue;
    }
    double before = 100.0;
    for (const double danjon : {0.0, 1.0, 2.0, 2.5, 3.0, 4.0}) {
      const double mag = dimming_mag(row.instant(), danjon);
      EXPECT_LT(mag, before) << "brighter with less dust";
      before = mag;
      auto [place, first] = dimming.try_emplace(danjon, std::array{100.0, 0.0, 0.0, 0.0});
      std::array<double, 4>& d = place->second;
      d = {std::min(d[0], mag), std::max(d[1], mag), d[2] + mag, d[3] + 1.0};
    }
  }
  for (const auto& [danjon, d] : dimming) {
    std::printf("L = %.1f: %.0f total eclipses of magnitude over 1.1 dim the Moon by 10^%.2f to 10^%.2f, mean 10^%.2f, "
                "V %.1f to %.1f\n",
                danjon, d[3], 0.4 * d[0], 0.4 * d[1], 0.4 * d[2] / d[3], d[0] - 12.73, d[1] - 12.73);
  }
  const auto mean = [&](double danjon) { return 0.4 * dimming[danjon][2] / dimming[danjon][3]; };
  EXPECT_NEAR(mean(4.0), 4.0, 0.4);
  EXPECT_NEAR(mean(0.0), 6.0, 0.4);
}

TEST(EclipsedMoon, HasMeasuredMagnitudes) {
  // Absolute photometry of the 9 February 1990 and 3 March 2007 (Hernitschek, Schmidt and Vollmer 2008, Appl. Opt. 47,
  // H62), thirteen observers of 28 October 2004 (Vital). All far from great eruptions: L of 2.5 to 4.
  struct Measured {
    const char* instant;
    double v;
  };
  ErrorSum outside;
  for (const Measured& eclipse :
       {Measured{"1990-02-09T19:11:00Z", -3.32}, {"2007-03-03T23:21:00Z", -1.70}, {"2004-10-28T03:04:00Z", -2.20}}) {
    SkyState sky = sky_state(parse_instant(eclipse.instant), {});
    const auto magnitude = [&](double danjon) {
      sky.eclipse_air.danjon = danjon;
      return moon_brightness(moonlight_of(sky), sky.moon.place.distance).v_magnitude;
    };
    const double dark = magnitude(2.5);
    const double bright = magnitude(4.0);
    std::printf("%s: V %.2f measured, %.2f for L = 2.5, %.2f for L = 4\n", eclipse.instant, eclipse.v, dark, bright);
    outside.add(std::max({eclipse.v - dark, bright - eclipse.v, 0.0}));
  }
  outside.hold("measured V of total eclipses outside of what L = 2.5 to 4 gives", 0.3, "mag");
  // 28 September 2015: 50 000 times fainter, L = 1.9 (Vital; Keen, 28 observers).
  ErrorSum error;
  error.add(dimming_mag(parse_instant("2015-09-28T02:47:00Z"), 1.9) - 2.5 * std::log10(5.0e4));
  error.hold("dimming of the Moon on 28 September 2015, L = 1.9, against 50 000 times", 0.3, "mag");
}

} // namespace
} // namespace vesper
