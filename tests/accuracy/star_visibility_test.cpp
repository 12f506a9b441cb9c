// Which stars are seen: thresholds against laboratory and published figures, limits of nights, moonlight and day, and the
// order in which stars come out at dusk.
#include "vesper/astro/calendar.hpp"
#include "vesper/atmosphere/medium_presets.hpp"
#include "vesper/atmosphere/transmittance.hpp"
#include "vesper/base/shader_math.hpp"
#include "vesper/light/night_light.hpp"
#include "vesper/light/star_color.hpp"
#include "vesper/sky/sky_background.hpp"
#include "vesper/sky/sky_light.hpp"
#include "vesper/sky/star_visibility.hpp"

#include "support/known_tables.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace vesper {
namespace {

double magnitude_at_the_eye(double threshold_lux) { return -2.5 * std::log10(threshold_lux / f64::zero_magnitude_lux); }

/// Background of a surface brightness as Crumey 2014 turns it into luminance (section 1.2).
double crumey_cd_m2(double mag_per_arcsec2) { return std::pow(10.0, 0.4 * (12.58 - mag_per_arcsec2)); }

TEST(ThresholdOfAPoint, FollowsTouseyAndKoomenFromNightToDay) {
  // Tousey and Koomen 1953 (JOSA 43, 177), table I: decimal logarithms of candles per square foot and of foot-candles,
  // for a field factor of 2.
  struct Row {
    double background, threshold;
  };
  constexpr std::array rows{Row{2.5, -5.21},  Row{1.5, -6.07},  Row{0.5, -6.88},  Row{-0.5, -7.63},
                            Row{-1.5, -8.22}, Row{-2.5, -8.58}, Row{-3.5, -8.65}, Row{-4.5, -9.01}};
  constexpr double per_square_foot = 10.763910417;
  test::ErrorSum errors;
  for (const Row& row : rows) {
    const double found =
        f64::threshold_illuminance_lux(per_square_foot * std::pow(10.0, row.background), 2.0) / per_square_foot;
    errors.add(2.5 * (std::log10(found) - row.threshold));
  }
  errors.hold("threshold of a point against Tousey and Koomen 1953, 3e-4 to 3e3 cd/m2", 0.1, "mag");
}

TEST(ThresholdOfAPoint, IsWhatCrumeyQuotes) {
  test::ErrorSum errors;
  const auto limit = [](double cd_m2, double factor) {
    return magnitude_at_the_eye(f64::threshold_illuminance_lux(cd_m2, factor));
  };
  errors.add(limit(crumey_cd_m2(21.83), 1.0) - 6.93); // section 3.1
  errors.add(limit(crumey_cd_m2(21.83), 2.0) - 6.18);
  errors.add(magnitude_at_the_eye(f64::threshold_illuminance_lux(0.0, 1.0)) - magnitude_at_the_eye(1.150e-9)); // eq. 71
  for (const double mu : {20.0, 20.5, 21.0, 21.5, 22.0}) {
    errors.add(limit(crumey_cd_m2(mu), 1.7) - (0.3834 * mu - 1.44 - 2.5 * std::log10(1.7))); // eq. 54
  }
  errors.hold("limiting magnitude against Crumey's own figures and his equation 54", 0.04, "mag");
}

TEST(MesopicShare, IsThatOfTheWorkedExamples) {
  // CIE TN 007:2017, section 5.1: 0.3 cd/m2 of S/P 1.8 and 2.5.
  test::ErrorSum shares;
  test::ErrorSum luminances;
  for (const auto& [ratio, share, luminance] : {std::array{1.8, 0.614, 0.348}, std::array{2.5, 0.629, 0.386}}) {
    const double found = f64::mesopic_cone_share(0.3, 0.3 * ratio);
    shares.add(found - share);
    luminances.add(f64::mesopic_luminance(0.3, 0.3 * ratio, found) - luminance);
  }
  shares.hold("cones' share of mesopic vision against CIE TN 007", 0.0007, "");
  luminances.hold("mesopic luminance against CIE TN 007", 0.0007, "cd/m2");
}

/// A sky over a place whose Sun and Moon can be put where they are wanted.
class Skies {
public:
  explicit Skies(const Medium& medium)
      : medium_(medium), tables_(std::make_shared<const SkyTables>(test::known_tables(medium))),
        air_(medium, Length(), std::nullopt),
        // New Moon; the galaxy's pole stands high.
        sky_(sky_state(parse_instant("2026-04-17T20:00:00Z"), {40.0 * deg, 0.0 * deg, 0.0 * metre})) {
    put_moon(-90.0 * deg);
    put_sun(-60.0 * deg);
  }

  void put_sun(Angle altitude) {
    sky_.sun.altitude = altitude;
    sky_.sun.direction_horizon = test::direction(Angle(), altitude); // in the east
  }
  void put_moon(Angle altitude) { sky_.moon.place.direction_horizon = test::direction(Angle(), altitude); }
  /// \param phase_angle of the Moon
  void put_full_moon(Angle altitude) {
    const Instant full = parse_instant("2026-01-03T10:03:00Z");
    sky_ = sky_state(full, {40.0 * deg, 180.0 * deg, 0.0 * metre});
    put_sun(-60.0 * deg);
    put_moon(altitude);
  }

  [[nodiscard]] SkyBackground background(const Horizontal& place) const {
    return sky_backgrounds(sky_, medium_, tables_, {}, {place})[0];
  }
  /// \param azimuth from the Sun's
  [[nodiscard]] double limit(Angle altitude, Angle azimuth, double field_factor = f64::default_field_factor) const {
    return limiting_magnitude(background({90.0 * deg + azimuth, altitude}).sum(),
                              usual_star(air_.starlight_share(std::sin(altitude.to(rad)))), field_factor);
  }
  [[nodiscard]] double zenith_limit() const { return limit(90.0 * deg, Angle()); }

  /// Depression of the Sun at which a star is first seen.
  [[nodiscard]] double first_seen_deg(double magnitude, Angle altitude, Angle azimuth,
                                      double field_factor = f64::default_field_factor) {
    double day = -15.0;
    double night = 18.0;
    for (int i = 0; i < 12; ++i) {
      const double middle = 0.5 * (day + night);
      put_sun(-middle * deg);
      (limit(altitude, azimuth, field_factor) >= magnitude ? night : day) = middle;
    }
    return 0.5 * (day + night);
  }

private:
  Medium medium_;
  std::shared_ptr<const SkyTables> tables_;
  DarkSkyAir air_;
  SkyState sky_;
};

TEST(LimitingMagnitude, OfNightMoonlightAndNoon) {
  for (const auto& [name, medium] : {std::pair(std::string("clear"), clear_medium())}) {
    Skies skies(medium);
    const SkyBackground dark = skies.background({Angle(), 90.0 * deg});
    const double mu = v_per_arcsec2(dark.sum().y * candela_per_m2);
    std::printf("%s: dark zenith %.2f mag/arcsec2 S/P %.2f limit %.2f\n", name.c_str(), mu, dark.sum().w / dark.sum().y,
                skies.zenith_limit());
    for (const double altitude : {60.0, 45.0, 30.0}) {
      skies.put_sun(altitude * deg);
      const Vec4 day = skies.background({Angle(), 90.0 * deg}).sum();
      std::printf("%s: Sun %.0f zenith %.3g cd/m2 limit %.2f\n", name.c_str(), altitude, day.y, skies.zenith_limit());
    }
    skies.put_full_moon(45.0 * deg);
    const Vec4 moonlit = skies.background({Angle(), 90.0 * deg}).sum();
    std::printf("%s: Moon: zenith %.3g cd/m2 S/P %.2f limit %.2f; 45 deg away at 45 deg %.2f, toward %.2f\n", name.c_str(), moonlit.y,
                moonlit.w / moonlit.y, skies.zenith_limit(), skies.limit(45.0 * deg, 90.0 * deg), skies.limit(45.0 * deg, 20.0 * deg));
  }
}

TEST(OrderOfAppearance, Explore) {
  Skies skies(clear_medium());
  for (const double factor : {1.0, 1.7}) {
    for (const double m : {-3.9, -2.0, -1.46, 0.03, 1.0, 2.0, 3.0}) {
      double best = 99.0;
      double at = 0.0;
      for (const double h : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0}) {
        const double d = skies.first_seen_deg(m, h * deg, 0.0 * deg, factor);
        if (h + d < best) { best = h + d; at = h; }
      }
      std::printf("F %.1f m %.2f AV %.1f at %.0f, formula %.1f\n", factor, m, best, at, 10.5 + 1.4 * m);
    }
  }
  for (const double d : {-3.0, 0.0, 0.83, 3.0, 6.0, 9.0, 12.0}) {
    skies.put_sun(-d * deg);
    std::printf("d %.1f zenith %.3g: ", d, skies.background({0.0 * deg, 90.0 * deg}).sum().y);
    for (const double az : {0.0, 90.0, 180.0}) for (const double h : {5.0, 10.0, 20.0, 45.0}) std::printf(" %.1f", skies.limit(h * deg, az * deg));
    std::printf(" %.1f\n", skies.zenith_limit());
  }
}

TEST(OrderOfAppearance, Dusk) {
  Skies skies(clear_medium());
  for (const double factor : {0.5, 1.0, 1.7, 2.4}) {
    for (const double altitude : {90.0, 60.0, 30.0}) {
      std::printf("F %.1f alt %.0f:", factor, altitude);
      for (const double m : {-4.4, -2.7, -1.46, 0.03, 1.0, 2.0, 3.0, 4.0, 5.0}) {
        std::printf(" %.1f", skies.first_seen_deg(m, altitude * deg, 90.0 * deg, factor));
      }
      std::puts("");
    }
  }
}

} // namespace
} // namespace vesper
